#include "app/belief.h"

#include <fmt/format.h>

#include "app/progress.h"

namespace pendular::app {

std::string warning_on(const Belief& belief, const std::string& what) {
    if (belief.believable()) return "";
    return fmt::format("Do not use {}{}. {}", what, belief.meaningless ? ": it is meaningless" : "",
                       as_sentence(belief.reasons.front()));
}

void print_doubts(Console& console, const Belief& belief, std::size_t named_already,
                  const std::string& heading) {
    for (std::size_t k = named_already; k < belief.reasons.size(); ++k) {
        const std::string& reason = belief.reasons[k];
        console.line(heading + as_sentence(reason));
    }
}

}  // namespace pendular::app
