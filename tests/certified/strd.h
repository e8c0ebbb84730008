#pragma once

#include <ceres/jet.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "calib/fit/fit.h"
#include "data/files/csv.h"

/// Statistical Reference Datasets of NIST, https://www.itl.nist.gov/div898/strd, and models that
/// are a formula with exact derivatives.
namespace strd {

/// The residuals of Lanczos1 are 1e-13 of its readings: double precision would leave three digits
/// of their sum of squares.
using Real = long double;
/// A value with its derivatives by the parameters; ENSO has nine of them, the most.
using Jet = ceres::Jet<Real, 9>;
using Formula = Jet (*)(const Jet* b, const Real* x);

/// A table of numbers.
using Numbers = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
Numbers read_numbers(const std::string& file);

/// A data set with what is certified of it.
struct DataSet {
    std::string name;
    Formula formula;
    Numbers x;  ///< a row for each observation
    Eigen::Vector<Real, Eigen::Dynamic> y;
    pendular::Measured measured;                  ///< y - y = 0, unweighted: unit covariance
    std::vector<pendular::Parameter> parameters;  ///< with generous ranges
    Eigen::VectorXd start[2];
    Eigen::VectorXd certified, standard_deviation;
    double residual_sum = 0;  ///< of squares
    double residual_deviation = 0;
};
DataSet data_set(const std::string& name);

/// Names of all nonlinear data sets.
std::vector<std::string> names();

/// A formula less the readings y, as a model without errors of its own.
class FormulaModel : public pendular::Model {
  public:
    explicit FormulaModel(const DataSet& set) : set_(set) {}

    const std::vector<pendular::Parameter>& parameters() const override { return set_.parameters; }
    pendular::Prediction predict(const Eigen::VectorXd& parameters,
                                 pendular::PredictionPart what) const override;
    pendular::ParameterBounds bounds() const override;

    mutable int evaluations = 0;

  private:
    const DataSet& set_;
};

/// Number of significant digits in which x agrees with a certified value c,
///     LRE = -log10(|x - c|/|c|),
/// and 11, as many as are certified, where it would be more.
inline double digits(double x, double c) {
    return std::min(11.0, -std::log10(std::abs(x - c) / std::abs(c)));
}
double fewest_digits(const Eigen::VectorXd& x, const Eigen::VectorXd& c);

/// Standard deviations of the parameters of an unweighted fit, whose residuals tell the error of an
/// observation: s_k = sqrt(C_kk chi2/dof).
Eigen::VectorXd standard_deviations(const pendular::Fit& fit);

}  // namespace strd
