#pragma once

#include <utility>
#include <vector>

#include "calib/model.h"

namespace pendular {

/// What models of flow in closed form have in common: parameters whose whole range is supported,
/// and nothing to learn.
class KnownFlow : public FlowModel {
  public:
    explicit KnownFlow(std::vector<Parameter> parameters) : parameters_(std::move(parameters)) {}
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    void improve(const Eigen::VectorXd&, double) override {}
    void learn_wet(const Eigen::VectorXd&, int) override {}
    Supported supported() const override {
        const auto n = static_cast<Eigen::Index>(parameters_.size());
        Supported range{Eigen::VectorXd(n), Eigen::VectorXd(n)};
        for (Eigen::Index k = 0; k < n; ++k) {
            const Parameter& p = parameters_[static_cast<std::size_t>(k)];
            range.lower(k) = p.lower, range.upper(k) = p.upper;
        }
        return range;
    }

  private:
    std::vector<Parameter> parameters_;
};

}  // namespace pendular
