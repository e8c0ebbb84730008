// Errors that all readings of a study share: what they change, and what [instrument] may state.
#include "sim/catalogue/shared_uncertainty.h"

#include <cmath>

#include "sim/catalogue/instrument.h"
#include "tests/support/golden.h"

namespace sim_shared_uncertainty_test {

using namespace pendular;

const GrainProperties grains{.diameter = 5e-4, .density = 1050};
const AnnularCell stated_cell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 57e-6};

Study study_with(std::vector<StatedUncertainty> stated,
                 InstrumentTable::Class kind = InstrumentTable::Class::none) {
    return {.grains = grains,
            .liquid = Liquid{.surface_tension = 0.0206},
            .cell = stated_cell,
            .instrument = {.kind = kind, .stated = std::move(stated)}};
}

/// The error of one standard uncertainty of the first that is stated.
std::vector<ActiveEffect> error_of(const std::string& name, const std::string& value) {
    return shared_uncertainties(study_with({{name, value}})).front().error(false);
}

/// Cell of other radii and beads than stated, which shows a reading for true stresses and a true
/// solid fraction, if the true stress ratio and shear rate do not depend on the condition.
struct TrueCell {
    AnnularCell cell = stated_cell;
    double density = grains.density;
    double diameter = grains.diameter;
};

constexpr double true_stress = 800, ratio = 0.31, fraction = 0.59, true_number = 0.02;

void expect_shown(const std::vector<ActiveEffect>& error, const TrueCell& truth) {
    const GrainProperties beads{.diameter = truth.diameter, .density = truth.density};
    const double gap = height(fraction, truth.cell);
    const double rate = shear_rate_at(true_number, true_stress, beads);
    const double lid = angular_velocity(rate, gap, truth.cell);
    // As `import` would reduce it with the stated cell and beads.
    const double stress = normal_stress(normal_force(true_stress, truth.cell), stated_cell);
    const double shown_rate = shear_rate(lid, gap, stated_cell);
    const Condition shown{.normal_stress = stress,
                          .inertial_number = shown_rate / shear_rate_at(1, stress, grains),
                          .height = gap,
                          .bead_volume = stated_cell.bead_volume};
    const InstrumentMap map(error);
    const CellState state =
        map.truth(shown_state(shown, ratio * stress, fraction, stated_cell, grains));
    const Condition imposed = true_condition(shown, state, map);
    EXPECT_NEAR(imposed.normal_stress, true_stress, 1e-8 * true_stress);
    EXPECT_NEAR(imposed.inertial_number, true_number, 1e-8 * true_number);
    const Eigen::Vector2d reading =
        shown_reading({ratio * true_stress, fraction}, state, map, stated_cell);
    EXPECT_NEAR(reading(0), shear_stress(torque(ratio * true_stress, truth.cell), stated_cell),
                1e-6);
    EXPECT_NEAR(reading(1), solid_fraction(gap, stated_cell), 1e-10);
}

TEST(SharedUncertainty, ShowsWhatACellOfOtherRadiiShows) {
    TrueCell smaller;
    smaller.cell.inner_radius *= 1.02;
    expect_shown(error_of("inner_radius", "2 %"), smaller);
    TrueCell larger;
    larger.cell.outer_radius += 0.4e-3;
    expect_shown(error_of("outer_radius", "0.4 mm"), larger);
}

TEST(SharedUncertainty, ShowsWhatOtherBeadsShow) {
    TrueCell heavier;
    heavier.density *= 1.03;
    heavier.cell.bead_volume /= 1.03;  // a balance weighed them
    expect_shown(error_of("density", "3 %"), heavier);
    TrueCell more;
    more.cell.bead_volume *= 1.01;
    expect_shown(error_of("bead_mass", "1 %"), more);
    TrueCell coarser;
    coarser.diameter *= 1.05;
    expect_shown(error_of("diameter", "25 um"), coarser);
}

TEST(SharedUncertainty, IsReadInItsUnitOrAsAShare) {
    const auto all = shared_uncertainties(study_with({{"torque-gain", "1.5 %"},
                                                      {"torque-offset", "0.3 mN m"},
                                                      {"inner_radius", "0.21 mm"},
                                                      {"contact_angle", "5 deg"}}));
    EXPECT_DOUBLE_EQ(all[0].standard, 0.015);
    EXPECT_DOUBLE_EQ(all[1].standard, 0.3e-3);
    EXPECT_EQ(all[1].unit, "N m");
    EXPECT_DOUBLE_EQ(all[2].standard, 0.01);
    EXPECT_EQ(all[2].unit, "1");
    EXPECT_NEAR(all[3].standard, 0.0873, 1e-4);
    for (std::size_t k = 0; k < all.size(); ++k)
        EXPECT_EQ(all[k].counts, k < 4) << all[k].name;
}

TEST(SharedUncertainty, OfAClassHoldsForWhatIsNotStated) {
    const auto all = shared_uncertainties(
        study_with({{"torque-gain", "0.5 %"}}, InstrumentTable::Class::rheometer));
    EXPECT_DOUBLE_EQ(all.front().standard, 0.005);
    EXPECT_FALSE(all.front().assumed);
    EXPECT_EQ(std::ranges::count(all, "torque-gain", &SharedUncertainty::name), 1);
    for (const SharedUncertainty& each : all)
        EXPECT_NE(each.counts, each.unbudgeted) << each.name;
    const auto wall = std::ranges::find(all, "wall-friction", &SharedUncertainty::name);
    ASSERT_NE(wall, all.end());
    EXPECT_TRUE(wall->unbudgeted);
    EXPECT_TRUE(std::ranges::all_of(all.begin() + 1, all.end(), &SharedUncertainty::assumed));
}

TEST(SharedUncertainty, SaysWhatIsWrong) {
    std::vector<std::string> told;
    const auto tell = [&](const StatedUncertainty& stated, bool with_cell = true) {
        Study study = study_with({stated});
        if (!with_cell) study.cell.reset();
        try {
            shared_uncertainties(study);
            told.push_back(stated.name + " is accepted");
        } catch (const InputError& error) {
            told.emplace_back(error.what());
        }
    };
    tell({"torque_gain", "1 %", {"study.toml", 7, 3}});
    tell({"torque-gain", "1 mN m", {"study.toml", 7, 3}});
    tell({"torque-offset", "1 %", {"study.toml", 7, 3}});
    tell({"height-offset", "0 um", {"study.toml", 7, 3}});
    tell({"inner_radius", "30 mm", {"study.toml", 7, 3}});
    tell({"density", "20 g", {"study.toml", 7, 3}});
    tell({"torque-gain", "1 %", {"study.toml", 7, 3}}, false);
    tell({"shear_stress", "1 %", {"study.toml", 7, 3}});
    tell({"shear_stress", "1 %", {"study.toml", 7, 3}}, false);
    expect_told(told);
}

}  // namespace sim_shared_uncertainty_test
