#pragma once

#include <Eigen/Core>

#include "calib/model/model.h"

namespace pendular {

/// Second-order expansion of N predicted values f in p parameters about the values theta:
///     f(theta + d) = value + sum_i first_i d_i + sum_(i <= j) second_ij d_i d_j.
struct Response {
    Eigen::VectorXd at;      ///< theta
    Eigen::VectorXd value;   ///< N values at theta
    Eigen::MatrixXd first;   ///< N x p derivatives at theta
    Eigen::MatrixXd second;  ///< N x p (p + 1)/2, columns in the order of `products`

    /// Returns the N predicted values at the parameters theta + `change` by the expansion.
    Eigen::VectorXd after(const Eigen::VectorXd& change) const;
};

/// Returns the p (p + 1)/2 products d_i d_j with i <= j of the entries of `change`, in the order
/// (1, 1), (1, 2), ..., (1, p), (2, 2), ..., (p, p).
Eigen::VectorXd products(const Eigen::VectorXd& change);

/// Returns the second-order expansion of a model's predicted values about `parameters`. The second
/// derivatives are difference quotients of the model's first derivatives. A step that would exceed
/// the upper end of a parameter's range goes downwards instead.
/// @param steps steps of the difference quotients, in the units of the parameters
Response respond(const Model& model, const Eigen::VectorXd& parameters,
                 const Eigen::VectorXd& steps);

/// Returns a box of parameter values in which an expansion may replace the model: it differs from
/// the model's predictions by at most `tolerance` in every compared value, at the ends of each
/// range, with all other parameters fixed, and at up to eight corners. If the expansion is accurate
/// in no box, the box contains only the parameter values of the expansion.
/// @param tolerance in the units of the values, of which the first tolerance.size() are compared
/// @param steps unit of length of each parameter, such as its standard error; ends are tried at
///        distances of 40, 20, 10, 5, ... units
/// @param range limits of the box
ParameterBounds trusted_box(const Model& model, const Response& response,
                            const Eigen::VectorXd& tolerance, const Eigen::VectorXd& steps,
                            const ParameterBounds& range);

}  // namespace pendular
