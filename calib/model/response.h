#pragma once

#include <Eigen/Core>

#include "calib/model/model.h"

namespace pendular {

/// Second-order expansion of N predicted values f in the p parameters of a model, about the
/// parameter values theta:
///     f(theta + d) = value + sum_i first_i d_i + sum_(i <= j) second_ij d_i d_j.
struct Response {
    /// Parameter values theta about which the model is expanded, in the units of the parameters.
    Eigen::VectorXd at;
    /// Predicted values (N entries) at the parameters theta.
    Eigen::VectorXd value;
    /// Derivatives of the predicted values with respect to the parameters, at the parameters theta.
    /// The matrix has a row for each of the N values and a column for each of the p parameters.
    Eigen::MatrixXd first;
    /// Coefficients of the second-order terms, which are proportional to the products d_i d_j of
    /// the changes d of the parameters. The matrix has a row for each of the N values, and p (p +
    /// 1)/2 columns in the order of the function `products`.
    Eigen::MatrixXd second;

    /// Returns the N predicted values at the parameters theta + `change`, computed from the
    /// expansion. `change` has p entries, in the units of the parameters.
    Eigen::VectorXd after(const Eigen::VectorXd& change) const;
};

/// Returns the products d_i d_j with i <= j of the p entries d of `change`, in the order (1, 1),
/// (1, 2), ..., (1, p), (2, 2), ..., (p, p). There are p (p + 1)/2 products.
Eigen::VectorXd products(const Eigen::VectorXd& change);

/// Returns the second-order expansion of a model's predicted values about the parameter values
/// `parameters`. The second derivatives are difference quotients of the model's first derivatives.
/// A step that would exceed the upper end of a parameter's range goes downwards instead.
/// @param steps steps of the parameters for the difference quotients, in the units of the
///        parameters
Response respond(const Model& model, const Eigen::VectorXd& parameters,
                 const Eigen::VectorXd& steps);

/// Returns a box of parameter values (a range of each parameter) in which an expansion may replace
/// the model. In the box, the expansion differs from the model's predictions by at most `tolerance`
/// in every compared value. The function compares the values at the ends of each range, with all
/// other parameters fixed, and at up to eight corners of the box. If the expansion is accurate in
/// no box, the returned box contains only the parameter values of the expansion.
/// @param tolerance largest allowed difference of each compared value, in the unit of the value;
///        the first tolerance.size() predicted values are compared
/// @param steps unit of length of each parameter, such as the standard error of the parameter; the
///        function tries ends at distances of 40, 20, 10, 5, ... units
/// @param range limits of the box
ParameterBounds trusted_box(const Model& model, const Response& response,
                            const Eigen::VectorXd& tolerance, const Eigen::VectorXd& steps,
                            const ParameterBounds& range);

}  // namespace pendular
