#include "app/belief.h"

#include <fmt/format.h>

namespace pendular::app {

std::string verdict_on(const Belief& belief, const std::string& basis) {
    if (belief.believable()) return "; " + basis;
    return fmt::format("; do not use this value{}: {}",
                       belief.meaningless ? ", it is meaningless" : "", belief.reasons.front());
}

void print_doubts(Console& console, const Belief& belief) {
    for (const std::string& reason : belief.reasons) {
        console.line("doubt: " + reason);
    }
}

}  // namespace pendular::app
