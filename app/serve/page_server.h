#pragma once

#include <memory>

#include "app/serve/live_study.h"
#include "app/serve/request_check.h"

namespace pendular::app {

/// HTTP server of a study for browsers on this computer. It is bound to 127.0.0.1 and answers only
/// the requests that `check_request` lets pass.
class PageServer {
  public:
    /// Binds a port, and draws the token of the address.
    /// @param port 0: any free port
    /// @throws InputError where the port is taken or not permitted
    explicit PageServer(int port);
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;
    /// Ends the server, after requests that are being answered.
    ~PageServer();

    const ServerAddress& address() const;
    /// Begins to answer requests, in threads of the server. The study must outlive the server.
    void start(LiveStudy& study);

  private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace pendular::app
