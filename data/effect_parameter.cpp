#include "data/effect_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pendular {

EffectParameter on_switch(std::string meaning) {
    return {.name = "on", .unit = "1", .meaning = std::move(meaning)};
}

double Values::operator[](std::string_view name) const {
    const auto found = std::ranges::find(parameters_, name, &EffectParameter::name);
    if (found == parameters_.end()) {
        throw std::logic_error(fmt::format("no parameter '{}' in an effect", name));
    }
    return values_[static_cast<std::size_t>(found - parameters_.begin())];
}

}  // namespace pendular
