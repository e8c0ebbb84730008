#include "analysis/reproduction/paper_states.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "calib/emulator/emulated_state.h"
#include "calib/model/mohr_coulomb.h"

namespace pendular {
namespace {

using dem::Observable;

/// Largest inertial number of a state that counts as slow [1]: `grid_inertial_number` with a margin
/// for rounding.
constexpr double slow = 0.0035;

bool is_of_study(const dem::RunResult& run) {
    const auto& p = run.parameters;
    return emulated::usable(run) && p.effects.empty() && p.wetting && p.inertial_number <= slow &&
           std::ranges::any_of(paper_frictions,
                               [&](double f) { return same_setting(p.friction, f); }) &&
           std::ranges::any_of(paper_contents, [&](const PaperContent& c) {
               return same_setting(p.wetting->bridge_volume, c.bridge_volume);
           });
}

auto place_of(const dem::RunResult& run) {
    return std::tuple(run.parameters.friction, run.parameters.wetting->bridge_volume,
                      run.parameters.wetting->reduced_pressure);
}

bool is_stiff(const dem::RunResult& run) {
    return emulated::alike(run.parameters.stiffness_number, paper_stiffness);
}

/// Order of the states. Of one state, stiff runs come first, then those with more grains.
bool comes_before(const dem::RunResult& a, const dem::RunResult& b) {
    if (place_of(a) != place_of(b)) return place_of(a) < place_of(b);
    return is_stiff(a) != is_stiff(b) ? is_stiff(a) : a.parameters.grains > b.parameters.grains;
}

/// Returns a run of wet grains as it would be at the stiffness number of the paper: each emulated
/// observable is changed by the difference of the emulated values at the two stiffness numbers.
/// The errors grow by those of the change, without those that both emulated values share.
dem::RunResult at_paper_stiffness(dem::RunResult run, const Emulator& emulator) {
    const FlowState state = emulated::flow_state_of(run.parameters);
    const auto own =
        emulated_at(emulator, state, run.parameters.stiffness_number, emulated::observables());
    const auto stiff = emulated_at(emulator, state, paper_stiffness, emulated::observables());
    for (std::size_t k = 0; k < own.size(); ++k) {
        Mean& mean = run.means[static_cast<std::size_t>(own[k].which)];
        mean.value += stiff[k].value.value - own[k].value.value;
        const double common = std::pow(own[k].value.standard_error, 2);
        const double further = std::pow(stiff[k].value.standard_error, 2) - common;
        mean.standard_error = std::hypot(mean.standard_error, std::sqrt(std::max(0.0, further)));
    }
    run.parameters.stiffness_number = paper_stiffness;
    return run;
}

/// Weighted straight line through the stress ratios of states against 1/P*.
StrengthLine line_through(const std::vector<const PaperState*>& states) {
    const auto n = static_cast<Eigen::Index>(states.size());
    Eigen::MatrixXd design(n, 2);
    Eigen::VectorXd values(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const PaperState& state = *states[static_cast<std::size_t>(k)];
        const Mean ratio = state[Observable::stress_ratio];
        const double weight = 1 / ratio.standard_error;
        design.row(k) << weight, weight / state.reduced_pressure();
        values(k) = weight * ratio.value;
    }
    const Eigen::Matrix2d covariance = (design.transpose() * design).inverse();
    const Eigen::Vector2d fitted = covariance * design.transpose() * values;
    return {.friction = states.front()->friction(),
            .bridge_volume = states.front()->bridge_volume(),
            .intercept = {fitted(0), std::sqrt(covariance(0, 0))},
            .cohesion = {fitted(1), std::sqrt(covariance(1, 1))},
            .covariance = covariance(0, 1),
            .points = static_cast<int>(n)};
}

}  // namespace

bool same_setting(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::abs(b);
}

PaperState::PaperState(dem::RunResult run, const Mean& dry_stress_ratio, double stress_ratio_error)
    : run_(std::move(run)),
      dry_stress_ratio_(dry_stress_ratio),
      stress_ratio_error_(stress_ratio_error),
      network_(closures::network_state_of(run_)),
      capillary_(closures::capillary_stress_of(run_)) {}

std::string PaperState::name() const {
    return fmt::format("friction {:g}, V0/a^3 {:g}, P* {:g}", friction(), bridge_volume(),
                       reduced_pressure());
}

Mean PaperState::operator[](Observable which) const {
    Mean mean = run_[which];
    if (which == Observable::stress_ratio) mean.standard_error = stress_ratio_error_;
    return mean;
}

Mean PaperState::rigid_solid_fraction() const {
    return emulated::training_value(run_, Observable::solid_fraction);
}

Mean PaperState::closure(double closures::ClosureValues::*value) const {
    const double ratio = run_[Observable::stress_ratio].value, dry = dry_stress_ratio_.value;
    const auto at = [&](double stress_ratio, double dry_stress_ratio) {
        return closures::closure_values(network_, capillary_, stress_ratio, dry_stress_ratio,
                                        run_[Observable::liquid_content].value).*
               value;
    };
    const double middle = at(ratio, dry);
    return {middle, std::hypot(at(ratio + stress_ratio_error_, dry) - middle,
                               at(ratio, dry + dry_stress_ratio_.standard_error) - middle)};
}

Mean StrengthLine::at(double reduced_pressure) const {
    const double x = 1 / reduced_pressure;
    const double variance = std::pow(intercept.standard_error, 2) + 2 * x * covariance +
                            std::pow(x * cohesion.standard_error, 2);
    return {intercept.value + x * cohesion.value, std::sqrt(variance)};
}

PaperStudy::PaperStudy(const std::vector<dem::RunResult>& runs, const Emulator& emulator)
    : emulator_(emulator) {
    std::vector<dem::RunResult> grid;
    std::ranges::copy_if(runs, std::back_inserter(grid), is_of_study);
    states_ = states_of(std::move(grid));
    fit_lines();
    std::ranges::copy_if(runs, std::back_inserter(dry_runs_), [](const dem::RunResult& run) {
        return emulated::usable(run) && !run.parameters.wetting && run.parameters.effects.empty();
    });
    std::ranges::sort(dry_runs_, {}, [](const dem::RunResult& run) {
        return std::pair(run.parameters.friction, run.parameters.inertial_number);
    });
}

std::vector<PaperState> PaperStudy::states_of(std::vector<dem::RunResult> runs) {
    std::ranges::stable_sort(runs, comes_before);
    std::vector<PaperState> states;
    for (dem::RunResult& run : runs) {
        if (!states.empty() && place_of(states.back().run()) == place_of(run)) continue;
        const dem::RunParameters p = run.parameters;
        const double noise = emulator_.noise_variance(run, Observable::stress_ratio);
        const double stated = std::pow(run[Observable::stress_ratio].standard_error, 2);
        if (is_stiff(run)) {
            ++stiff_;
        } else if (emulator_.knows_stiffness()) {
            run = at_paper_stiffness(std::move(run), emulator_);
        }
        const double change = std::pow(run[Observable::stress_ratio].standard_error, 2) - stated;
        states.emplace_back(std::move(run),
                            dry(Observable::stress_ratio, p.friction, p.inertial_number),
                            std::sqrt(noise + change));
    }
    return states;
}

void PaperStudy::fit_lines() {
    for (const double friction : paper_frictions) {
        for (const PaperContent& content : paper_contents) {
            const auto states = line_states(friction, content.bridge_volume);
            if (states.size() >= 3) lines_.push_back(line_through(states));
        }
    }
}

std::vector<const PaperState*> PaperStudy::line_states(double friction,
                                                       double bridge_volume) const {
    return where([&](const PaperState& s) {
        return same_setting(s.friction(), friction) &&
               same_setting(s.bridge_volume(), bridge_volume) &&
               s.reduced_pressure() >= lowest_cohesion_pressure;
    });
}

Mean PaperStudy::mean_over(const StrengthLine& line, double closures::ClosureValues::*value) const {
    Mean sum;
    const auto states = line_states(line.friction, line.bridge_volume);
    for (const PaperState* state : states) {
        const Mean one = state->closure(value);
        sum.value += one.value, sum.standard_error += one.standard_error;
    }
    const auto count = static_cast<double>(states.size());
    return {sum.value / count, sum.standard_error / count};
}

std::vector<const PaperState*> PaperStudy::where(
    const std::function<bool(const PaperState&)>& condition) const {
    std::vector<const PaperState*> result;
    for (const PaperState& state : states_) {
        if (condition(state)) result.push_back(&state);
    }
    return result;
}

const PaperState* PaperStudy::at(double friction, double bridge_volume,
                                 double reduced_pressure) const {
    const auto found = where([&](const PaperState& s) {
        return same_setting(s.friction(), friction) &&
               same_setting(s.bridge_volume(), bridge_volume) &&
               same_setting(s.reduced_pressure(), reduced_pressure);
    });
    return found.empty() ? nullptr : found.front();
}

const StrengthLine* PaperStudy::line(double friction, double bridge_volume) const {
    const auto found = std::ranges::find_if(lines_, [&](const StrengthLine& line) {
        return same_setting(line.friction, friction) &&
               same_setting(line.bridge_volume, bridge_volume);
    });
    return found == lines_.end() ? nullptr : &*found;
}

Mean PaperStudy::dry(Observable which, double friction, double inertial_number) const {
    const std::vector<Query> query = {{FlowState{.friction = friction,
                                                 .inertial_number = inertial_number,
                                                 .stiffness_number = paper_stiffness},
                                       which}};
    return {emulator_.mean(query)(0), std::sqrt(std::max(0.0, emulator_.covariance(query)(0, 0)))};
}

Mean PaperStudy::dry_stress_ratio(double friction) const {
    return dry(Observable::stress_ratio, friction, 0);
}

Mean PaperStudy::dry_solid_fraction(double friction) const {
    return dry(Observable::solid_fraction, friction, 0);
}

std::vector<MissingState> PaperStudy::missing() const {
    std::vector<MissingState> result;
    for (const double friction : paper_frictions) {
        for (const PaperContent& content : paper_contents) {
            for (const double pressure : paper_pressures) {
                if (at(friction, content.bridge_volume, pressure) == nullptr) {
                    result.push_back({friction, content.bridge_volume, pressure});
                }
            }
        }
    }
    return result;
}

}  // namespace pendular
