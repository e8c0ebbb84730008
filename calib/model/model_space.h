#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "data/effect_parameter.h"

namespace pendular {

/// Candidate: a possible addition to a model, such as an effect that is not in the model.
struct Candidate {
    std::string name;
    std::vector<EffectParameter> parameters;

    /// Whether the candidate is a switch: present or absent, without a parameter to fit.
    bool is_switch() const;
    /// Number of parameters that the candidate adds to a fit.
    std::size_t free_parameters() const;
};

/// Set of candidates, as indices into ModelSpace::candidates(), in the order in which their
/// parameters follow those of the bare model.
using EffectSet = std::vector<std::size_t>;

/// Space of models: a bare model and all models made by adding some of its candidates to it. Any
/// number of threads may use it at once.
class ModelSpace {
  public:
    virtual ~ModelSpace() = default;

    /// All candidates for addition to the bare model.
    virtual const std::vector<Candidate>& candidates() const = 0;

    /// Returns the model with the candidates `chosen` added. Its parameters are those of the bare
    /// model, then those of the chosen candidates; switches have none.
    virtual std::shared_ptr<const Model> with(const EffectSet& chosen) const = 0;

    /// Covariances of a change of the n predictions g = f(with) - f(without) by the model's own
    /// errors; n x n each, empty where the model is exact.
    struct ChangeErrors {
        Eigen::MatrixXd change;        ///< Cov(g, g)
        Eigen::MatrixXd with_without;  ///< Cov(f(without), g)
    };
    /// Errors of the change from the model with candidates `chosen` at `parameters` to the model
    /// with `added` as a further candidate, whose first parameter has `value` (1 for a switch).
    virtual ChangeErrors change_errors(const EffectSet& /*chosen*/,
                                       const Eigen::VectorXd& /*parameters*/, std::size_t /*added*/,
                                       double /*value*/) const {
        return {};
    }
};

}  // namespace pendular
