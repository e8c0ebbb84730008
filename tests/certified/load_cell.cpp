// The calibration of a load cell (StRD "Pontius"), whose straight line has a certain lack of fit.
#include <gtest/gtest.h>

#include "strd.h"

namespace load_cell_test {

using namespace pendular;

strd::Jet line(const strd::Jet* b, const strd::Real* x) {
    return b[0] + x[0] * b[1];
}
strd::Jet parabola(const strd::Jet* b, const strd::Real* x) {
    return b[0] + x[0] * (b[1] + x[0] * b[2]);
}

/// The readings with a polynomial of so many coefficients.
strd::DataSet load_cell(strd::Formula formula, int coefficients) {
    const strd::Numbers readings = strd::read_numbers("Pontius.csv");
    const auto n = readings.rows();
    strd::DataSet set{.formula = formula, .x = readings.col(1), .y = readings.col(0)};
    set.measured = {Eigen::VectorXd::Zero(n), Eigen::MatrixXd::Identity(n, n)};
    for (int k = 0; k < coefficients; ++k) {
        set.parameters.push_back({.lower = -1, .upper = 1});
    }
    return set;
}

Fit fitted(const strd::DataSet& set) {
    const strd::FormulaModel model(set);
    return fit(model, set.measured, start_of(model));
}

/// Sum of squares of the readings about the mean of those at the same load: the second half repeats
/// the loads of the first, and two readings scatter by (y1 - y2)^2/2.
double pure_error(const strd::DataSet& set) {
    const auto half = set.y.size() / 2;
    EXPECT_TRUE(set.x.topRows(half) == set.x.bottomRows(half));
    return static_cast<double>((set.y.head(half) - set.y.tail(half)).squaredNorm() / 2);
}

/// F of the lack of fit: mean square of what the law misses of the means at the 20 loads over that
/// of the readings about these means.
///     F = ((S - P)/(20 - p)) / (P/20)
double lack_of_fit(const strd::DataSet& set) {
    const Fit result = fitted(set);
    const double pure = pure_error(set);
    return (result.chi2 - pure) / (20 - static_cast<double>(result.parameters.size())) /
           (pure / 20);
}

TEST(LoadCell, HasTheCertifiedParabola) {
    const strd::DataSet set = load_cell(parabola, 3);
    const Fit result = fitted(set);
    const Eigen::Vector3d certified(0.673565789473684e-3, 0.732059160401003e-6,
                                    -0.316081871345029e-14);
    const Eigen::Vector3d deviations(0.107938612033077e-3, 0.157817399981659e-9,
                                     0.486652849992036e-16);
    EXPECT_TRUE(result.converged) << result.message;
    // The readings have five digits, the arithmetic sixteen; ten leave room for other compilers.
    EXPECT_GE(strd::fewest_digits(result.parameters, certified), 10);
    EXPECT_GE(strd::fewest_digits(strd::standard_deviations(result), deviations), 10);
    EXPECT_GE(strd::digits(result.chi2, 0.155761768796992e-5), 10);
}

TEST(LoadCell, DoesNotLieOnAStraightLine) {
    // NIST/SEMATECH e-Handbook of Statistical Methods, 4.6.1: F = 214.7 for 18 and 20 degrees of
    // freedom, where chance stays below 2.15 in 95 % of all cases; the parabola passes.
    EXPECT_NEAR(lack_of_fit(load_cell(line, 2)), 214.7, 0.05);
    EXPECT_LT(lack_of_fit(load_cell(parabola, 3)), 2.17);
}

}  // namespace load_cell_test
