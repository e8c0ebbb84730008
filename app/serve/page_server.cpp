#include "app/serve/page_server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <chrono>
#include <thread>

#include "app/serve/received_recording.h"
#include "data/input_error.h"
#include "reports/page/report_page.h"

namespace pendular::app {
namespace {

const char* const plain_text = "text/plain; charset=utf-8";

void set_answer(httplib::Response& response, const Answer& answer) {
    response.status = answer.status;
    response.set_content(answer.text, plain_text);
}

RequestHead head_of(const httplib::Request& request) {
    return {.method = request.method,
            .target = request.target,
            .host = request.get_header_value("Host"),
            .origin = request.get_header_value("Origin"),
            .token = request.get_header_value("X-Pendular-Token")};
}

httplib::Headers security_headers() {
    return {{"Content-Security-Policy", page_policy(true) + "; frame-ancestors 'none'"},
            {"X-Content-Type-Options", "nosniff"},
            {"X-Frame-Options", "DENY"},
            {"Referrer-Policy", "no-referrer"},
            {"Cross-Origin-Resource-Policy", "same-origin"},
            {"Cross-Origin-Opener-Policy", "same-origin"},
            {"Cache-Control", "no-store"}};
}

/// Content of a request, read up to the largest size of a recording; empty where it is larger or
/// breaks off, with the reason as the response.
std::optional<std::string> content_of(const httplib::ContentReader& read,
                                      httplib::Response& response) {
    std::string content;
    bool too_large = false;
    const bool complete = read([&](const char* bytes, std::size_t count) {
        too_large = content.size() + count > largest_received;
        if (!too_large) content.append(bytes, count);
        return !too_large;
    });
    if (complete) return content;
    if (too_large || response.status == 413)
        set_answer(response, {413, fmt::format("Recordings of at most {} MB are received; copy a "
                                               "larger one to the folder of the study.",
                                               largest_received >> 20)});
    else
        set_answer(response, {400, "The request broke off."});
    return std::nullopt;
}

Answer answer_change(const httplib::Request& request, LiveStudy& study) {
    const std::string action = request.get_param_value("action");
    if (action != "add" && action != "drop")
        return {400, "The parameter 'action' must be 'add' or 'drop'."};
    return study.change(action == "add" ? Action::add : Action::drop,
                        request.get_param_value("effect"));
}

}  // namespace

struct PageServer::Inside {
    httplib::Server server;
    ServerAddress address;
    std::jthread thread;

    Route route_of(const httplib::Request& request) const {
        return std::get<Route>(check_request(head_of(request), address));
    }
    void answer_get(const httplib::Request& request, httplib::Response& response,
                    const LiveStudy& study) const {
        if (route_of(request) == Route::page)
            response.set_content(*study.page(), "text/html; charset=utf-8");
        else
            response.set_content(study.state(), "application/json");
    }
    void answer_post(const httplib::Request& request, httplib::Response& response,
                     const httplib::ContentReader& read, LiveStudy& study) const {
        if (route_of(request) == Route::change)
            return set_answer(response, answer_change(request, study));
        if (request.is_multipart_form_data())
            return set_answer(response, {415, "Send the bytes of the file alone."});
        if (std::optional<std::string> content = content_of(read, response))
            set_answer(response,
                       study.receive(request.get_param_value("name"), std::move(*content)));
    }
};

PageServer::PageServer(int port) : inside_(std::make_unique<Inside>()) {
    httplib::Server& server = inside_->server;
    // Without SO_REUSEPORT, which would let two servers share a port.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    // One request for each connection, so that the content of a refused one is never read as
    // another.
    server.set_keep_alive_max_count(1);
    server.set_keep_alive_timeout(2);
    server.set_payload_max_length(largest_received);
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
    inside.server.set_pre_routing_handler([&inside](const auto& request, auto& response) {
        const auto checked = check_request(head_of(request), inside.address);
        const Refusal* const refusal = std::get_if<Refusal>(&checked);
        if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
        set_answer(response, {refusal->status, refusal->reason});
        return httplib::Server::HandlerResponse::Handled;
    });
    inside.server.set_exception_handler([](const auto&, auto& response, std::exception_ptr) {
        set_answer(response, {500, "Pendular failed to answer."});
    });
    inside.server.Get(".*", [&inside, &study](const auto& request, auto& response) {
        inside.answer_get(request, response, study);
    });
    inside.server.Post(
        ".*", [&inside, &study](const httplib::Request& request, httplib::Response& response,
                                const httplib::ContentReader& read) {
            inside.answer_post(request, response, read, study);
        });
    inside.thread = std::jthread([&inside] { inside.server.listen_after_bind(); });
    while (!inside.server.is_running())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace pendular::app
