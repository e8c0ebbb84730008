#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "calib/fit/fit.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// Note or progress report of the work on a study, for display.
struct Event {
    enum class Kind {
        note,   ///< note for the user: `text`
        stage,  ///< beginning of the stage of work that `text` names
        runs,   ///< progress of the simulations of the stage `text`
        round,  ///< end of round `number` of a fit, with its result `fit`
        refits  ///< progress of the refits that `text` names: `number` of `total`
    };
    Kind kind = Kind::note;
    /// Text of the note, or name of the stage of work or of the refits.
    std::string text = {};
    /// Progress of the simulations, for an event of the kind `runs`.
    EnsembleProgress runs = {};
    /// For the kind `round`, `number` is the number of the round. For the kind `refits`, `number`
    /// of `total` refits are done.
    std::size_t number = 0, total = 0;
    /// Fit at the end of a round; valid only while the listener is called.
    const Fit* fit = nullptr;
};

/// Callback that receives notes and progress reports of the work on a study. It is called from one
/// thread at a time and may be empty.
using Listener = std::function<void(const Event&)>;

/// Calls a listener with an event; does nothing where the listener is empty.
inline void tell(const Listener& listener, const Event& event) {
    if (listener) listener(event);
}

}  // namespace pendular
