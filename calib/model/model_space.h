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
    /// Place on a ladder of models: a candidate contains all candidates of lower levels above 0;
    /// 0: on no ladder.
    int level = 0;

    /// Whether the candidate is a switch: present or absent, without a parameter to fit.
    bool is_switch() const;
    /// Number of parameters that the candidate adds to a fit; 0 for a switch.
    std::size_t free_parameters() const;
};

/// Set of candidates (possible additions to a bare model), as indices into
/// ModelSpace::candidates(), in the order in which their parameters follow those of the bare model.
using EffectSet = std::vector<std::size_t>;

/// Space of models: a bare model and all models made by adding some of the candidates, such as
/// physical effects, to it. Any number of threads may use it at once.
class ModelSpace {
  public:
    virtual ~ModelSpace() = default;

    /// All candidates for addition to the bare model.
    virtual const std::vector<Candidate>& candidates() const = 0;

    /// Returns the bare model with the candidates `chosen` added. Its parameters are those of the
    /// bare model, then those of the chosen candidates; switches have none.
    virtual std::shared_ptr<const Model> with(const EffectSet& chosen) const = 0;

    /// Number of values that were fitted to the readings beforehand and are no parameters, such as
    /// the cohesions of straight lines; each takes a degree of freedom.
    virtual int fitted_beforehand() const { return 0; }

    /// Covariances of the simulation errors of the change g = f(with) - f(without) of n predicted
    /// values f, when a candidate is added to a model; n x n each, empty where the errors are
    /// negligible.
    struct ChangeErrors {
        Eigen::MatrixXd change;  ///< Cov(g, g), covariance of the errors of the change
        /// Cov(f(without), g), of the predictions before the change with the change
        Eigen::MatrixXd with_without;
    };
    /// Covariances of the simulation errors of the change of predictions from the model with
    /// candidates `chosen` at `parameters` to the model with the further candidate `added`, whose
    /// first parameter has `value` (1 for a switch).
    virtual ChangeErrors change_errors(const EffectSet& /*chosen*/,
                                       const Eigen::VectorXd& /*parameters*/, std::size_t /*added*/,
                                       double /*value*/) const {
        return {};
    }
};

}  // namespace pendular
