#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "data/effect_parameter.h"

namespace pendular {

/// Something that a model may lack.
struct Candidate {
    std::string name;
    std::vector<EffectParameter> parameters;

    /// Whether it is there or not, with nothing to fit.
    bool is_switch() const;
    /// Parameters that a fit has more with it.
    std::size_t free_parameters() const;
};

/// Candidates by their places among all of them, in the order of their parameters.
using EffectSet = std::vector<std::size_t>;

/// A model with everything that it may lack: all the models that arise by adding some of it. Any
/// number of threads may ask it at once.
class ModelSpace {
  public:
    virtual ~ModelSpace() = default;

    virtual const std::vector<Candidate>& candidates() const = 0;

    /// The model with some candidates, whose parameters are those of the model without any and then
    /// those of the candidates that are no switches.
    virtual std::shared_ptr<const Model> with(const EffectSet& chosen) const = 0;

    /// Covariance of what the model's own errors make of a change g = f(with) - f(without); n x n
    /// each, empty where the model is exact in it.
    struct ChangeErrors {
        Eigen::MatrixXd change;        ///< Cov(g, g)
        Eigen::MatrixXd with_without;  ///< Cov(f(without), g)
    };
    /// Errors of the change from the model with `chosen` at `parameters` to the model with
    /// candidate `added` at `value` of its first parameter (1 for a switch).
    virtual ChangeErrors change_errors(const EffectSet& /*chosen*/,
                                       const Eigen::VectorXd& /*parameters*/, std::size_t /*added*/,
                                       double /*value*/) const {
        return {};
    }
};

}  // namespace pendular
