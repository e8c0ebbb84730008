#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sim/catalogue/effect.h"

/// Laws that every effect of the registry must keep, one test for each effect.
class EveryEffect : public testing::TestWithParam<std::string> {
  protected:
    const pendular::Effect& effect() const { return pendular::built_in_effect(GetParam()); }
};

template <typename Chosen>
std::vector<std::string> names_of_effects(const Chosen& chosen) {
    std::vector<std::string> names;
    for (const pendular::Effect& effect : pendular::built_in_effects()) {
        if (chosen(effect)) names.push_back(effect.name);
    }
    return names;
}

inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

/// All corners of the bounds of an effect's parameters.
inline std::vector<std::vector<double>> corners(const pendular::Effect& effect) {
    std::vector<std::vector<double>> all = {{}};
    for (const pendular::EffectParameter& parameter : effect.parameters) {
        std::vector<std::vector<double>> longer;
        for (const double bound : {parameter.lower, parameter.upper}) {
            for (std::vector<double> corner : all) {
                corner.push_back(bound);
                longer.push_back(corner);
            }
        }
        all = longer;
    }
    return all;
}

/// Values that differ from neutral by what matters, in one parameter each, within the bounds.
inline std::vector<std::vector<double>> values_that_matter(const pendular::Effect& effect) {
    std::vector<std::vector<double>> all;
    for (std::size_t k = 0; k < effect.parameters.size(); ++k) {
        const pendular::EffectParameter& p = effect.parameters[k];
        for (const double value :
             {p.neutral - p.smallest_of_interest, p.neutral + p.smallest_of_interest}) {
            if (value < p.lower) continue;
            all.push_back(effect.neutral());
            all.back()[k] = value;
        }
    }
    return all;
}
