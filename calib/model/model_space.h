#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "data/effect_parameter.h"

namespace pendular {

/// Candidate for addition to a model, such as a physical effect that the model lacks.
struct Candidate {
    std::string name;
    std::vector<EffectParameter> parameters;
    /// Heading under which tables list the candidate, such as "instrument"; may be empty.
    std::string group = {};
    /// Rank of the candidate in a sequence in which each candidate includes all candidates of lower
    /// rank, such as the sequence of ever more accurate formulas for the stress ratio of wet
    /// grains. The first rank is 1. The rank is 0 if the candidate belongs to no sequence.
    int level = 0;

    /// Whether the candidate is a switch, which is present or absent and has no parameter to fit.
    bool is_switch() const;
    /// Returns the number of parameters that the candidate adds to a fit. The number is 0 for a
    /// switch, which is present or absent and has no parameter to fit.
    std::size_t free_parameters() const;
};

/// Indices, in the list ModelSpace::candidates(), of the candidates that are added to a bare model
/// (the model without candidates). In the resulting model, the parameters of the candidates follow
/// the parameters of the bare model, in the order of the indices.
using EffectSet = std::vector<std::size_t>;

/// Set of models: a bare model, and all models that contain candidates such as physical effects in
/// addition to the bare model. Several threads may use one set of models at once.
class ModelSpace {
  public:
    virtual ~ModelSpace() = default;

    /// Returns all candidates for addition to the bare model, such as physical effects.
    virtual const std::vector<Candidate>& candidates() const = 0;

    /// Returns the bare model with the candidates `chosen` added. In the returned model, the
    /// parameters of the bare model come first, followed by the parameters of the chosen
    /// candidates. A switch (candidate that is present or absent) has no parameter.
    virtual std::shared_ptr<const Model> with(const EffectSet& chosen) const = 0;

    /// Returns the number of values that the models themselves fit to the readings, such as
    /// constant cohesions. The values are not among the parameters of a model, but each value
    /// reduces the degrees of freedom of the misfit by one.
    virtual int internally_fitted_values() const { return 0; }

    /// Covariances that simulation errors cause in the change g = f(with) - f(without). The n
    /// predicted values are f(with) in a model with a candidate and f(without) in the model without
    /// the candidate. Each covariance is an n x n matrix in products of the units of the values.
    /// The matrices are empty if the errors are negligible.
    struct ChangeErrors {
        /// Covariance Cov(g, g) of the errors of the change g of the predicted values.
        Eigen::MatrixXd change;
        /// Covariance Cov(f(without), g) of the errors of the predictions without the candidate
        /// with the errors of the change g.
        Eigen::MatrixXd with_without;
    };
    /// Returns the covariances that simulation errors cause in the change of the predicted values
    /// if the candidate `added` is added to the model with the candidates `chosen`. By default, the
    /// covariances are empty.
    /// @param parameters parameter values of the model with the candidates `chosen`
    /// @param value value of the first parameter of `added`; 1 for a switch
    virtual ChangeErrors change_errors(const EffectSet& /*chosen*/,
                                       const Eigen::VectorXd& /*parameters*/, std::size_t /*added*/,
                                       double /*value*/) const {
        return {};
    }
};

}  // namespace pendular
