// Requests to the server of `pendular serve`, as bytes of a connection: only who knows the token
// gets an answer of the study, and a recording is stored in the study's folder or nowhere.
#include <algorithm>
#include <cstring>

#include "app/serve/page_routes.h"
#include "app/serve/received_recording.h"
#include "tests/fuzz/support.h"

// Defines macros, one of which is a name in Eigen.
#include <httplib.h>

using namespace pendular;
using namespace pendular::app;

namespace {

const ServerAddress& address() {
    static const ServerAddress known{.port = 8000, .token = "5ec4e7"};
    return known;
}

/// Connection whose requests are the bytes of the input; answers are dropped.
class Connection : public httplib::Stream {
  public:
    explicit Connection(std::string_view received) : rest_(received) {}
    bool is_readable() const override { return !rest_.empty(); }
    bool is_writable() const override { return true; }
    ssize_t read(char* to, std::size_t most) override {
        const std::size_t count = std::min(most, rest_.size());
        std::memcpy(to, rest_.data(), count);
        rest_.remove_prefix(count);
        return static_cast<ssize_t>(count);
    }
    ssize_t write(const char*, std::size_t count) override { return static_cast<ssize_t>(count); }
    void get_remote_ip_and_port(std::string& ip, int& port) const override { own(ip, port); }
    void get_local_ip_and_port(std::string& ip, int& port) const override { own(ip, port); }
    socket_t socket() const override { return -1; }

  private:
    static void own(std::string& ip, int& port) {
        ip = "127.0.0.1";
        port = address().port;
    }
    std::string_view rest_;
};

const std::filesystem::path& study_to_fill() {
    static const std::filesystem::path folder = [] {
        const auto made = fuzz::folder() / "study";
        std::filesystem::create_directories(made);
        fuzz::file_of("study/study.toml", "[[recording]]\nfile = \"*.csv\"\n");
        return made;
    }();
    return folder;
}

Answer store_and_remove(const std::string& name, const std::string& bytes) {
    const Answer answer = store_recording(study_to_fill(), name, bytes);
    // The name is one part of a path, so that this is a file of the study's folder.
    fuzz::demand((answer.status == 201) == std::filesystem::remove(study_to_fill() / name));
    return answer;
}

/// Server that answers the requests of one connection.
class Server : public httplib::Server {
  public:
    Server() {
        set_routes(*this, address(),
                   {.page = [this] { return asked(std::make_shared<const std::string>("page")); },
                    .state = [this] { return asked(std::string("{}")); },
                    .receive =
                        [this](const std::string& name, const std::string& bytes) {
                            return asked(store_and_remove(name, bytes));
                        },
                    .change = [this](Action, const std::string&) { return asked(Answer()); }});
    }
    /// Whether the study was asked for an answer.
    bool answers(std::string_view received) {
        asked_ = false;
        Connection connection(received);
        bool closed = false;
        process_request(connection, true, closed, nullptr);
        return asked_;
    }

  private:
    template <typename Value>
    Value asked(Value value) {
        asked_ = true;
        return value;
    }
    bool asked_ = false;
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Server server;
    const std::string_view text = fuzz::text_of(data, size);
    const bool told = server.answers(text);
    fuzz::demand(!told || (text.find(address().token) != std::string_view::npos &&
                           (text.find("127.0.0.1:8000") != std::string_view::npos ||
                            text.find("localhost:8000") != std::string_view::npos)));
    return 0;
}
