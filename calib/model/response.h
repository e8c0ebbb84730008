#pragma once

#include <Eigen/Core>

#include "calib/model/model.h"

namespace pendular {

/// Second-order expansion of N predicted values about parameter values theta:
///     f(theta + d) = value + sum_i first_i d_i + sum_(i <= j) second_ij d_i d_j.
struct Response {
    Eigen::VectorXd at;     ///< theta, in the units of the p parameters
    Eigen::VectorXd value;  ///< predicted values at theta: N entries
    Eigen::MatrixXd first;  ///< derivatives by the parameters, N x p
    Eigen::MatrixXd
        second;  ///< coefficients of d_i d_j, N x p (p + 1)/2, as `products` orders them

    /// Expanded values at theta + `change`, N entries.
    Eigen::VectorXd after(const Eigen::VectorXd& change) const;
};

/// Products d_i d_j with i <= j of the entries of `change`: (1, 1), (1, 2), ... (1, p), (2, 2), ...
Eigen::VectorXd products(const Eigen::VectorXd& change);

/// Expands a model's predictions about `parameters`. The second derivatives are differences of the
/// model's derivatives over `steps`, which are cut off at the ends of the parameters' ranges.
/// @param steps length of the steps in the units of the parameters, such as standard errors
Response respond(const Model& model, const Eigen::VectorXd& parameters,
                 const Eigen::VectorXd& steps);

/// Box of parameter values around the point of expansion in which the expansion differs from the
/// model by at most `tolerance` in each of the first entries: at the ends of each parameter's
/// range, at all corners of up to three parameters, and at 8 fixed corners of more. Of several such
/// boxes, the largest with ends at 40, 20, 10, 5, ... `steps` from the point counts, for each
/// parameter by itself and then for all of them. The ends lie within `range`.
/// @param tolerance allowed difference of each entry, in its unit; entries of the response beyond
///        its size are not compared
/// @param steps units of the boxes, such as standard errors
ParameterBounds trusted_box(const Model& model, const Response& response,
                            const Eigen::VectorXd& tolerance, const Eigen::VectorXd& steps,
                            const ParameterBounds& range);

}  // namespace pendular
