#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "data/effect_parameter.h"

namespace pendular {

/// A possible addition to a model, such as an effect.
struct Candidate {
    std::string name;
    std::vector<EffectParameter> parameters;

    /// Whether it is a switch: present or absent, with nothing to fit.
    bool is_switch() const;
    /// Number of parameters that it adds to a fit.
    std::size_t free_parameters() const;
};

/// Candidates by their places among all of them, in the order of their parameters.
using EffectSet = std::vector<std::size_t>;

/// A model with its candidates for addition: the space of all models made by adding some of them.
/// Any number of threads may ask it at once.
class ModelSpace {
  public:
    virtual ~ModelSpace() = default;

    virtual const std::vector<Candidate>& candidates() const = 0;

    /// Model with some candidates added. Its parameters are those of the bare model, then those of
    /// the candidates that are no switches.
    virtual std::shared_ptr<const Model> with(const EffectSet& chosen) const = 0;

    /// Covariance, from the model's own errors, of a change of prediction g = f(with) - f(without);
    /// n x n each, empty where the model is exact.
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
