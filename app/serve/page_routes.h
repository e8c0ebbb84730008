#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/serve/answer.h"
#include "app/serve/request_check.h"
#include "workflow/study_change.h"

namespace httplib {
class Server;
}

namespace pendular::app {

/// Functions that answer the requests of browsers on a study. Several threads call them at once.
struct ServedStudy {
    std::function<std::shared_ptr<const std::string>()> page;  ///< page of the study, HTML
    std::function<std::string()> state;                        ///< state of the study, JSON
    /// Stores a recording in the study, given the name and the content of its file, and returns the
    /// HTTP status and text for the browser.
    std::function<Answer(std::string name, std::string bytes)> receive;
    /// Adds an effect to the study or drops one, and returns the HTTP status and text for the
    /// browser.
    std::function<Answer(Action, const std::string& effect)> change;
};

/// Sets how a server answers requests: by the functions of `study` if `check_request` accepts the
/// request, else by a refusal. Also limits the size of a request to `largest_received` [bytes], and
/// each connection to one request.
/// @param address address of the server; must outlive the server
void set_routes(httplib::Server& server, const ServerAddress& address, ServedStudy study);

}  // namespace pendular::app
