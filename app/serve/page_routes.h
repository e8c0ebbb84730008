#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/serve/received_recording.h"
#include "app/serve/request_check.h"
#include "workflow/study_change.h"

namespace httplib {
class Server;
}

namespace pendular::app {

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
