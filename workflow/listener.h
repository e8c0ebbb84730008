#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "calib/fit/fit.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// Event to be displayed to the user: a note, or a progress report of a long computation such as a
/// fit.
struct Event {
    enum class Kind {
        note,   ///< note for the user: `text`
        stage,  ///< beginning of the stage of work that `text` names
        runs,   ///< progress of the simulations in the stage of work that `text` names
        round,  ///< end of round `number` (new simulations, then a fit), with the result `fit`
        refits  ///< progress of the refits that `text` names: `number` of `total` refits are done
    };
    Kind kind = Kind::note;
    /// Text of the note, or name of the stage of work or of the refits.
    std::string text = {};
    /// Progress of the simulations. Used for an event of the kind `runs`.
    EnsembleProgress runs = {};
    /// Number of the round (`number`) in an event of the kind `round`. In an event of the kind
    /// `refits`, number of refits that are done (`number`) and of all refits (`total`).
    std::size_t number = 0, total = 0;
    /// Fit at the end of a round, in an event of the kind `round`. The pointer is valid only while
    /// the listener is called.
    const Fit* fit = nullptr;
};

/// Callback that receives notes to the user and progress reports of long computations such as fits.
/// The callback is called from one thread at a time. A listener may be empty.
using Listener = std::function<void(const Event&)>;

/// Calls a listener (callback for notes and progress reports) with an event. Does nothing if the
/// listener is empty.
inline void tell(const Listener& listener, const Event& event) {
    if (listener) listener(event);
}

}  // namespace pendular
