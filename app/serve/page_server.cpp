#include "app/serve/page_server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <chrono>
#include <thread>

#include "app/serve/bounded_server.h"
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
    BoundedServer server;
    ServerAddress address;
    std::jthread thread;
};

PageServer::PageServer(int port) : inside_(std::make_unique<Inside>()) {
    BoundedServer& server = inside_->server;
    server.set_default_headers(security_headers());
    inside_->address.port = server.bind(port);
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
