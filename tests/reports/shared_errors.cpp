// What calibrate says of walls of unknown friction.
#include "reports/shared_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shared_errors_test {

using namespace pendular;
using testing::HasSubstr;
using testing::Not;

InstrumentError error_of(const std::string& name, double standard, double shift) {
    return {.name = name,
            .standard = standard,
            .assumed = true,
            .counts = false,
            .shift = Eigen::VectorXd::Constant(1, shift)};
}

/// Friction fitted by an instrument of typical errors.
Calibration fitted(bool known_walls) {
    Calibration c;
    c.parameters = {{.name = "friction", .lower = 0, .upper = 0.6}};
    c.fit.parameters = Eigen::VectorXd::Constant(1, 0.15);
    c.fit.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-5);
    c.fit.range = {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 0.6)};
    c.fit.instrument = {error_of("torque-gain", 0.02, 0.008)};
    if (!known_walls) c.fit.instrument.push_back(error_of("wall_friction", 0.088, 0.04));
    return c;
}

std::string lines_of(const Calibration& c) {
    Output output;
    add_shared_errors(output, c);
    std::string text;
    for (const Output::Part& part : output.parts())
        text += part.lines.front() + "\n";
    return text;
}

TEST(SharedErrors, NameTheWallsOfWhichNothingIsKnown) {
    const Calibration c = fitted(false);
    EXPECT_EQ(systematic_text(c),
              " +- 0.041 (systematic: typical errors of an instrument, as study.toml states none, "
              "and walls of unknown friction, 0.04)");
    EXPECT_THAT(lines_of(c), HasSubstr("0.041: wall_friction (unknown, 0 to 0.3) gives 0.04, "
                                       "torque-gain 2 % gives 0.008."));
    EXPECT_THAT(lines_of(c), HasSubstr("the fitted intergranular friction coefficient may be too "
                                       "large by 0.04. State wall_friction in [cell]"));
}

TEST(SharedErrors, AreSilentOnWallsThatAreKnown) {
    const Calibration c = fitted(true);
    EXPECT_EQ(systematic_text(c),
              " +- 0.008 (systematic: typical errors of an instrument, as study.toml states none)");
    EXPECT_THAT(lines_of(c), Not(HasSubstr("wall")));
    EXPECT_THAT(lines_of(c), HasSubstr("State yours in [instrument]"));
}

}  // namespace shared_errors_test
