#pragma once

#include <utility>
#include <vector>

#include "calib/model/predictor.h"

namespace pendular {

/// Base of models of flow in closed form: parameters whose whole range is supported.
template <typename Kind>
class Known : public Kind {
  public:
    explicit Known(std::vector<Parameter> parameters) : parameters_(std::move(parameters)) {}
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    ParameterBounds bounds() const override {
        const auto n = static_cast<Eigen::Index>(parameters_.size());
        ParameterBounds range{Eigen::VectorXd(n), Eigen::VectorXd(n)};
        for (Eigen::Index k = 0; k < n; ++k) {
            const Parameter& p = parameters_[static_cast<std::size_t>(k)];
            range.lower(k) = p.lower, range.upper(k) = p.upper;
        }
        return range;
    }

  private:
    std::vector<Parameter> parameters_;
};
using KnownFlow = Known<Predictor>;

}  // namespace pendular
