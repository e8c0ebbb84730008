// The calibration of a load cell (StRD "Pontius") as a diagnosis: a straight line, and what of a
// square, a cube, a root and a logarithm of the load it lacks. The square is known to be it:
// NIST/SEMATECH e-Handbook of Statistical Methods, 4.6.1.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/diagnosis/diagnosis.h"
#include "strd.h"
#include "tests/support/linear_space.h"

namespace load_cell_diagnosis_test {

using namespace pendular;

constexpr int loads = 20, readings = 2 * loads;

struct LoadCell {
    Eigen::VectorXd load, deflection;  ///< load in units of 1e6 lb
};

LoadCell load_cell() {
    const strd::Numbers table = strd::read_numbers("Pontius.csv");
    return {table.col(1).cast<double>() / 1e6, table.col(0).cast<double>()};
}

/// The verdict on the parabola depends on this choice: at 0.005 it is inconclusive, since a root or
/// a logarithm of that size could hide. What differs by 0.02 at full load, a hundredth of the
/// deflection there, would matter.
LinearSpace::Column column(const std::string& name, const Eigen::ArrayXd& shape) {
    return {.name = name,
            .values = shape / shape.abs().maxCoeff(),
            .parameter = {
                .name = "amplitude", .lower = -10, .upper = 10, .smallest_of_interest = 0.02}};
}

LinearSpace line_or_parabola(bool parabola) {
    const Eigen::ArrayXd x = load_cell().load.array();
    Eigen::MatrixXd base(readings, parabola ? 3 : 2);
    base.leftCols(2) << Eigen::VectorXd::Ones(readings), x.matrix();
    if (parabola) base.col(2) = x.square();
    std::vector<LinearSpace::Column> columns = {column("cube", x.cube()), column("root", x.sqrt()),
                                                column("logarithm", x.log())};
    if (!parabola) columns.push_back(column("square", x.square()));
    return {base, columns};
}

/// With the error that repeated loads show: each was applied twice, in the same order.
Evidence evidence() {
    const LoadCell cell = load_cell();
    const double variance =
        (cell.deflection.head(loads) - cell.deflection.tail(loads)).squaredNorm() / 2 / loads;
    Evidence result;
    result.measured = {cell.deflection, variance * Eigen::MatrixXd::Identity(readings, readings)};
    result.errors = ErrorKnowledge::known(readings);
    result.errors.freedom = {loads};
    for (Eigen::Index k = 0; k < loads; ++k) {
        result.conditions.push_back({k, k + loads});
    }
    return result;
}

TEST(LoadCellDiagnosis, HasThePublishedLackOfFit) {
    const LinearSpace space = line_or_parabola(false);
    const Evidence readings_twice = evidence();
    const Diagnosis d = diagnose(space, readings_twice);
    const WeightedResiduals residuals = d.residuals(readings_twice);
    const Eigen::MatrixXd means = residuals.means_over(readings_twice.conditions);
    EXPECT_NEAR((means.transpose() * residuals.residuals()).squaredNorm() / (loads - 2), 214.7,
                0.05);
    EXPECT_LT(d.base.lack_of_fit_p, 0.001);
}

TEST(LoadCellDiagnosis, NamesTheSquareAlone) {
    const LinearSpace space = line_or_parabola(false);
    const Diagnosis d = diagnose(space, evidence());
    EXPECT_EQ(d.verdict, Verdict::missing);
    EXPECT_THAT(d.effects, testing::ElementsAre("square"));
    EXPECT_EQ(space.candidates()[d.scan.front().candidate].name, "square");
}

TEST(LoadCellDiagnosis, FindsTheParabolaComplete) {
    EXPECT_EQ(diagnose(line_or_parabola(true), evidence()).verdict, Verdict::nothing_missing);
}

}  // namespace load_cell_diagnosis_test
