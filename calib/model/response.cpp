#include "calib/model/response.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace pendular {
namespace {

/// Corners of a box that are tried where there are too many to try all. Chosen: each costs a
/// prediction of all readings, and the ends of each parameter alone were tried before.
constexpr std::size_t most_corners = 8;
/// Factor between the sizes of boxes that are tried, the largest size in steps, and the number of
/// sizes. Chosen: from 40 steps, beyond what a fit leaves open, to 0.16 steps.
constexpr double shrink = 0.5, largest_box = 40;
constexpr std::size_t sizes_of_boxes = 9;
/// Smallest share of the ends of single parameters that is tried for all together [1]. Chosen: a
/// smaller box would leave no room to move the parameters.
constexpr double smallest_share = 0.1;

/// Largest difference between the expansion and the model over the tolerance [1]; infinite where
/// the readings are impossible at these parameters.
double excess(const Model& model, const Response& response, const Eigen::VectorXd& tolerance,
              const Eigen::VectorXd& change) {
    try {
        const Eigen::VectorXd exact =
            model.predict(response.at + change, PredictionPart::values).value;
        const Eigen::Index n = tolerance.size();
        return ((exact - response.after(change)).head(n).cwiseAbs().cwiseQuotient(tolerance))
            .maxCoeff();
    } catch (const std::domain_error&) {
        return INFINITY;
    }
}

/// Change of the parameters to one end of a box: of parameter k to its upper end where bit k of
/// `corner` is set, else to its lower end.
Eigen::VectorXd to_corner(const ParameterBounds& box, const Eigen::VectorXd& at,
                          std::size_t corner) {
    Eigen::VectorXd change(at.size());
    for (Eigen::Index k = 0; k < at.size(); ++k) {
        change(k) = ((corner >> k) & 1 ? box.upper(k) : box.lower(k)) - at(k);
    }
    return change;
}

bool holds_at_corners(const Model& model, const Response& response,
                      const Eigen::VectorXd& tolerance, const ParameterBounds& box) {
    const std::size_t corners = std::size_t(1) << response.at.size();
    // An odd stride of about five eighths leads to corners that differ in each parameter.
    const std::size_t stride = corners > most_corners ? corners * 5 / 8 | 1 : 1;
    for (std::size_t k = 0; k < std::min(corners, most_corners); ++k) {
        if (!(excess(model, response, tolerance,
                     to_corner(box, response.at, k * stride % corners)) <= 1)) {
            return false;
        }
    }
    return true;
}

/// End of the range of parameter k in one direction, up to which the expansion holds where the
/// other parameters stay.
double trusted_end(const Model& model, const Response& response, const Eigen::VectorXd& tolerance,
                   Eigen::Index k, double step, double end) {
    const auto reached = [&](std::size_t halvings) {
        const double wanted =
            response.at(k) + largest_box * std::pow(shrink, static_cast<double>(halvings)) * step;
        return step > 0 ? std::min(wanted, end) : std::max(wanted, end);
    };
    Eigen::VectorXd change = Eigen::VectorXd::Zero(response.at.size());
    const auto holds = [&](std::size_t halvings) {
        change(k) = reached(halvings) - response.at(k);
        return change(k) * step > 0 && excess(model, response, tolerance, change) <= 1;
    };
    // The difference from the model grows with the distance, so that halving finds the largest
    // size that holds.
    std::size_t holding = sizes_of_boxes, first = 0;
    while (first < holding) {
        const std::size_t middle = (first + holding) / 2;
        if (holds(middle)) {
            holding = middle;
        } else {
            first = middle + 1;
        }
    }
    return holding < sizes_of_boxes ? reached(holding) : response.at(k);
}

}  // namespace

Eigen::VectorXd products(const Eigen::VectorXd& change) {
    const Eigen::Index p = change.size();
    Eigen::VectorXd result(p * (p + 1) / 2);
    for (Eigen::Index i = 0, at = 0; i < p; ++i) {
        for (Eigen::Index j = i; j < p; ++j) {
            result(at++) = change(i) * change(j);
        }
    }
    return result;
}

Eigen::VectorXd Response::after(const Eigen::VectorXd& change) const {
    return value + first * change + second * products(change);
}

Response respond(const Model& model, const Eigen::VectorXd& parameters,
                 const Eigen::VectorXd& steps) {
    const Prediction here = model.predict(parameters, PredictionPart::slopes);
    const ParameterBounds bounds = model.bounds();
    const Eigen::Index p = parameters.size();
    // d_k J, N x p, for each parameter k.
    std::vector<Eigen::MatrixXd> turned;
    for (Eigen::Index k = 0; k < p; ++k) {
        Eigen::VectorXd other = parameters;
        const bool up = parameters(k) + steps(k) <= bounds.upper(k);
        other(k) =
            up ? parameters(k) + steps(k)
               : std::max(parameters(k) - steps(k), std::min(bounds.lower(k), parameters(k)));
        const double width = other(k) - parameters(k);
        turned.emplace_back(Eigen::MatrixXd::Zero(here.jacobian.rows(), p));
        if (width == 0) continue;
        turned.back() =
            (model.predict(other, PredictionPart::slopes).jacobian - here.jacobian) / width;
    }
    Response response{.at = parameters,
                      .value = here.value,
                      .first = here.jacobian,
                      .second = Eigen::MatrixXd(here.value.size(), p * (p + 1) / 2)};
    for (Eigen::Index i = 0, at = 0; i < p; ++i) {
        for (Eigen::Index j = i; j < p; ++j) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
            // The mean of both orders; half of the second derivative where i = j.
            response.second.col(at++) =
                i == j ? Eigen::VectorXd(turned[a].col(i) / 2)
                       : Eigen::VectorXd((turned[a].col(j) + turned[b].col(i)) / 2);
        }
    }
    return response;
}

ParameterBounds trusted_box(const Model& model, const Response& response,
                            const Eigen::VectorXd& tolerance, const Eigen::VectorXd& steps,
                            const ParameterBounds& range) {
    const Eigen::Index p = response.at.size();
    ParameterBounds alone{response.at, response.at};
    for (Eigen::Index k = 0; k < p; ++k) {
        alone.lower(k) = trusted_end(model, response, tolerance, k, -steps(k),
                                     std::min(range.lower(k), response.at(k)));
        alone.upper(k) = trusted_end(model, response, tolerance, k, steps(k),
                                     std::max(range.upper(k), response.at(k)));
    }
    for (double share = 1; share > smallest_share; share *= shrink) {
        const ParameterBounds box{response.at + share * (alone.lower - response.at),
                                  response.at + share * (alone.upper - response.at)};
        if (holds_at_corners(model, response, tolerance, box)) return box;
    }
    return {response.at, response.at};
}

}  // namespace pendular
