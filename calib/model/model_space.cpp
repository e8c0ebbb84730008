#include "calib/model/model_space.h"

#include <algorithm>

namespace pendular {

bool Candidate::is_switch() const {
    return std::ranges::all_of(parameters, &EffectParameter::is_switch);
}

std::size_t Candidate::free_parameters() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(parameters, [](const EffectParameter& p) { return !p.is_switch(); }));
}

}  // namespace pendular
