#include "calib/fit/nearby_fit.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace pendular {
namespace {

/// Largest number of steps with one covariance. Chosen: from a nearby start, Newton's method
/// takes a few.
constexpr int most_steps = 12;
/// Length of a step, in standard errors, that ends a search [1], as `same_optimum` in fit.cpp.
constexpr double short_step = 1e-3;
/// Largest number of times that a step is halved. Chosen: 1/32 of the step is left then.
constexpr int most_halvings = 5;

/// Model that keeps the last prediction of each kind, since a fit asks for some of them again.
class Remembering : public Model {
  public:
    explicit Remembering(const Model& model) : model_(model) {}

    const std::vector<Parameter>& parameters() const override { return model_.parameters(); }
    Prediction predict(const Eigen::VectorXd& parameters, PredictionPart what) const override {
        for (const Known& known : known_) {
            if (known.at.size() == parameters.size() && known.at == parameters &&
                known.what >= what) {
                return known.prediction;
            }
        }
        Known& oldest = known_[next_++ % known_.size()];
        oldest = {};
        oldest.prediction = model_.predict(parameters, what);
        oldest.at = parameters;
        oldest.what = what;
        return oldest.prediction;
    }
    ParameterBounds bounds() const override { return model_.bounds(); }

  private:
    struct Known {
        Eigen::VectorXd at;
        PredictionPart what = PredictionPart::values;
        Prediction prediction;
    };
    const Model& model_;
    mutable std::array<Known, 3> known_;
    mutable std::size_t next_ = 0;
};

/// Tangent of a model at parameter values, with the bounds of the model.
class Tangent : public Model {
  public:
    Tangent(const Model& model, Eigen::VectorXd at, Prediction prediction)
        : model_(model), at_(std::move(at)), prediction_(std::move(prediction)) {}

    const std::vector<Parameter>& parameters() const override { return model_.parameters(); }
    Prediction predict(const Eigen::VectorXd& parameters, PredictionPart what) const override {
        Prediction result{.value = prediction_.value + prediction_.jacobian * (parameters - at_)};
        if (what != PredictionPart::values) result.jacobian = prediction_.jacobian;
        return result;
    }
    ParameterBounds bounds() const override { return model_.bounds(); }

  private:
    const Model& model_;
    Eigen::VectorXd at_;
    Prediction prediction_;
};

/// chi2 of a model at parameter values, with the slopes that a next step from there needs; infinite
/// where the readings are impossible there.
double chi2_at(const Model& model, const Measured& measured,
               const Eigen::LLT<Eigen::MatrixXd>& root, const Eigen::VectorXd& parameters) {
    try {
        const Eigen::VectorXd misfit =
            measured.value - model.predict(parameters, PredictionPart::slopes).value;
        return root.matrixL().solve(misfit).squaredNorm();
    } catch (const std::domain_error&) {
        return INFINITY;
    }
}

/// Steps to the minimum, from parameters that are replaced by the result. A first step that is
/// short is not taken.
/// @param simulation covariance of the simulation errors; null: that at the start
/// @return whether the last step was short
bool descend(const Model& model, const Measured& measured, const Eigen::MatrixXd* simulation,
             Eigen::VectorXd& at) {
    Prediction here = simulation ? model.predict(at, PredictionPart::slopes) : model.predict(at);
    const Eigen::MatrixXd covariance =
        measured.covariance + (simulation ? *simulation : here.covariance);
    const Eigen::LLT<Eigen::MatrixXd> root(covariance);
    if (root.info() != Eigen::Success) {
        throw std::logic_error("the covariance of the readings is not positive definite");
    }
    double chi2 = root.matrixL().solve(measured.value - here.value).squaredNorm();
    for (int turn = 0;; ++turn) {
        const Eigen::MatrixXd slopes = here.jacobian;
        Eigen::VectorXd step =
            best_parameters(Tangent(model, at, std::move(here)), measured, covariance, at, {}) - at;
        if (turn == 0 && root.matrixL().solve(slopes * step).norm() < short_step) return true;
        double lower = chi2_at(model, measured, root, at + step);
        for (int halving = 0; !(lower <= chi2) && halving < most_halvings; ++halving) {
            step /= 2;
            lower = chi2_at(model, measured, root, at + step);
        }
        const bool is_short = root.matrixL().solve(slopes * step).norm() < short_step;
        if (!(lower <= chi2)) return is_short;
        at += step;
        chi2 = lower;
        if (is_short) return true;
        if (turn + 1 == most_steps) return false;
        here = model.predict(at, PredictionPart::slopes);
    }
}

}  // namespace

Fit nearby_fit(const Model& model, const Measured& measured, const Eigen::VectorXd& start,
               const Eigen::MatrixXd* simulation) {
    const Remembering remembering(model);
    const ParameterBounds bounds = model.bounds();
    Eigen::VectorXd at = start.cwiseMax(bounds.lower).cwiseMin(bounds.upper);
    descend(remembering, measured, simulation, at);
    const bool ended = descend(remembering, measured, nullptr, at);
    Fit result =
        fit(remembering, measured, at,
            {.most_steps = 0, .tolerance = 1e-6, .settled = short_step, .elsewhere = false});
    // `fit` did not search; a parameter without effect on any reading is not fitted.
    const bool all_act = (result.prediction.jacobian.colwise().norm().array() > 0).all();
    if (ended && all_act && !result.converged) {
        result.converged = true;
        result.message = "the last step was shorter than a thousandth of a standard error";
    }
    return result;
}

}  // namespace pendular
