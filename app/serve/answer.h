#pragma once

#include <string>

namespace pendular::app {

/// Answer to a request of a browser: HTTP status, and text to show.
struct Answer {
    int status = 200;
    std::string text;

    bool ok() const { return status < 400; }
};

}  // namespace pendular::app
