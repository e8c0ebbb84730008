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

/// Functions that answer the requests of browsers for a study. Several threads may call one
/// function at the same time.
struct ServedStudy {
    /// Returns the page of the study, as HTML.
    std::function<std::shared_ptr<const std::string>()> page;
    /// Returns the state of the study (version of the page, progress and events), as JSON.
    std::function<std::string()> state;
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
