#include "app/lab_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "data/input_error.h"
#include "data/quantities/units.h"
#include "data/recordings/measurements.h"
#include "sim/lab/lab_like.h"

namespace pendular::app {
namespace {

const std::map<std::string, StepOrder>& orders() {
    static const std::map<std::string, StepOrder> all = {{"as-listed", StepOrder::as_listed},
                                                         {"increasing", StepOrder::increasing},
                                                         {"decreasing", StepOrder::decreasing},
                                                         {"random", StepOrder::random},
                                                         {"up-and-down", StepOrder::up_and_down}};
    return all;
}

std::vector<std::string> names_of_orders() {
    return {"as-listed", "increasing", "decreasing", "random", "up-and-down"};
}

template <typename Word>
std::vector<double> list(const Word& word) {
    try {
        return quantities_in_si(word.text, Unit(word.unit));
    } catch (const std::invalid_argument& error) {
        throw InputError(fmt::format("--{}: {}", word.option, error.what()));
    }
}

/// Returns the single value of an option, which must be above 0 or, if `or_zero`, at least 0.
template <typename Word>
double single(const Word& word, bool or_zero = false) {
    const std::vector<double> values = list(word);
    if (values.size() != 1 || !(or_zero ? values.front() >= 0 : values.front() > 0)) {
        throw InputError(fmt::format("--{} \"{}\": one value {} is needed", word.option, word.text,
                                     or_zero ? "of 0 or more" : "above 0"));
    }
    return values.front();
}

/// Sets a value where the option is given.
template <typename Word, typename Value>
void take(const Word& word, Value& value, bool or_zero = false) {
    if (!word.text.empty()) value = single(word, or_zero);
}
template <typename Word>
void take_list(const Word& word, std::vector<double>& values) {
    if (!word.text.empty()) values = list(word);
}

}  // namespace

LabOptions::LabOptions(Options& options) {
    options.add("friction", &friction_,
                "hidden friction coefficient between grains [1] (default 0.09)");
    options.add(
        "like", &like_,
        "take beads, liquid, cell, set points and their order, number of replicates, rows, "
        "strain and scatter from this study; options other than set points replace single values",
        a_study());
    declare_set_points(options);
    declare_instrument(options);
    declare_beads(options);
}

void LabOptions::declare_set_points(Options& options) {
    options.add("dry-normal-stresses", &dry_normal_stresses_.text,
                "normal stresses of dry recordings, with a unit (default \"0.3, 1, 3 kPa\")");
    options.add("wet-normal-stresses", &wet_normal_stresses_.text,
                "normal stresses of wet recordings, with a unit (default \"0.3, 0.6, 1, 3 kPa\")");
    options.add("liquid-contents", &liquid_contents_.text,
                "liquid volume over grain volume [1] (default \"0.007, 0.03\")");
    options.add("inertial-numbers", &inertial_numbers_.text,
                "inertial numbers: shear rate times sqrt(m/(a s22)), with mass m and diameter a of "
                "a grain and normal stress s22 [1] (default \"0.003, 0.03\")");
    options.add(
        "speeds", &speeds_.text,
        "constant angular velocities of the lid in place of inertial numbers, with a unit, "
        "such as \"0.1, 1 rpm\"; each normal stress then has its own inertial number, which "
        "follows from the height of the simulated sample");
    options.add("replicates", &replicates_,
                "number of recordings of each liquid content (default 2)");
    options.add(
        "order", &order_,
        "order of the steps of a recording: as-listed (default; normal stresses as given, "
        "each at all speeds), increasing or decreasing normal stress, random (another order "
        "in each recording), or up-and-down (a ramp of the load)",
        one_of(names_of_orders()));
    options.add_switch("dry", &dry_, "make no wet recordings");
}

void LabOptions::declare_instrument(Options& options) {
    options.add("noise", &instrument_.noise,
                "factor on all scatter, which by default is 1 % of the torque and 0.2 % "
                "of the solid fraction (default 1)");
    options.add("drift", &instrument_.drift,
                "drift over a recording (standard deviation), as a multiple of the scatter of "
                "torque and solid fraction (default 0)");
    options.add("rows", &instrument_.rows, "number of recorded rows of each step (default 400)");
    options.add("step-strain", &instrument_.step_strain, "shear strain of each step (default 20)");
    options.add("torque-scatter", &torque_scatter_.text,
                "scatter of the mean torques of steps about the true ones (default \"1 %\")");
    options.add("solid-fraction-scatter", &solid_fraction_scatter_.text,
                "scatter of the mean solid fractions, which is that of the gap (default \"0.2 "
                "%\")");
    options.add("force-scatter", &force_scatter_.text,
                "scatter of the normal force from row to row (default \"0.2 %\")");
    options.add("scatter-within-steps", &within_.text,
                "share of the scatter of torque and gap that is noise from row to row, 0 to 1; the "
                "rest is equal in all rows of a step (default 0.25)");
    options.add(
        "correlation-strain", &correlation_.text,
        "strains over which the noise of torque, gap and normal force stays correlated from "
        "row to row, one for all or three; 0: white (default \"0.03, 0.1, 0\")");
    options.add("torque-drift", &torque_drift_.text,
                "standard deviation of the drift of the torque over a recording, such as \"1 %\"");
    options.add("gap-drift", &gap_drift_.text,
                "standard deviation of the drift of the gap over a recording");
    options.add("force-drift", &force_drift_.text,
                "standard deviation of the drift of the normal force over a recording");
}

void LabOptions::declare_beads(Options& options) {
    options.add("bead-mass", &bead_mass_.text,
                "mass of the beads in the cell, with its unit (default \"60 g\")");
    options.add("inner-radius", &inner_radius_.text,
                "inner radius of the cell, with its unit (default \"21 mm\")");
    options.add("outer-radius", &outer_radius_.text,
                "outer radius of the cell, with its unit (default \"45 mm\")");
    options.add("diameter", &diameter_.text,
                "diameter of the beads, with its unit (default \"500 um\")");
    options.add("density", &density_.text,
                "density of the beads, with its unit (default \"1050 kg/m^3\")");
    options.add(
        "youngs-modulus", &youngs_modulus_.text,
        "Young's modulus of the beads, with its unit, or none: then the stiffness number is "
        "that of --fidelity at every stress (default none). Stiffness numbers above 30 000 "
        "are simulated as 30 000; a run takes sqrt(stiffness number) times longer");
    options.add("poisson-ratio", &poisson_ratio_.text, "Poisson ratio of the beads (default 0.3)");
    options.add("surface-tension", &surface_tension_.text,
                "surface tension of the liquid, with its unit (default \"20.6 mN/m\")");
    options.add("liquid-contact-angle", &contact_angle_.text,
                "contact angle of the liquid, with its unit (default \"0 deg\")");
    options.add("liquid-viscosity", &viscosity_.text,
                "viscosity that study.toml states, with its unit; it acts where "
                "--viscous-bridges.viscosity hides it (default: none is stated)");
}

void LabOptions::check(const Options& parsed) const {
    const auto together = [&](const char* one, const char* other, const char* why) {
        if (parsed.given(one) && parsed.given(other)) {
            throw InputError(fmt::format("--{} and --{} contradict each other: {}; remove one", one,
                                         other, why));
        }
    };
    if (dry_ && (parsed.given("wet-normal-stresses") || parsed.given("liquid-contents") ||
                 parsed.given("surface-tension"))) {
        throw InputError(
            "--dry leaves out what --wet-normal-stresses, --liquid-contents and --surface-tension "
            "name; remove one or the other");
    }
    together("speeds", "inertial-numbers", "each speed has an inertial number of its own");
    for (const char* set_point : {"dry-normal-stresses", "wet-normal-stresses", "liquid-contents",
                                  "inertial-numbers", "speeds"}) {
        together("like", set_point, "the study states the set points");
    }
    together("drift", "torque-drift", "both state the drift of the torque");
    together("drift", "gap-drift", "both state the drift of the gap");
}

void LabOptions::take_beads(LabPlan& plan) const {
    const double mass = plan.cell.bead_volume * plan.grains.density;
    take(diameter_, plan.grains.diameter);
    take(density_, plan.grains.density);
    if (!density_.text.empty()) plan.cell.bead_volume = mass / plan.grains.density;
    if (youngs_modulus_.text == "none") {
        plan.grains.youngs_modulus.reset();
    } else {
        take(youngs_modulus_, plan.grains.youngs_modulus);
    }
    take(poisson_ratio_, plan.grains.poisson_ratio, true);
    take(inner_radius_, plan.cell.inner_radius, true);
    take(outer_radius_, plan.cell.outer_radius);
    if (!bead_mass_.text.empty()) {
        plan.cell.bead_volume = single(bead_mass_) / plan.grains.density;
    }
    take(surface_tension_, plan.liquid.surface_tension);
    take(contact_angle_, plan.liquid.contact_angle, true);
    take(viscosity_, plan.liquid.viscosity, true);
}

void LabOptions::take_set_points(const Options& parsed, LabPlan& plan) const {
    take_list(dry_normal_stresses_, plan.dry_normal_stresses);
    take_list(wet_normal_stresses_, plan.wet_normal_stresses);
    take_list(liquid_contents_, plan.liquid_contents);
    take_list(inertial_numbers_, plan.inertial_numbers);
    take_list(speeds_, plan.angular_velocities);
    if (parsed.given("replicates")) {
        plan.replicates = replicates_;
        for (LabSeries& series : plan.series)
            series.replicates = replicates_;
    }
    if (dry_) {
        plan.liquid_contents.clear();
        std::erase_if(plan.series,
                      [](const LabSeries& series) { return series.liquid_content > 0; });
        if (!like_.empty() && plan.series.empty()) {
            throw InputError(
                fmt::format("--dry leaves nothing to measure: {} has wet readings only", like_));
        }
    }
    if (order_.empty()) return;
    if (!orders().contains(order_)) {
        throw InputError(fmt::format("--order {} is unknown; use {}", order_,
                                     fmt::join(names_of_orders(), ", ")));
    }
    plan.order = orders().at(order_);
}

void LabOptions::take_instrument(const Options& parsed, LabPlan& plan) const {
    Instrument& instrument = plan.instrument;
    instrument.noise = instrument_.noise;
    instrument.drift = instrument_.drift;
    if (parsed.given("rows")) instrument.rows = instrument_.rows;
    if (parsed.given("step-strain")) instrument.step_strain = instrument_.step_strain;
    take(torque_scatter_, instrument.torque_error, true);
    take(solid_fraction_scatter_, instrument.solid_fraction_error, true);
    take(force_scatter_, instrument.force_noise, true);
    take(within_, instrument.share_within, true);
    take(torque_drift_, instrument.torque_drift, true);
    take(gap_drift_, instrument.gap_drift, true);
    take(force_drift_, instrument.force_drift, true);
    if (correlation_.text.empty()) return;
    std::vector<double> strains = list(correlation_);
    if (strains.size() == 1) strains.resize(3, strains.front());
    if (strains.size() != 3) {
        throw InputError(fmt::format(
            "--correlation-strain \"{}\": one strain, or three for torque, gap and normal force",
            correlation_.text));
    }
    instrument.torque_correlation = strains[0];
    instrument.gap_correlation = strains[1];
    instrument.force_correlation = strains[2];
}

LabPlan LabOptions::plan(const Options& parsed, std::vector<std::string>& notes) const {
    check(parsed);
    LabPlan plan;
    if (!like_.empty()) {
        const Study study = read_study(like_);
        plan = plan_like(study, read_measurements(study), std::move(plan), notes);
    }
    plan.friction = friction_;
    take_beads(plan);
    take_set_points(parsed, plan);
    take_instrument(parsed, plan);
    return plan;
}

}  // namespace pendular::app
