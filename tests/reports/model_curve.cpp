// Into which series the figures divide readings, each with a curve of its own.
#include "reports/model_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace pendular {
namespace {

using testing::ElementsAre;

/// Shear stress sigma_22 (0.3 + I) + offset, solid fraction 0.6.
class Line : public Predictor {
  public:
    explicit Line(double offset) : offset_(offset) {}
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    ParameterBounds bounds() const override {
        return {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1)};
    }
    Prediction predict(const Eigen::VectorXd&, const std::vector<Condition>& conditions,
                       PredictionPart) const override {
        Prediction prediction;
        prediction.value.resize(2 * std::ssize(conditions));
        for (std::size_t k = 0; k < conditions.size(); ++k) {
            const Condition& c = conditions[k];
            prediction.value.segment<2>(2 * static_cast<Eigen::Index>(k))
                << c.normal_stress * (0.3 + c.inertial_number) + offset_,
                0.6;
        }
        return prediction;
    }

  private:
    double offset_;
    std::vector<Parameter> parameters_ = {{.name = "friction"}};
};

struct Place {
    double normal_stress, inertial_number;
};

/// Series of readings with errors of 1 % of the shear stress that the model predicts exactly.
std::vector<CurveGroup> series_of(const std::vector<Place>& places, const Line& model) {
    Calibration c;
    c.fit.parameters = Eigen::VectorXd::Constant(1, 0.3);
    std::vector<std::size_t> all;
    std::vector<Condition> conditions;
    for (const Place& place : places) {
        conditions.push_back(
            {.normal_stress = place.normal_stress, .inertial_number = place.inertial_number});
        all.push_back(all.size());
    }
    c.prediction = model.predict(c.fit.parameters, conditions, PredictionPart::values);
    for (std::size_t k = 0; k < places.size(); ++k) {
        Reading reading{.condition = conditions[k]};
        reading.value = c.prediction.value.segment<2>(2 * static_cast<Eigen::Index>(k));
        reading.covariance = (0.01 * reading.value).cwiseAbs2().asDiagonal();
        c.readings.push_back(reading);
    }
    return curve_groups(all, model, c, along_inertial_number,
                        {Apart::normal_stress, Apart::bead_volume, Apart::file});
}

std::vector<std::size_t> sizes(const std::vector<CurveGroup>& series) {
    std::vector<std::size_t> result;
    for (const CurveGroup& each : series) {
        EXPECT_TRUE(each.curve) << each.name;
        result.push_back(each.members.size());
    }
    return result;
}

/// Two speeds of the lid: at each, the inertial number falls with the normal stress.
const std::vector<Place> two_speeds = {{600, 0.004}, {1500, 0.0025}, {6000, 0.00125},
                                       {600, 0.02},  {1500, 0.0125}, {6000, 0.00625}};

TEST(CurveGroups, DivideByNormalStressWhereACurveWouldBend) {
    const Line with_offset(20);
    EXPECT_THAT(sizes(series_of(two_speeds, with_offset)), ElementsAre(2, 2, 2));
}

TEST(CurveGroups, AreOneWhereTheNormalStressDoesNotMatter) {
    EXPECT_THAT(sizes(series_of(two_speeds, Line(0))), ElementsAre(6));
}

TEST(CurveGroups, AreOneWhereTheNormalStressOnlyFalls) {
    const std::vector<Place> one_speed(two_speeds.begin(), two_speeds.begin() + 3);
    EXPECT_THAT(sizes(series_of(one_speed, Line(20))), ElementsAre(3));
}

TEST(CurveGroups, KeepOneCurveWhereThereAreTooManyNormalStresses) {
    std::vector<Place> many;
    for (int k = 0; k < 9; ++k) {
        const double stress = 500 * std::pow(1.3, k);
        for (const double number : {0.1, 0.5}) {
            many.push_back({stress, number / std::sqrt(stress)});
        }
    }
    EXPECT_THAT(sizes(series_of(many, Line(20))), ElementsAre(18));
}

}  // namespace
}  // namespace pendular
