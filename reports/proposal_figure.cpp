#include "reports/proposal_figure.h"

#include <cmath>
#include <map>

#include "reports/figure_style.h"

namespace pendular {
namespace {

struct ShapeAxis {
    std::string label;
    std::vector<double> at;  ///< value of each reading
};

/// Horizontal axis: the quantity with which the first varying change of the proposal varies.
ShapeAxis axis_of(const Proposal& proposal, const std::vector<Reading>& readings) {
    static const std::map<std::string, const char*, std::less<>> labels = {
        {"normal_stress", "normal stress σ_{22} [Pa]"},
        {"inertial_number", "inertial number I"},
        {"angular_velocity", "angular velocity [rad/s]"},
        {"liquid_content", "liquid content Φ_L/Φ_S"},
        {"time", "time since the first recording began [s]"}};
    for (const FittedShape& fitted : proposal.shapes) {
        const Profile& profile = fitted.shape.profile;
        if (!profile.variable.empty()) {
            return {labels.at(profile.variable), {profile.along.begin(), profile.along.end()}};
        }
    }
    ShapeAxis axis{labels.at("normal_stress"), {}};
    for (const Reading& reading : readings) {
        axis.at.push_back(reading.condition.normal_stress);
    }
    return axis;
}

}  // namespace

Figure proposal_figure(const Proposal& proposal, const std::vector<Reading>& readings,
                       const Prediction& model) {
    const ShapeAxis axis = axis_of(proposal, readings);
    Figure figure{.name = "proposal", .title = "Change of unknown cause"};
    for (const Eigen::Index observable : {0, 1}) {
        Panel panel{.x_label = axis.label,
                    .y_label = observable == 0 ? "deviation of shear stress from the model [%]"
                                               : "deviation of solid fraction from the model [%]",
                    .log_x = spans_decade(axis.at),
                    .zero_line = true,
                    .key = observable == 0 ? Key::top_left : Key::none,
                    .headroom = 0.2};
        Curve measured{.label = "measured", .colour = measured_colour},
            changed{.label = "model with the change",
                    .colour = model_colour,
                    .symbol = {Shape::square, Filling::hollow}};
        for (std::size_t k = 0; k < readings.size(); ++k) {
            const Eigen::Index at = 2 * static_cast<Eigen::Index>(k) + observable;
            const double whole = model.value(at) / 100;
            measured.x.push_back(axis.at[k]);
            measured.y.push_back(readings[k].value(observable) / whole - 100);
            measured.y_error.push_back(std::sqrt(readings[k].covariance(observable, observable)) /
                                       whole);
            changed.x.push_back(axis.at[k]);
            changed.y.push_back(proposal.model.fit.prediction.value(at) / whole - 100);
        }
        panel.curves = {measured, changed};
        figure.panels.push_back(std::move(panel));
    }
    return figure;
}

}  // namespace pendular
