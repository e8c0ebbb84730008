// The installed interface, of which other programs know nothing but its header.
#include "include/pendular/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/golden.h"

namespace pendular::workflow_public_session_test {

namespace fs = std::filesystem;

class PublicSessions : public testing::Test {
  protected:
    PublicSessions() {
        fs::copy(fs::path(PENDULAR_SOURCE_DIR) / "examples/hidden-effect", study_,
                 fs::copy_options::recursive);
        fs::remove_all(study_ / "out");
    }

    TemporaryFolder folder_;
    const fs::path study_ = folder_.path() / "study";
};

TEST_F(PublicSessions, PredictWhatTheyFitted) {
    const v1::Session session(study_, {.fidelity = "quick"});
    const v1::Fit fit = session.calibrate();
    EXPECT_NEAR(session.compare().chi2, fit.chi2, 1e-9 * fit.chi2);
    const v1::Reading& reading = fit.readings.front();
    const auto predicted = session.predict(
        {{.normal_stress = reading.normal_stress, .inertial_number = reading.inertial_number}});
    ASSERT_EQ(predicted.size(), 1u);
    // The model has no effect on the instrument, so that a height changes nothing.
    EXPECT_NEAR(predicted[0].shear_stress, reading.predicted_shear_stress,
                1e-9 * reading.predicted_shear_stress);
    EXPECT_NEAR(predicted[0].solid_fraction, reading.predicted_solid_fraction, 1e-9);
    EXPECT_GT(predicted[0].shear_stress_error, 0);
    EXPECT_LT(predicted[0].shear_stress_error, 0.05 * reading.predicted_shear_stress);
}

TEST_F(PublicSessions, RefuseWhatCannotBeSimulated) {
    const v1::Session session(study_, {.fidelity = "quick"});
    EXPECT_THROW(session.compare(), v1::InputError);
    session.calibrate();
    try {
        session.predict({{.normal_stress = 1000}, {.normal_stress = 1000, .inertial_number = 3}});
        FAIL() << "nothing was refused";
    } catch (const v1::InputError& error) {
        expect_told({error.what()});
    }
}

TEST_F(PublicSessions, SayWhatToMeasureNext) {
    const v1::Suggestion next = v1::Session(study_, {.fidelity = "quick"}).next();
    EXPECT_EQ(next.rivals, std::vector<std::string>{"wall-friction"});
    ASSERT_EQ(next.readings.size(), 1u);
    EXPECT_GT(next.readings[0].at.normal_stress, 0);
    EXPECT_GE(next.readings[0].repeats, 1);
}

}  // namespace pendular::workflow_public_session_test
