#pragma once

#include <string>

namespace pendular::app {

/// Answer to a request of a browser: the HTTP status, and a text that the page shows.
struct Answer {
    int status = 200;
    std::string text;

    bool ok() const { return status < 400; }
};

}  // namespace pendular::app
