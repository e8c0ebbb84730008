#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "app/serve/received_recording.h"
#include "workflow/study_change.h"

namespace httplib {
class Server;
}  // namespace httplib

namespace pendular::app {

/// Parts of an HTTP request by which a server decides whether to answer. A header that the request
/// lacks is empty.
struct RequestHead {
    std::string method;  ///< such as GET or POST
    std::string target;  ///< path and query as they were sent, such as "/TOKEN/state"
    std::string host;    ///< header Host
    std::string origin;  ///< header Origin
    std::string token;   ///< header X-Pendular-Token
};

/// Address of a server on this computer: http://127.0.0.1:PORT/TOKEN/.
struct ServerAddress {
    int port = 0;
    std::string token;  ///< random secret, known only to a user who was given the address

    std::string text() const;
};

/// Pages and actions that a browser can request from the server of a study.
enum class Route {
    page,       ///< GET /TOKEN/: the page of the study
    state,      ///< GET /TOKEN/state: version of the page, progress and events, as JSON
    recording,  ///< POST /TOKEN/recording: stores a recording in the study
    change      ///< POST /TOKEN/change: adds an effect to the study or drops an effect
};

/// Answer to a request that the server does not accept.
struct Refusal {
    int status = 403;
    std::string reason;
};

/// Returns the page or action that an HTTP request asks for, or a refusal. The checks keep out
/// foreign web sites in the user's browser, including sites that use DNS rebinding. The path of
/// every request must contain the token of `address`. A POST must also state the token in the
/// header X-Pendular-Token. A refusal has the HTTP status
/// - 403 for a header Host or Origin other than the server's address, or for a wrong token,
/// - 405 for a method that is neither GET nor POST,
/// - 400 for a path with "..", "%" or "\",
/// - 404 for an unknown path.
std::variant<Route, Refusal> check_request(const RequestHead& request,
                                           const ServerAddress& address);

/// Whether two texts are equal. The computing time does not depend on where the texts differ, so
/// that measuring the time does not help to guess a secret.
bool equal_in_constant_time(std::string_view a, std::string_view b);

/// Returns a random secret of 256 bits from the operating system, as 64 hexadecimal digits.
/// @throws std::runtime_error if the system gives no random numbers
std::string new_token();

/// Functions that answer the requests of browsers for a study. Several threads may call one at the
/// same time.
struct ServedStudy {
    std::function<std::shared_ptr<const std::string>()> page;  ///< HTML
    std::function<std::string()> state;                        ///< `LiveStudy::state`
    /// Stores a recording in the study, given the name and the content of its file.
    std::function<Answer(std::string name, std::string bytes)> receive;
    /// Adds an effect to the study's model or drops it.
    std::function<Answer(Action, const std::string& effect)> change;
};

/// Makes a server answer each request that `check_request` accepts by a function of `study`, and
/// refuse all others. Also limits the size of a request to `largest_received` [bytes].
/// @param address address of the server; must outlive the server
void set_routes(httplib::Server& server, const ServerAddress& address, ServedStudy study);

}  // namespace pendular::app
