#include "app/serve/bounded_server.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>

namespace pendular::app {
namespace {

using ServerClock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// Chosen: each client that sends slowly keeps one until its time is over.
constexpr int server_threads = 64;
/// Number of incomplete requests from which the server counts as crowded: a quarter of the threads
/// remains for others.
constexpr int crowded_from = 48;
/// Longest time for the head of a request. A browser on the same computer takes milliseconds.
constexpr std::chrono::milliseconds head_time = 2s, head_time_when_crowded = 100ms;
/// Longest time for the content of a request and for the answer; a recording of 64 MB takes a
/// second on the same computer.
constexpr auto content_time = 60s;
constexpr int waiting_connections = 1024;  ///< connections that wait to be accepted

/// Connection to a client whose reads and writes end by a deadline.
class DeadlineStream : public httplib::Stream {
  public:
    DeadlineStream(socket_t socket, const std::atomic<int>& reading_heads)
        : socket_(socket), reading_heads_(reading_heads) {}

    /// The head of the request is complete: from now on, content may be read and an answer sent.
    void begin_content() { content_from_ = ServerClock::now(); }

    bool is_readable() const override { return at_ < filled_ || ready(POLLIN, 0ms); }
    bool is_writable() const override { return ready(POLLOUT, 0ms); }
    ssize_t read(char* bytes, std::size_t count) override {
        if (at_ == filled_) {
            if (!wait(POLLIN)) return -1;
            const ssize_t got = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
            if (got <= 0) return got;
            at_ = 0, filled_ = static_cast<std::size_t>(got);
        }
        const std::size_t taken = std::min(count, filled_ - at_);
        std::memcpy(bytes, buffer_.data() + at_, taken);
        at_ += taken;
        return static_cast<ssize_t>(taken);
    }
    ssize_t write(const char* bytes, std::size_t count) override {
        if (!wait(POLLOUT)) return -1;
        return ::send(socket_, bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT);
    }
    void get_remote_ip_and_port(std::string& ip, int& port) const override {
        ip = "127.0.0.1", port = 0;
    }
    void get_local_ip_and_port(std::string& ip, int& port) const override {
        ip = "127.0.0.1", port = 0;
    }
    socket_t socket() const override { return socket_; }

  private:
    bool ready(short what, std::chrono::milliseconds time) const {
        pollfd wanted{.fd = socket_, .events = what, .revents = 0};
        return ::poll(&wanted, 1, static_cast<int>(time.count())) > 0;
    }
    bool over() const {
        if (content_from_ != ServerClock::time_point{})
            return ServerClock::now() - content_from_ > content_time;
        return ServerClock::now() - opened_ >
               (reading_heads_ > crowded_from ? head_time_when_crowded : head_time);
    }
    /// Waits until the connection can be read or written; false if the time ends before.
    bool wait(short what) const {
        while (!over())
            if (ready(what, 20ms)) return true;
        return false;
    }

    socket_t socket_;
    const std::atomic<int>& reading_heads_;
    const ServerClock::time_point opened_ = ServerClock::now();
    ServerClock::time_point content_from_{};
    std::array<char, 16384> buffer_{};
    std::size_t at_ = 0, filled_ = 0;
};

}  // namespace

BoundedServer::BoundedServer() {
    new_task_queue = [] { return new httplib::ThreadPool(server_threads); };
    // Without SO_REUSEPORT, which would let two servers share a port.
    set_socket_options([this](socket_t socket) {
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        listening_ = socket;
    });
}

int BoundedServer::bind(int port) {
    const int bound =
        port == 0 ? bind_to_any_port("127.0.0.1") : (bind_to_port("127.0.0.1", port) ? port : -1);
    // httplib lets five connections wait; a second call of listen changes that number.
    if (bound > 0) ::listen(listening_, waiting_connections);
    return bound;
}

bool BoundedServer::process_and_close_socket(socket_t socket) {
    bool answered = false;
    if (svr_sock_ != INVALID_SOCKET) {  // else the server stops
        DeadlineStream stream(socket, reading_heads_);
        ++reading_heads_;
        bool in_head = true, closed = false;
        answered = process_request(stream, true, closed, [&](httplib::Request& request) {
            --reading_heads_, in_head = false;
            stream.begin_content();
            request.ranges.clear();
        });
        if (in_head) --reading_heads_;
    }
    ::shutdown(socket, SHUT_RDWR);
    ::close(socket);
    return answered;
}

}  // namespace pendular::app
