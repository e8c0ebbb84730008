#include "app/belief.h"

#include <fmt/format.h>

#include "app/progress.h"
#include "calib/fit/range_text.h"

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

void print_limits(Console& console, const std::vector<dem::RunResult>& runs,
                  const std::vector<Reading>& readings, double friction) {
    for (const auto& note : {implausible_friction(friction), extrapolation_note(runs, readings)}) {
        if (note) console.line("Note: " + *note);
    }
}

}  // namespace pendular::app
