#include "app/serve/page_routes.h"

#include <fmt/format.h>
#include <httplib.h>

#include <optional>
#include <utility>

#include "app/serve/received_recording.h"

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

Answer answer_change(const httplib::Request& request, const ServedStudy& study) {
    const std::string action = request.get_param_value("action");
    if (action != "add" && action != "drop")
        return {400, "The parameter 'action' must be 'add' or 'drop'."};
    return study.change(action == "add" ? Action::add : Action::drop,
                        request.get_param_value("effect"));
}

void answer_get(Route route, httplib::Response& response, const ServedStudy& study) {
    if (route == Route::page)
        response.set_content(*study.page(), "text/html; charset=utf-8");
    else
        response.set_content(study.state(), "application/json");
}

void answer_post(Route route, const httplib::Request& request, httplib::Response& response,
                 const httplib::ContentReader& read, const ServedStudy& study) {
    if (route == Route::change) return set_answer(response, answer_change(request, study));
    if (request.is_multipart_form_data())
        return set_answer(response, {415, "Send the bytes of the file alone."});
    if (std::optional<std::string> content = content_of(read, response))
        set_answer(response, study.receive(request.get_param_value("name"), std::move(*content)));
}

}  // namespace

void set_routes(httplib::Server& server, const ServerAddress& address, ServedStudy study) {
    const auto served = std::make_shared<const ServedStudy>(std::move(study));
    const auto route_of = [&address](const httplib::Request& request) {
        return std::get<Route>(check_request(head_of(request), address));
    };
    server.set_payload_max_length(largest_received);
    server.set_pre_routing_handler([&address](const auto& request, auto& response) {
        const auto checked = check_request(head_of(request), address);
        const Refusal* const refusal = std::get_if<Refusal>(&checked);
        if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
        set_answer(response, {refusal->status, refusal->reason});
        return httplib::Server::HandlerResponse::Handled;
    });
    server.set_exception_handler([](const auto&, auto& response, const auto&) {
        set_answer(response, {500, "Pendular failed to answer."});
    });
    server.Get(".*", [route_of, served](const auto& request, auto& response) {
        answer_get(route_of(request), response, *served);
    });
    server.Post(".*",
                [route_of, served](const httplib::Request& request, httplib::Response& response,
                                   const httplib::ContentReader& read) {
                    answer_post(route_of(request), request, response, read, *served);
                });
}

}  // namespace pendular::app
