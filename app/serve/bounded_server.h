#pragma once

#include <httplib.h>

#include <atomic>

namespace pendular::app {

/// HTTP server in which no connection can keep others waiting: a client that sends its request
/// slowly, or not at all, is disconnected after `head_time`, and after `head_time_when_crowded`
/// while most threads of the server wait for such clients. The server of httplib waits five seconds
/// for each byte, with eight threads, so that sixty idle connections stop it for everybody. Each
/// connection has one request, so that the content of a refused one is never read as another.
/// Requests of byte ranges are answered with the whole content, since many ranges that overlap
/// would multiply it.
class BoundedServer : public httplib::Server {
  public:
    BoundedServer();
    /// Binds a port of 127.0.0.1 and returns its number; -1 if the port is taken or not permitted.
    /// @param port port number; 0: any free port
    int bind(int port);

  private:
    bool process_and_close_socket(socket_t socket) override;

    std::atomic<int> reading_heads_{0};  ///< connections whose request is not complete
    std::atomic<socket_t> listening_{INVALID_SOCKET};
};

}  // namespace pendular::app
