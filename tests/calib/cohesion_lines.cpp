// Mohr-Coulomb lines through stress ratios whose answer is known in closed form.
#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "calib/fit/cohesion_lines.h"
#include "tests/support/golden.h"

namespace calib_cohesion_lines_test {

using namespace pendular;

const GrainProperties grains{.diameter = 500e-6, .density = 1050};
const Liquid oil{.surface_tension = 20.6e-3};
const double unit =
    pull_off_force(grains, oil) / (grains.diameter * grains.diameter);  // F0/a^2 [Pa]

/// A wet reading at a reduced pressure, its stress ratio with a standard error.
Reading reading(double pressure, double ratio, double error = 0.003, double content = 0.03,
                double inertial_number = 0) {
    Reading r;
    r.condition = {.normal_stress = pressure * unit,
                   .inertial_number = inertial_number,
                   .liquid_content = content};
    r.value = {ratio * r.condition.normal_stress, 0.6};
    r.covariance(0, 0) = std::pow(error * r.condition.normal_stress, 2);
    r.covariance(1, 1) = 1e-6;
    return r;
}

double on_line(double pressure, double intercept = 0.26, double cohesion = 0.3) {
    return intercept + cohesion / pressure;
}

std::vector<Reading> on_line(const std::vector<double>& pressures) {
    std::vector<Reading> readings;
    for (const double p : pressures)
        readings.push_back(reading(p, on_line(p)));
    return readings;
}

struct Lines {
    std::vector<CohesionLine> lines;
    std::vector<std::string> notes;
};
Lines measured(const std::vector<Reading>& readings, const CohesionOptions& options = {}) {
    Lines result;
    const Measured all = stack(readings);
    result.lines = cohesion_lines(
        readings, {"measured", all.value, all.covariance + all.widening, all.covariance}, grains,
        oil, options, &result.notes);
    return result;
}
/// Lines through predicted stress ratios with this covariance.
Lines simulated(const std::vector<Reading>& readings, const Eigen::VectorXd& ratios,
                const Eigen::MatrixXd& covariance) {
    const auto n = ratios.size();
    Prediction prediction;
    prediction.value = Eigen::VectorXd::Constant(2 * n, 0.6);
    prediction.covariance = Eigen::MatrixXd::Identity(2 * n, 2 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto stress = [&](Eigen::Index k) {
            return readings[static_cast<std::size_t>(k)].condition.normal_stress;
        };
        prediction.value(2 * i) = ratios(i) * stress(i);
        for (Eigen::Index j = 0; j < n; ++j)
            prediction.covariance(2 * i, 2 * j) = covariance(i, j) * stress(i) * stress(j);
    }
    Lines result;
    result.lines = cohesion_lines(
        readings,
        {"simulated", prediction.value, prediction.covariance, stack(readings).covariance}, grains,
        oil, {});
    return result;
}

/// Generalised least squares in closed form: C = (A' W A)^-1, theta = C A' W y.
struct ClosedForm {
    Eigen::Vector2d line;
    Eigen::Matrix2d covariance;
};
ClosedForm closed_form(const std::vector<double>& pressures, const Eigen::VectorXd& ratios,
                       const Eigen::MatrixXd& covariance) {
    Eigen::MatrixXd a(ratios.size(), 2);
    for (Eigen::Index k = 0; k < ratios.size(); ++k)
        a.row(k) << 1, 1 / pressures[static_cast<std::size_t>(k)];
    const Eigen::MatrixXd weight = covariance.inverse();
    const Eigen::Matrix2d c = (a.transpose() * weight * a).inverse();
    return {c * a.transpose() * weight * ratios, c};
}

void expect_is(const CohesionLine& line, const ClosedForm& expected) {
    const double e0 = std::sqrt(expected.covariance(0, 0));
    const double e1 = std::sqrt(expected.covariance(1, 1));
    EXPECT_NEAR(line.stress_ratio_intercept.value, expected.line(0), 1e-6 * e0);
    EXPECT_NEAR(line.reduced_cohesion.value, expected.line(1), 1e-6 * e1);
    EXPECT_NEAR(line.stress_ratio_intercept.standard_error, e0, 1e-6 * e0);
    EXPECT_NEAR(line.reduced_cohesion.standard_error, e1, 1e-6 * e1);
    EXPECT_NEAR(line.correlation, expected.covariance(0, 1) / (e0 * e1), 1e-6);
}

TEST(CohesionLines, RecoverAnExactLine) {
    const Lines found = measured(on_line({2.5, 4, 8, 24}));
    ASSERT_EQ(found.lines.size(), 1u);
    const CohesionLine& line = found.lines[0];
    EXPECT_EQ(line.source, "measured");
    EXPECT_NEAR(line.stress_ratio_intercept.value, 0.26, 1e-9);
    EXPECT_NEAR(line.reduced_cohesion.value, 0.3, 1e-9);
    EXPECT_NEAR(line.cohesion.value, 0.3 * 129.43, 0.003);  // F0/a^2 = 129.43 Pa
    EXPECT_NEAR(line.cohesion.standard_error / line.cohesion.value,
                line.reduced_cohesion.standard_error / 0.3, 1e-9);
    EXPECT_NEAR(line.chi2, 0, 1e-9);
    EXPECT_EQ(line.points, 4);
    EXPECT_EQ(line.dof, 2);
    EXPECT_NEAR(line.lowest_reduced_pressure, 2.5, 1e-9);
    EXPECT_NEAR(stress_ratio(line, 5), 0.32, 1e-9);
    EXPECT_TRUE(found.notes.empty());
}

TEST(CohesionLines, AreWeightedLeastSquaresOfIndependentPoints) {
    // Errors that differ tenfold and values off the line, so that weights matter.
    const std::vector<double> pressures = {2.4, 3.5, 7, 20};
    const Eigen::Vector4d ratios(0.40, 0.33, 0.31, 0.27), errors(0.02, 0.002, 0.01, 0.004);
    std::vector<Reading> readings;
    for (Eigen::Index k = 0; k < 4; ++k)
        readings.push_back(reading(pressures[static_cast<std::size_t>(k)], ratios(k), errors(k)));
    const Eigen::MatrixXd covariance = errors.cwiseAbs2().asDiagonal();
    const ClosedForm expected = closed_form(pressures, ratios, covariance);
    const Lines found = measured(readings);
    ASSERT_EQ(found.lines.size(), 1u);
    expect_is(found.lines[0], expected);
    double chi2 = 0;
    for (Eigen::Index k = 0; k < 4; ++k) {
        const double at = expected.line(0) + expected.line(1) / pressures[std::size_t(k)];
        chi2 += std::pow((ratios(k) - at) / errors(k), 2);
    }
    EXPECT_NEAR(found.lines[0].chi2, chi2, 1e-6 * chi2);
    // Slope up, intercept down.
    EXPECT_LT(found.lines[0].correlation, -0.5);
}

TEST(CohesionLines, OfPredictionsAreThoseOfTheReadingsWithThePredictionsErrors) {
    // Given out of order, which must not matter. The estimator K is that of the readings, whose
    // errors are alike; the errors are K C K' with the covariance C of the predictions.
    const std::vector<double> pressures = {8, 2.5, 4, 16};
    const Eigen::Vector4d ratios(0.30, 0.39, 0.335, 0.275);
    Eigen::Matrix4d root;
    root << 4, 0, 0, 0, 3, 2, 0, 0, 3, 1, 2, 0, 2, -1, 1, 3;
    const Eigen::Matrix4d covariance = 1e-6 * root * root.transpose();
    const Lines found = simulated(on_line(pressures), ratios, covariance);
    ASSERT_EQ(found.lines.size(), 1u);
    EXPECT_EQ(found.lines[0].source, "simulated");
    Eigen::MatrixXd a(4, 2);
    for (Eigen::Index k = 0; k < 4; ++k)
        a.row(k) << 1, 1 / pressures[static_cast<std::size_t>(k)];
    const Eigen::MatrixXd estimator = (a.transpose() * a).inverse() * a.transpose();
    expect_is(found.lines[0], {estimator * ratios, estimator * covariance * estimator.transpose()});
    // An error common to all points moves the intercept alone.
    const Eigen::MatrixXd common = covariance + Eigen::MatrixXd::Constant(4, 4, 25e-6);
    const Lines shifted = simulated(on_line(pressures), ratios, common);
    EXPECT_EQ(shifted.lines[0].reduced_cohesion.value, found.lines[0].reduced_cohesion.value);
    EXPECT_NEAR(shifted.lines[0].reduced_cohesion.standard_error,
                found.lines[0].reduced_cohesion.standard_error, 1e-8);
    EXPECT_NEAR(std::pow(shifted.lines[0].stress_ratio_intercept.standard_error, 2) -
                    std::pow(found.lines[0].stress_ratio_intercept.standard_error, 2),
                25e-6, 1e-10);
}

TEST(CohesionLines, OfPredictionsStayAmongTheirPoints) {
    // A bent curve known but for an error common to all points and a tiny one of each: weights by
    // the predictions' own covariance would let their small differences throw the line far off.
    const std::vector<double> pressures = {2.5, 4, 8, 20};
    Eigen::Vector4d ratios;
    for (Eigen::Index k = 0; k < 4; ++k) {
        const double u = 1 / pressures[static_cast<std::size_t>(k)];
        ratios(k) = 0.26 + 0.33 * u - 0.05 * u * u;
    }
    const Eigen::Matrix4d covariance =
        1e-4 * ratios * ratios.transpose() + 1e-10 * Eigen::Matrix4d::Identity();
    const CohesionLine line = simulated(on_line(pressures), ratios, covariance).lines.at(0);
    for (Eigen::Index k = 0; k < 4; ++k)
        EXPECT_NEAR(stress_ratio(line, pressures[std::size_t(k)]), ratios(k), 0.002);
}

TEST(CohesionLines, CoverTheTruthAsOftenAsTheirErrorsSay) {
    // 400 sets of five points with normal noise: chi2 of (intercept, c*) about the truth has two
    // degrees of freedom and is below 2.279 in 68 % of them. The count is binomial; its limits here
    // are passed by chance in 1 of 1000 (3.3 sigma = 31).
    std::mt19937 random(17);
    std::normal_distribution<double> normal;
    const std::vector<double> pressures = {2.4, 3, 4.6, 8, 23};
    constexpr int sets = 400;
    int covered = 0;
    double squares = 0;
    for (int set = 0; set < sets; ++set) {
        std::vector<Reading> readings;
        for (const double p : pressures) {
            const double error = 0.002 + 0.01 / p;
            readings.push_back(reading(p, on_line(p) + error * normal(random), error));
        }
        const CohesionLine line = measured(readings).lines.at(0);
        const double z0 =
            (line.stress_ratio_intercept.value - 0.26) / line.stress_ratio_intercept.standard_error;
        const double z1 =
            (line.reduced_cohesion.value - 0.3) / line.reduced_cohesion.standard_error;
        const double r = line.correlation;
        covered += (z0 * z0 - 2 * r * z0 * z1 + z1 * z1) / (1 - r * r) < 2.279;
        squares += line.chi2;
    }
    EXPECT_NEAR(covered, 0.68 * sets, 31);
    // chi2 adds up to 3 x 400 degrees of freedom, +- sqrt(2 x 1200) = 49.
    EXPECT_NEAR(squares, 3 * sets, 3.3 * 49);
}

TEST(CohesionLines, LeaveOutPointsBelowTheLimitAndSayByHowMuchTheyAreOverestimated) {
    // The case of Badetti et al. (2018): readings at P* = 1 and 0.5 lie below the line.
    auto readings = on_line({2.3, 4, 10});
    readings.push_back(reading(1, 0.52, 0.004));
    readings.push_back(reading(0.5, 0.72, 0.005));
    const Lines found = measured(readings);
    ASSERT_EQ(found.lines.size(), 1u);
    const CohesionLine& line = found.lines[0];
    EXPECT_EQ(line.points, 3);  // 2.3 itself is in, whatever rounding does to it
    EXPECT_NEAR(line.reduced_cohesion.value, 0.3, 1e-9);
    ASSERT_EQ(line.below.size(), 2u);
    EXPECT_NEAR(line.below[0].reduced_pressure, 1, 1e-9);
    EXPECT_NEAR(line.below[0].relative.value, 0.56 / 0.52 - 1, 1e-8);
    EXPECT_NEAR(line.below[1].relative.value, 0.86 / 0.72 - 1, 1e-8);
    // Independent: the line's error and the point's, propagated.
    const double e0 = line.stress_ratio_intercept.standard_error;
    const double e1 = line.reduced_cohesion.standard_error;
    const double of_line = std::sqrt(e0 * e0 + e1 * e1 + 2 * line.correlation * e0 * e1);
    EXPECT_NEAR(line.below[0].relative.standard_error,
                std::hypot(of_line / 0.52, 0.56 * 0.004 / (0.52 * 0.52)), 1e-7);
    expect_told(found.notes);
    // Replicates are named once.
    readings.push_back(reading(1, 0.53, 0.004));
    EXPECT_EQ(measured(readings).notes, found.notes);
    readings.pop_back();

    // Another limit takes one of them in.
    const Lines lower = measured(readings, {.lowest_reduced_pressure = 0.9});
    EXPECT_EQ(lower.lines.at(0).points, 4);
    EXPECT_EQ(lower.lines.at(0).below.size(), 1u);
    EXPECT_LT(lower.lines.at(0).reduced_cohesion.value, 0.3);
}

TEST(CohesionLines, OverestimatesOfPredictionsKnowTheirCommonError) {
    // All points known but for one common relative factor: the ratio line/value is known exactly
    // up to the points' small own errors.
    const std::vector<double> pressures = {2.5, 5, 10, 1};
    Eigen::Vector4d ratios;
    for (Eigen::Index k = 0; k < 4; ++k)
        ratios(k) = on_line(pressures[std::size_t(k)]);
    const Eigen::MatrixXd own = 1e-8 * Eigen::MatrixXd::Identity(4, 4);
    const Eigen::MatrixXd common = 0.05 * 0.05 * ratios * ratios.transpose();
    const auto with = simulated(on_line(pressures), ratios, own + common).lines.at(0);
    const auto without = simulated(on_line(pressures), ratios, own).lines.at(0);
    ASSERT_EQ(with.below.size(), 1u);
    EXPECT_NEAR(with.below[0].relative.value, 0, 1e-6);
    EXPECT_NEAR(with.below[0].relative.standard_error, without.below[0].relative.standard_error,
                0.01 * without.below[0].relative.standard_error);
    EXPECT_GT(with.reduced_cohesion.standard_error, 0.01);
}

TEST(CohesionLines, GroupByLiquidContentAndInertialNumber) {
    std::vector<Reading> readings;
    for (const double p : {3.0, 6.0, 12.0}) {
        readings.push_back(reading(p, on_line(p, 0.26, 0.35), 0.003, 0.03, 0.01));
        readings.push_back(reading(p, on_line(p, 0.26, 0.25), 0.003, 0.007, 0.01));
        readings.push_back(reading(p, on_line(p, 0.25, 0.25), 0.003, 0.007, 0));
        readings.push_back(reading(p, on_line(p, 0.30, 0.25), 0.003, 0.007, 0.03));
        readings.push_back(reading(p, 0.26, 0.003, 0, 0.01));  // dry
    }
    // 1.5 % more liquid and 15 % faster are the same group.
    readings.push_back(reading(4, on_line(4, 0.26, 0.35), 0.003, 0.03045, 0.0115));
    const Lines found = measured(readings);
    ASSERT_EQ(found.lines.size(), 4u);
    const double intercepts[] = {0.25, 0.26, 0.30, 0.26}, cohesions[] = {0.25, 0.25, 0.25, 0.35};
    const double numbers[] = {0, 0.01, 0.03, 0.010375};
    const int points[] = {3, 3, 3, 4};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(found.lines[k].stress_ratio_intercept.value, intercepts[k], 1e-9);
        EXPECT_NEAR(found.lines[k].reduced_cohesion.value, cohesions[k], 1e-9);
        EXPECT_NEAR(found.lines[k].inertial_number, numbers[k], 1e-12);
        EXPECT_EQ(found.lines[k].points, points[k]);
    }
    EXPECT_TRUE(found.notes.empty());
    EXPECT_TRUE(measured({reading(3, 0.26, 0.003, 0), reading(9, 0.26, 0.003, 0)}).notes.empty());
}

TEST(CohesionLines, LeaveOutPointsOfFailure) {
    std::vector<Reading> readings = on_line({3, 6, 12});
    for (const double p : {2.5, 5.0, 10.0}) {
        readings.push_back(reading(p, on_line(p, 0.4, 0.5)));
        readings.back().condition.at_failure = true;
    }
    const Lines found = measured(readings);
    ASSERT_EQ(found.lines.size(), 1u);
    EXPECT_EQ(found.lines[0].points, 3);
    EXPECT_NEAR(found.lines[0].reduced_cohesion.value, 0.3, 1e-9);
    EXPECT_THAT(found.notes, testing::IsEmpty());
}

TEST(CohesionLines, NoteGroupsThatHaveNone) {
    // Two readings 1 % apart in P*, and one that is too low.
    const Lines close = measured(on_line({4, 4.04, 1}));
    EXPECT_TRUE(close.lines.empty());
    expect_told(close.notes);
    expect_told(measured(on_line({0.5, 1, 2})).notes);
    EXPECT_EQ(measured(on_line({4, 4.2})).lines.size(), 1u);
}

TEST(CohesionLines, TakeReplicatesOfWhichAModelSaysTheSame) {
    // The covariance of their predictions is singular; each counts with its reading's weight.
    const std::vector<double> pressures = {3, 3, 6, 6, 12};
    const Eigen::Vector3d ratios(0.37, 0.30, 0.285);
    Eigen::Matrix3d covariance;
    covariance << 9, 3, 1, 3, 4, 1, 1, 1, 4;
    covariance *= 1e-6;
    const std::vector<Eigen::Index> repeat = {0, 0, 1, 1, 2};
    const Lines found = simulated(on_line(pressures), ratios(repeat), covariance(repeat, repeat));
    ASSERT_EQ(found.lines.size(), 1u);
    EXPECT_EQ(found.lines[0].points, 5);
    const auto measured_line = measured([&] {
                                   auto readings = on_line(pressures);
                                   for (std::size_t k = 0; k < 5; ++k)
                                       readings[k].value(0) =
                                           ratios(repeat[k]) * readings[k].condition.normal_stress;
                                   return readings;
                               }())
                                   .lines.at(0);
    EXPECT_NEAR(found.lines[0].reduced_cohesion.value, measured_line.reduced_cohesion.value, 1e-9);
    EXPECT_TRUE(std::isfinite(found.lines[0].reduced_cohesion.standard_error));
}

}  // namespace calib_cohesion_lines_test
