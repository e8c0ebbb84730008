#pragma once

#include <memory>

#include "app/serve/live_study.h"
#include "app/serve/page_routes.h"

namespace pendular::app {

/// HTTP server that shows the page of a study to browsers on this computer. The server is bound to
/// the address 127.0.0.1 and answers only requests that `check_request` accepts.
class PageServer {
  public:
    /// Binds a port of this computer, and chooses a random token, a secret part of the address.
    /// @param port 0: any free port
    /// @throws InputError if the port is taken or not permitted
    /// @throws std::runtime_error if the system gives no random numbers
    explicit PageServer(int port);
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;
    /// Stops the server once the requests in progress have been answered.
    ~PageServer();

    const ServerAddress& address() const;
    /// Starts to answer requests on a study, which must outlive the server, in threads of its own.
    void start(LiveStudy& study);

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace pendular::app
