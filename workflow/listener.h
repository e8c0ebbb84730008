#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "calib/fit/fit.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// Event to be displayed to the user: a note, or progress of a long computation such as a fit.
struct Event {
    enum class Kind {
        note,   ///< note for the user: `text`
        stage,  ///< beginning of the stage of work that `text` names
        runs,   ///< progress of the simulations in the stage of work that `text` names
        round,  ///< end of round `number` (new simulations, then a fit), with the result `fit`
        refits  ///< progress of the refits that `text` names: `number` of `total` refits are done
    };
    Kind kind = Kind::note;
    std::string text = {};  ///< text of the note, or name of the stage of work or of the refits
    EnsembleProgress runs = {};  ///< for the kinds `runs` and `round`; no runs: the round had none
    /// Round and the least number of rounds (`round`), or refits that are done and all refits
    /// (`refits`).
    std::size_t number = 0, total = 0;
    const Fit* fit = nullptr;  ///< fit at the end of a round; valid while the listener is called
};

/// Callback for events. It is called from one thread at a time, and may be empty.
using Listener = std::function<void(const Event&)>;

/// Calls a listener, unless it is empty.
inline void tell(const Listener& listener, const Event& event) {
    if (listener) listener(event);
}

}  // namespace pendular
