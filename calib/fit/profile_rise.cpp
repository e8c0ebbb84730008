#include "calib/fit/profile_rise.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace pendular {
namespace {

/// Vector without the entry `which`.
Eigen::VectorXd without(const Eigen::VectorXd& all, Eigen::Index which) {
    Eigen::VectorXd rest(all.size() - 1);
    rest << all.head(which), all.tail(all.size() - which - 1);
    return rest;
}

/// Model in which one parameter has a fixed value.
class Held : public Model {
  public:
    Held(const Model& model, Eigen::Index which, double value)
        : model_(model), which_(which), value_(value), parameters_(model.parameters()) {
        parameters_.erase(parameters_.begin() + which);
    }

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& rest, PredictionPart what) const override {
        Prediction result = model_.predict(whole(rest), what);
        if (result.jacobian.size() > 0) {
            const Eigen::MatrixXd all = std::move(result.jacobian);
            result.jacobian.resize(all.rows(), all.cols() - 1);
            result.jacobian << all.leftCols(which_), all.rightCols(all.cols() - which_ - 1);
        }
        return result;
    }
    ParameterBounds bounds() const override {
        const ParameterBounds all = model_.bounds();
        return {without(all.lower, which_), without(all.upper, which_)};
    }
    /// Values of all parameters from those of all but the fixed one.
    Eigen::VectorXd whole(const Eigen::VectorXd& rest) const {
        Eigen::VectorXd all(rest.size() + 1);
        all << rest.head(which_), value_, rest.tail(rest.size() - which_);
        return all;
    }

  private:
    const Model& model_;
    Eigen::Index which_;
    double value_;
    std::vector<Parameter> parameters_;
};

}  // namespace

Eigen::VectorXd profile_rise(const Model& model, const Measured& measured, const Fit& best,
                             Eigen::Index which, const Eigen::VectorXd& values) {
    const Eigen::MatrixXd covariance = measured.covariance + best.prediction.covariance;
    const Eigen::LLT<Eigen::MatrixXd> root(covariance);
    if (root.info() != Eigen::Success) {
        throw std::logic_error("the covariance of the readings is not positive definite");
    }
    const auto chi2_at = [&](const Eigen::VectorXd& parameters) {
        return root.matrixL()
            .solve(measured.value - model.predict(parameters, PredictionPart::values).value)
            .squaredNorm();
    };
    const double least = chi2_at(best.parameters);
    Eigen::VectorXd rises(values.size());
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const Held held(model, which, values(k));
        Eigen::VectorXd rest = without(best.parameters, which);
        try {
            if (rest.size() > 0) {
                rest = best_parameters(held, measured, covariance, rest,
                                       {.most_steps = 50, .tolerance = 1e-8, .elsewhere = false});
            }
            rises(k) = chi2_at(held.whole(rest)) - least;
        } catch (const std::domain_error&) {
            rises(k) = NAN;
        }
    }
    return rises;
}

}  // namespace pendular
