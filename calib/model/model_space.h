#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "data/effect_parameter.h"

namespace pendular {

/// Candidate for addition to a model, such as an effect that the model lacks.
struct Candidate {
    std::string name;
    std::vector<EffectParameter> parameters;
    std::string group = {};  ///< heading in tables of candidates, such as "instrument"
    /// Rank, from 1, in a sequence in which each candidate includes those of lower rank, such as
    /// the ever more accurate formulas for the stress ratio of wet grains; 0 outside of a sequence.
    int level = 0;

    /// Whether the candidate is present or absent and has no parameter to fit.
    bool is_switch() const;
    /// Returns the number of parameters that the candidate adds to a fit; 0 for a switch.
    std::size_t free_parameters() const;
};

/// Indices in ModelSpace::candidates() of the candidates added to a bare model. In the resulting
/// model, their parameters follow those of the bare model, in the order of the indices.
using EffectSet = std::vector<std::size_t>;

/// Set of models: a bare model, and all models that contain candidates in addition to it. Several
/// threads may use one set of models at once.
class ModelSpace {
  public:
    virtual ~ModelSpace() = default;

    virtual const std::vector<Candidate>& candidates() const = 0;

    /// Returns the bare model with the candidates `chosen` added. The parameters of the bare model
    /// come first. A switch has no parameter.
    virtual std::shared_ptr<const Model> with(const EffectSet& chosen) const = 0;

    /// Returns the number of values that the models themselves fit to the readings, such as
    /// constant cohesions. They are no parameters of a model, but each reduces the degrees of
    /// freedom of the misfit by one.
    virtual int internally_fitted_values() const { return 0; }

    /// Covariances that simulation errors cause in the change g = f(with) - f(without) of the n
    /// predicted values when a candidate is added: n x n matrices in products of the units of the
    /// values, empty if the errors are negligible.
    struct ChangeErrors {
        Eigen::MatrixXd change;        ///< Cov(g, g)
        Eigen::MatrixXd with_without;  ///< Cov(f(without), g)
    };
    /// Returns the covariances for the addition of `added` to the model with `chosen`; empty by
    /// default.
    /// @param parameters parameter values of the model with the candidates `chosen`
    /// @param value value of the first parameter of `added`; 1 for a switch
    virtual ChangeErrors change_errors(const EffectSet& /*chosen*/,
                                       const Eigen::VectorXd& /*parameters*/, std::size_t /*added*/,
                                       double /*value*/) const {
        return {};
    }
};

}  // namespace pendular
