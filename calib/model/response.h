#pragma once

#include <Eigen/Core>

#include "calib/model/model.h"

namespace pendular {

/// Second-order expansion of N predicted values f in the p parameters of a model, about theta:
///     f(theta + d) = value + sum_i first_i d_i + sum_(i <= j) second_ij d_i d_j.
struct Response {
    /// Parameter values theta about which the model is expanded, in the units of the parameters.
    Eigen::VectorXd at;
    /// Values that the model predicts at the parameters theta, N entries.
    Eigen::VectorXd value;
    /// Derivatives of the predicted values with respect to the parameters at theta: a row for each
    /// of the N values, a column for each of the p parameters.
    Eigen::MatrixXd first;
    /// Coefficients of the second-order terms: of the products d_i d_j of the changes d of the
    /// parameters. A row for each of the N values, and p (p + 1)/2 columns in the order of
    /// `products`.
    Eigen::MatrixXd second;

    /// Returns the expanded values at theta + `change`, N entries. `change` has the units of the
    /// parameters.
    Eigen::VectorXd after(const Eigen::VectorXd& change) const;
};

/// Returns the products d_i d_j with i <= j of the p entries d of `change`, in the order (1, 1),
/// (1, 2), ..., (1, p), (2, 2), ..., (p, p): p (p + 1)/2 entries.
Eigen::VectorXd products(const Eigen::VectorXd& change);

/// Returns the second-order expansion of a model's predictions about `parameters`. The second
/// derivatives are difference quotients of the model's first derivatives. A step beyond the upper
/// end of a parameter's range is taken downwards instead, at most to the lower end.
/// @param steps step of each parameter for the difference quotients [its unit]
Response respond(const Model& model, const Eigen::VectorXd& parameters,
                 const Eigen::VectorXd& steps);

/// Returns a range of each parameter, around the parameter values of an expansion, within which the
/// expansion differs from the model's predictions by at most `tolerance` in every compared entry.
///
/// Each end is first found with the other parameters fixed: the largest of 40, 20, 10, 5, ...
/// `steps` at which the expansion holds, within `range`. All ranges are then reduced by one factor,
/// 1, 1/2, 1/4 or 1/8, until the expansion holds at the corners of the box: at all corners for up
/// to three parameters, at eight of them for more. If it never does, the box contains only the
/// parameter values of the expansion.
/// @param tolerance largest difference of each of the first entries, in the unit of the entry;
///        further entries are not compared
/// @param steps lengths in which the ends are measured, in the units of the parameters, such as
///        standard errors
/// @param range limits of the box
ParameterBounds trusted_box(const Model& model, const Response& response,
                            const Eigen::VectorXd& tolerance, const Eigen::VectorXd& steps,
                            const ParameterBounds& range);

}  // namespace pendular
