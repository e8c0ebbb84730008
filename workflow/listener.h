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
        note,   ///< `text` is worth a word
        stage,  ///< the work that `text` names begins
        runs,   ///< simulations of the stage `text` have come as far as `runs` says
        round,  ///< round `number` of a fit has ended with `fit`
        refits  ///< of `total` refits that `text` names `number` are done
    };
    Kind kind = Kind::note;
    std::string text = {};
    EnsembleProgress runs = {};
    std::size_t number = 0, total = 0;
    const Fit* fit = nullptr;
};

/// Called from one thread at a time; may be empty.
using Listener = std::function<void(const Event&)>;

/// Tells a listener, if there is one.
inline void tell(const Listener& listener, const Event& event) {
    if (listener) listener(event);
}

}  // namespace pendular
