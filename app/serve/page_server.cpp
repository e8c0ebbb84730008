#include "app/serve/page_server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <chrono>
#include <thread>

#include "app/serve/page_routes.h"
#include "data/input_error.h"
#include "reports/page/report_page.h"

namespace pendular::app {
namespace {

httplib::Headers security_headers() {
    return {{"Content-Security-Policy", page_policy(true) + "; frame-ancestors 'none'"},
            {"X-Content-Type-Options", "nosniff"},
            {"X-Frame-Options", "DENY"},
            {"Referrer-Policy", "no-referrer"},
            {"Cross-Origin-Resource-Policy", "same-origin"},
            {"Cross-Origin-Opener-Policy", "same-origin"},
            {"Cache-Control", "no-store"}};
}

}  // namespace

struct PageServer::Inside {
    httplib::Server server;
    ServerAddress address;
    std::jthread thread;
};

PageServer::PageServer(int port) : inside_(std::make_unique<Inside>()) {
    httplib::Server& server = inside_->server;
    // Without SO_REUSEPORT, which would let two servers share a port.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_default_headers(security_headers());
    if (port == 0) {
        inside_->address.port = server.bind_to_any_port("127.0.0.1");
    } else {
        inside_->address.port = server.bind_to_port("127.0.0.1", port) ? port : -1;
    }
    if (inside_->address.port < 0)
        throw InputError(fmt::format(
            "--port {}: another program uses this port, or it is not permitted; name another one, "
            "or leave --port out",
            port));
    inside_->address.token = new_token();
}

PageServer::~PageServer() {
    inside_->server.stop();
}

const ServerAddress& PageServer::address() const {
    return inside_->address;
}

void PageServer::start(LiveStudy& study) {
    Inside& inside = *inside_;
    set_routes(
        inside.server, inside.address,
        {.page = [&study] { return study.page(); },
         .state = [&study] { return study.state(); },
         .receive =
             [&study](std::string name, std::string bytes) {
                 return study.receive(std::move(name), std::move(bytes));
             },
         .change = [&study](Action action,
                            const std::string& effect) { return study.change(action, effect); }});
    inside.thread = std::jthread([&inside] { inside.server.listen_after_bind(); });
    while (!inside.server.is_running())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace pendular::app
