#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "calib/model/model.h"
#include "data/effect_parameter.h"

namespace pendular {

/// Candidate: a possible addition to a model, such as a physical effect that the model lacks.
struct Candidate {
    std::string name;
    std::vector<EffectParameter> parameters;
    /// Group to which the candidate belongs in tables, such as "instrument"; may be empty.
    std::string group = {};
    /// Rank of the candidate in a sequence of candidates each of which includes all before it, such
    /// as ever better formulas for the strength of wet grains. The first rank is 1; 0: the
    /// candidate belongs to no such sequence.
    int level = 0;

    /// Whether the candidate is a switch: it is present or absent and has no parameter to fit.
    bool is_switch() const;
    /// Number of parameters that the candidate adds to a fit; 0 for a switch (present or absent).
    std::size_t free_parameters() const;
};

/// Set of candidates (possible additions to a bare model), as indices into
/// ModelSpace::candidates(). The parameters of the candidates follow those of the bare model in the
/// order of the indices.
using EffectSet = std::vector<std::size_t>;

/// Set of models: a bare model, and all models made from it by adding candidates such as physical
/// effects. Several threads may use it at once.
class ModelSpace {
  public:
    virtual ~ModelSpace() = default;

    /// All possible additions to the bare model, such as physical effects.
    virtual const std::vector<Candidate>& candidates() const = 0;

    /// Returns the bare model with the candidates (possible additions) `chosen` added. The
    /// parameters of the returned model are those of the bare model, then those of the chosen
    /// candidates; a switch (present or absent) has none.
    virtual std::shared_ptr<const Model> with(const EffectSet& chosen) const = 0;

    /// Number of values that were fitted to the readings before the fit of the model, such as
    /// constant cohesions. These values are no parameters of the model, but each takes a degree of
    /// freedom.
    virtual int fitted_beforehand() const { return 0; }

    /// Covariances of the simulation errors of the change g = f(with) - f(without), which is how n
    /// predicted values f change when a candidate is added to a model. Each is n x n, in the
    /// squared units of the values, and empty if the errors are negligible.
    struct ChangeErrors {
        /// Cov(g, g): covariance of the errors of the change g of the predicted values.
        Eigen::MatrixXd change;
        /// Cov(f(without), g): covariance of the errors of the predictions without the candidate
        /// with the errors of the change g.
        Eigen::MatrixXd with_without;
    };
    /// Returns the covariances of the simulation errors of the change of predictions when the
    /// candidate `added` is added to the model with the candidates `chosen`; empty by default.
    /// @param parameters parameters of the model with the candidates `chosen`
    /// @param value value of the first parameter of `added`; 1 for a switch
    virtual ChangeErrors change_errors(const EffectSet& /*chosen*/,
                                       const Eigen::VectorXd& /*parameters*/, std::size_t /*added*/,
                                       double /*value*/) const {
        return {};
    }
};

}  // namespace pendular
