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
    /// Function that returns the page of the study, as HTML.
    std::function<std::shared_ptr<const std::string>()> page;
    /// Function that returns the version of the page, the progress of computations and recent
    /// events, as JSON.
    std::function<std::string()> state;
    /// Function that stores a recording in the study, given the name and the content of the
    /// recording's file. The function returns the HTTP status and the text for the browser.
    std::function<Answer(std::string name, std::string bytes)> receive;
    /// Function that adds a physical effect to the study's model or drops an effect. The function
    /// returns the HTTP status and the text for the browser.
    std::function<Answer(Action, const std::string& effect)> change;
};

/// Sets how a server answers requests. A function of `study` answers each request that
/// `check_request` accepts. The server refuses all other requests. Also limits the size of a
/// request to `largest_received` [bytes], and each connection to one request.
/// @param address address of the server; must outlive the server
void set_routes(httplib::Server& server, const ServerAddress& address, ServedStudy study);

}  // namespace pendular::app
