#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "calib/model/model.h"

namespace pendular {

/// Models whose predictions f are linear in all parameters, so that the right result of every
/// diagnosis is known:
///     f = X theta + sum over chosen candidates of (column x value)
/// with the base columns X and their parameters theta.
class LinearSpace : public ModelSpace {
  public:
    /// Candidate effect. `values` contains the change of each entry of f when the effect's
    /// parameter is 1.
    struct Column {
        std::string name;
        Eigen::VectorXd values;
        EffectParameter parameter = {.name = "amplitude",
                                     .lower = -1e6,
                                     .upper = 1e6,
                                     .neutral = 0,
                                     .smallest_of_interest = 1};
        /// Largest magnitude of the effect's parameter that can be predicted; a prediction with a
        /// larger one throws std::domain_error.
        double possible = 1e9;
        /// Rank of the effect among effects that exclude each other: the model contains only the
        /// chosen effect of the highest rank. 0: the effect excludes no other effect.
        int level = 0;
    };
    LinearSpace(Eigen::MatrixXd base, std::vector<Column> columns)
        : base_(std::move(base)), columns_(std::move(columns)) {
        for (const Column& column : columns_) {
            candidates_.push_back({column.name, {column.parameter}, "", column.level});
        }
    }
    const std::vector<Candidate>& candidates() const override { return candidates_; }
    std::shared_ptr<const Model> with(const EffectSet& chosen) const override {
        return std::make_shared<Linear>(*this, chosen);
    }

  private:
    class Linear : public Model {
      public:
        Linear(const LinearSpace& space, const EffectSet& chosen)
            : columns_(space.base_), constant_(Eigen::VectorXd::Zero(space.base_.rows())) {
            for (Eigen::Index k = 0; k < columns_.cols(); ++k) {
                add_parameter({.name = "base" + std::to_string(k), .lower = -1e6, .upper = 1e6});
            }
            for (const std::size_t k : chosen) {
                const Column& column = space.columns_[k];
                if (column.level > 0 && below_another(space, chosen, column.level)) continue;
                if (column.parameter.is_switch()) {
                    constant_ += column.values;
                    continue;
                }
                columns_.conservativeResize(Eigen::NoChange, columns_.cols() + 1);
                columns_.rightCols(1) = column.values;
                possible_.conservativeResize(possible_.size() + 1);
                possible_(possible_.size() - 1) = column.possible;
                add_parameter({.name = column.name,
                               .lower = column.parameter.lower,
                               .upper = column.parameter.upper,
                               .start = column.parameter.neutral});
            }
        }
        const std::vector<Parameter>& parameters() const override { return parameters_; }
        Prediction predict(const Eigen::VectorXd& parameters,
                           PredictionPart /*what*/) const override {
            const auto n = columns_.rows();
            if (possible_.size() > 0 &&
                (parameters.tail(possible_.size()).cwiseAbs() - possible_).maxCoeff() > 0) {
                throw std::domain_error("so much of it that nothing real shows this");
            }
            return {columns_ * parameters + constant_, columns_, Eigen::MatrixXd::Zero(n, n),
                    Eigen::MatrixXd::Zero(n, n)};
        }
        ParameterBounds bounds() const override {
            const auto p = columns_.cols();
            return {Eigen::VectorXd::Constant(p, -1e6), Eigen::VectorXd::Constant(p, 1e6)};
        }

      private:
        static bool below_another(const LinearSpace& space, const EffectSet& chosen, int level) {
            return std::ranges::any_of(
                chosen, [&](std::size_t k) { return space.columns_[k].level > level; });
        }
        void add_parameter(Parameter parameter) { parameters_.push_back(std::move(parameter)); }

        Eigen::MatrixXd columns_;
        Eigen::VectorXd constant_, possible_;
        std::vector<Parameter> parameters_;
    };

    Eigen::MatrixXd base_;
    std::vector<Column> columns_;
    std::vector<Candidate> candidates_;
};

}  // namespace pendular
