#include "calib/model/model.h"

#include <algorithm>

namespace pendular {

void widen(Eigen::MatrixXd& square, Eigen::Index by) {
    if (square.size() == 0) return;  // not requested
    const Eigen::Index n = square.rows();
    square.conservativeResize(n + by, n + by);
    square.rightCols(by).setZero();
    square.bottomRows(by).setZero();
}

std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters) {
    const auto found = std::ranges::find(parameters, direct.parameter, &Parameter::name);
    if (found == parameters.end()) return std::nullopt;
    return found - parameters.begin();
}

double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values) {
    const auto place = place_of(direct, parameters);
    return place ? values(*place) : direct.neutral;
}

bool Candidate::is_switch() const {
    return std::ranges::all_of(parameters, &EffectParameter::is_switch);
}

std::size_t Candidate::free_parameters() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(parameters, [](const EffectParameter& p) { return !p.is_switch(); }));
}

}  // namespace pendular
