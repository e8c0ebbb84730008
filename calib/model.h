#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/reading.h"
#include "sim/direct_measurement.h"

namespace pendular {

/// A parameter that a fit may change.
struct Parameter {
    std::string name;
    std::string unit = "1";
    double lower = 0;
    double upper = 0;
    double start = 0;
};

/// What a model says of n readings, and how sure it is. Entries 2 k and 2 k + 1 belong to reading
/// k: its shear stress magnitude [Pa] and its solid fraction [1]. Where a model is asked for a
/// study's direct measurements too, m entries follow, one each in its unit.
struct Prediction {
    Eigen::VectorXd value;     ///< 2 n + m
    Eigen::MatrixXd jacobian;  ///< 2 n + m x parameters
    /// 2 n + m squared, of `value`: noise of the runs and the error of every correction.
    Eigen::MatrixXd covariance;
    Eigen::MatrixXd run_noise;  ///< the part of `covariance` that more runs would reduce
};

/// Place of what was measured directly among parameters; none where it is not among them.
std::optional<Eigen::Index> place_of(const DirectMeasurement& direct,
                                     const std::vector<Parameter>& parameters);

/// What a model with these parameters at these values says of a direct measurement: the parameter,
/// or neutral where it has none of that name.
double predicted_value(const DirectMeasurement& direct, const std::vector<Parameter>& parameters,
                       const Eigen::VectorXd& values);

/// Puts as many rows and columns of zeros to the end of a square matrix; an empty one stays so.
void widen(Eigen::MatrixXd& square, Eigen::Index by);

/// The range of parameters over which a model's predictions are supported by simulation.
struct Supported {
    Eigen::VectorXd lower, upper;
};

/// Predicts the readings of a study as functions of its parameters. The derivatives are those of
/// the value returned, so that a least-squares solver never differentiates noise.
class Model {
  public:
    virtual ~Model() = default;

    virtual const std::vector<Parameter>& parameters() const = 0;

    /// Predictions at `parameters` (in the order of parameters()).
    virtual Prediction predict(const Eigen::VectorXd& parameters) const = 0;

    /// The same without covariances, which a fit does not ask for at every step.
    virtual Prediction predict_mean(const Eigen::VectorXd& parameters) const {
        return predict(parameters);
    }

    /// The values alone.
    virtual Eigen::VectorXd values(const Eigen::VectorXd& parameters) const {
        return predict_mean(parameters).value;
    }

    /// Learns more about the neighbourhood of `parameters`, where a fit has arrived; the next
    /// predictions are centred there. `excess` is the factor by which the variance that simulation
    /// causes in the fit is too large: above 1, about so many times the work done so far is wanted.
    virtual void improve(const Eigen::VectorXd& parameters, double excess) = 0;

    virtual Supported supported() const = 0;

    /// Whether what the model learned last agrees with what it had said before.
    virtual bool confirmed() const { return true; }
};

/// A model of any condition of shear, such as the simulation behind the readings of a study.
class FlowModel : public Model {
  public:
    /// Makes these the conditions of the readings that `predict` predicts.
    void predict_for(std::vector<Condition> conditions) { conditions_ = std::move(conditions); }
    /// Makes these the direct measurements that `predict` predicts after the readings.
    void predict_direct(std::vector<DirectMeasurement> direct) { direct_ = std::move(direct); }

    Prediction predict(const Eigen::VectorXd& parameters) const final {
        return with_direct(parameters, predict_conditions(parameters, conditions_));
    }

    Prediction predict_mean(const Eigen::VectorXd& parameters) const final {
        return with_direct(parameters, predict_mean_conditions(parameters, conditions_));
    }

    Eigen::VectorXd values(const Eigen::VectorXd& parameters) const final {
        return with_direct(parameters, values_of_conditions(parameters, conditions_));
    }

    /// Predictions of readings, and after them those of the direct measurements.
    Prediction with_direct(const Eigen::VectorXd& parameters, Prediction readings) const;
    /// The same of the values alone.
    Eigen::VectorXd with_direct(const Eigen::VectorXd& parameters, Eigen::VectorXd readings) const;

    /// Predictions at `parameters` of readings at these conditions.
    virtual Prediction predict_conditions(const Eigen::VectorXd& parameters,
                                          const std::vector<Condition>& conditions) const = 0;

    /// The same without covariances.
    virtual Prediction predict_mean_conditions(const Eigen::VectorXd& parameters,
                                               const std::vector<Condition>& conditions) const {
        return predict_conditions(parameters, conditions);
    }

    /// The values alone.
    virtual Eigen::VectorXd values_of_conditions(const Eigen::VectorXd& parameters,
                                                 const std::vector<Condition>& conditions) const {
        return predict_mean_conditions(parameters, conditions).value;
    }

    /// Makes wet runs around `parameters`, `turns` more for each wet setting; predictions of dry
    /// readings stay as they are.
    virtual void learn_wet(const Eigen::VectorXd& parameters, int turns) = 0;

    /// (stress ratio [1], solid fraction [1]) with their covariance.
    struct Point {
        Eigen::Vector2d value;
        Eigen::Matrix2d covariance;
    };
    /// Prediction for one condition, for curves.
    Point predict_at(const Eigen::VectorXd& parameters, const Condition& condition) const;

  protected:
    const std::vector<Condition>& conditions() const { return conditions_; }
    Eigen::Index direct_count() const { return static_cast<Eigen::Index>(direct_.size()); }

  private:
    std::vector<Condition> conditions_;
    std::vector<DirectMeasurement> direct_;
};

}  // namespace pendular
