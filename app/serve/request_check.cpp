#include "app/serve/request_check.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

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

}  // namespace pendular::app
