#pragma once

#include <utility>
#include <vector>

#include "calib/model/predictor.h"

namespace pendular {

/// Base class of test models whose predictions are formulas. Every parameter value within the
/// parameter's own range can be predicted. `Kind` is the interface of the model, such as Predictor.
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
/// Base class of test models that predict readings by formulas.
using KnownFlow = Known<Predictor>;

}  // namespace pendular
