#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "calib/fit/fit.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// Event of the work on a study, for whoever shows it.
struct Event {
    enum class Kind {
        note,   ///< note for the user: `text`
        stage,  ///< beginning of the work that `text` names
        runs,   ///< progress of the simulations of the stage `text`
        round,  ///< end of round `number` of a fit, with its result `fit`
        refits  ///< progress of the refits that `text` names: `number` of `total`
    };
    Kind kind = Kind::note;
    std::string text = {};
    EnsembleProgress runs = {};
    std::size_t number = 0, total = 0;
    const Fit* fit = nullptr;
};

/// Callback for events; called from one thread at a time; may be empty.
using Listener = std::function<void(const Event&)>;

/// Passes an event to a listener, if there is one.
inline void tell(const Listener& listener, const Event& event) {
    if (listener) listener(event);
}

}  // namespace pendular
