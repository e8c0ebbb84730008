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

/// Answers to requests on a served study. Several threads call these functions at once.
struct ServedStudy {
    std::function<std::shared_ptr<const std::string>()> page;  ///< page of the study, HTML
    std::function<std::string()> state;                        ///< state of the study, JSON
    /// Stores a recording: name and content of the file.
    std::function<Answer(std::string name, std::string bytes)> receive;
    /// Adds an effect to the study or drops one.
    std::function<Answer(Action, const std::string& effect)> change;
};

/// Sets what a server answers: requests that `check_request` lets pass get the answers of `study`,
/// all others a refusal. Limits the size of requests to `largest_received` and each connection to
/// one request.
/// @param address address of the server; must outlive the server
void set_routes(httplib::Server& server, const ServerAddress& address, ServedStudy study);

}  // namespace pendular::app
