#include "app/serve/page_routes.h"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app/serve/received_recording.h"

namespace pendular::app {
namespace {

/// Path of a target, without its query.
std::string_view path_of(std::string_view target) {
    return target.substr(0, target.find('?'));
}

bool is_plain(std::string_view path) {
    return path.starts_with('/') && path.find("..") == std::string_view::npos &&
           path.find_first_of("%\\") == std::string_view::npos;
}

std::variant<Route, Refusal> route_of(const RequestHead& request, std::string_view rest) {
    const bool posts = request.method == "POST";
    if (rest.empty() && !posts) return Route::page;
    if (rest == "state" && !posts) return Route::state;
    if (rest == "recording" && posts) return Route::recording;
    if (rest == "change" && posts) return Route::change;
    return Refusal{404, "There is nothing at this address."};
}

}  // namespace

std::string ServerAddress::text() const {
    return fmt::format("http://127.0.0.1:{}/{}/", port, token);
}

bool equal_in_constant_time(std::string_view a, std::string_view b) {
    unsigned difference = a.size() == b.size() ? 0 : 1;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const char other = b.empty() ? '\0' : b[k % b.size()];
        difference |= static_cast<unsigned char>(a[k] ^ other);
    }
    return difference == 0;
}

std::string new_token() {
    std::array<unsigned char, 32> bytes = {};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
        throw std::runtime_error(
            fmt::format("the system gives no random numbers: {}", std::strerror(errno)));
    }
    std::string token;
    for (const unsigned char byte : bytes)
        token += fmt::format("{:02x}", byte);
    return token;
}

std::variant<Route, Refusal> check_request(const RequestHead& request,
                                           const ServerAddress& address) {
    const std::string own = fmt::format("127.0.0.1:{}", address.port);
    const std::string named = fmt::format("localhost:{}", address.port);
    if (request.host != own && request.host != named)
        return Refusal{403, "This server answers only to its own address."};
    if (!request.origin.empty() && request.origin != "http://" + request.host)
        return Refusal{403, "Requests from pages of other sites are refused."};
    if (request.method != "GET" && request.method != "POST")
        return Refusal{405, "Only GET and POST are answered."};
    const std::string_view path = path_of(request.target);
    if (!is_plain(path)) return Refusal{400, "The path is not one of this server."};
    const std::size_t end = std::min(path.find('/', 1), path.size());
    if (!equal_in_constant_time(path.substr(1, end - 1), address.token))
        return Refusal{403, "Open the address that 'pendular serve' printed: it ends in a token."};
    if (end == path.size()) return Refusal{404, "The address ends in '/'."};
    auto route = route_of(request, path.substr(end + 1));
    if (request.method == "POST" && !equal_in_constant_time(request.token, address.token))
        return Refusal{403, "A change needs the token in the header X-Pendular-Token."};
    return route;
}

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
