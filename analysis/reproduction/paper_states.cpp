#include "analysis/reproduction/paper_states.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "calib/emulator/emulated_observables.h"
#include "sim/closures/strength.h"

namespace pendular {
namespace {

using dem::Observable;

/// Largest inertial number of a state that counts as slow [1].
constexpr double slow = 0.0035;

bool nearly(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::abs(b);
}

bool is_of_study(const dem::RunResult& run) {
    const auto& p = run.parameters;
    return emulated::usable(run) && p.effects.empty() && p.wetting && p.inertial_number <= slow &&
           std::ranges::any_of(paper_frictions, [&](double f) { return nearly(p.friction, f); }) &&
           std::ranges::any_of(paper_contents, [&](const PaperContent& c) {
               return nearly(p.wetting->bridge_volume, c.bridge_volume);
           });
}

/// Order of the states; runs of one state are equal but for stiffness number and grains.
auto place_of(const dem::RunResult& run) {
    return std::tuple(run.parameters.friction, run.parameters.wetting->bridge_volume,
                      run.parameters.wetting->reduced_pressure);
}

/// Whether run `a` is nearer to the paper's simulations than run `b` of the same state.
bool better(const dem::RunResult& a, const dem::RunResult& b) {
    const auto distance = [](const dem::RunResult& run) {
        return std::abs(std::log(run.parameters.stiffness_number / paper_stiffness));
    };
    return std::tuple(distance(a), -a.parameters.grains) <
           std::tuple(distance(b), -b.parameters.grains);
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

PaperState::PaperState(dem::RunResult run, const Mean& dry_stress_ratio, double stress_ratio_error)
    : run_(std::move(run)),
      dry_stress_ratio_(dry_stress_ratio),
      stress_ratio_error_(stress_ratio_error),
      network_(closures::network_state_of(run_)),
      capillary_(closures::capillary_stress_of(run_)) {}

Mean PaperState::operator[](Observable which) const {
    Mean mean = run_[which];
    if (which == Observable::stress_ratio) mean.standard_error = stress_ratio_error_;
    return mean;
}

Mean PaperState::rigid_solid_fraction() const {
    return emulated::training_value(run_, Observable::solid_fraction);
}

Mean PaperState::contact_stress_ratio() const {
    const double ratio = run_[Observable::stress_ratio].value;
    const double value = closures::contact_stress_ratio(ratio, capillary_, reduced_pressure());
    return {value, value * stress_ratio_error_ / ratio};
}

Mean PaperState::from_dry(const std::function<double(double dry)>& prediction) const {
    const double value = prediction(dry_stress_ratio_.value);
    return {value, std::abs(prediction(dry_stress_ratio_.value + dry_stress_ratio_.standard_error) -
                            value)};
}

Mean PaperState::strength1() const {
    return from_dry([&](double dry) {
        return closures::stress_ratio_from_stresses(dry, capillary_, reduced_pressure());
    });
}

Mean PaperState::strength2() const {
    return from_dry([&](double dry) {
        const double cohesion = closures::generalised_cohesion(
            dry, network_.solid_fraction, closures::effective_coordination(network_),
            capillary_.shear);
        return closures::stress_ratio_from_cohesion(dry, cohesion, reduced_pressure());
    });
}

Mean PaperState::strength3() const {
    return from_dry([&](double dry) {
        const double cohesion = closures::reduced_cohesion(
            dry, network_.solid_fraction, closures::effective_coordination(network_));
        return closures::stress_ratio_from_cohesion(dry, cohesion, reduced_pressure());
    });
}

Mean PaperState::rumpf_cohesion() const {
    return from_dry([&](double dry) {
        return closures::reduced_cohesion(dry, network_.solid_fraction,
                                          closures::approximate_coordination(network_));
    });
}

Mean PaperState::generalised_cohesion() const {
    return from_dry([&](double dry) {
        return closures::generalised_cohesion(dry, network_.solid_fraction,
                                              closures::effective_coordination(network_),
                                              capillary_.shear);
    });
}

Mean StrengthLine::at(double reduced_pressure) const {
    const double x = 1 / reduced_pressure;
    const double variance = std::pow(intercept.standard_error, 2) + 2 * x * covariance +
                            std::pow(x * cohesion.standard_error, 2);
    return {intercept.value + x * cohesion.value, std::sqrt(variance)};
}

PaperStudy::PaperStudy(const std::vector<dem::RunResult>& runs, const Emulator& emulator)
    : emulator_(emulator) {
    std::vector<dem::RunResult> chosen;
    std::ranges::copy_if(runs, std::back_inserter(chosen), is_of_study);
    std::ranges::sort(chosen, [](const dem::RunResult& a, const dem::RunResult& b) {
        return place_of(a) != place_of(b) ? place_of(a) < place_of(b) : better(a, b);
    });
    std::vector<PaperState> others;
    for (const dem::RunResult& run : chosen) {
        PaperState state(
            run,
            dry(Observable::stress_ratio, run.parameters.friction, run.parameters.inertial_number),
            std::sqrt(emulator.noise_variance(run, Observable::stress_ratio)));
        const bool first = states_.empty() || place_of(states_.back().run()) != place_of(run);
        (first ? states_ : others).push_back(std::move(state));
    }
    for (PaperState& other : others) {
        const PaperState* state =
            at(other.friction(), other.bridge_volume(), other.reduced_pressure());
        if (state->run().parameters.stiffness_number >
            2 * other.run().parameters.stiffness_number) {
            other_stiffness_.push_back({state, std::move(other)});
        }
    }
    fit_lines();
    std::ranges::copy_if(runs, std::back_inserter(dry_runs_), [](const dem::RunResult& run) {
        return emulated::usable(run) && !run.parameters.wetting && run.parameters.effects.empty();
    });
    std::ranges::sort(dry_runs_, {}, [](const dem::RunResult& run) {
        return std::pair(run.parameters.friction, run.parameters.inertial_number);
    });
}

void PaperStudy::fit_lines() {
    for (const double friction : paper_frictions) {
        for (const PaperContent& content : paper_contents) {
            const auto states = where([&](const PaperState& s) {
                return nearly(s.friction(), friction) &&
                       nearly(s.bridge_volume(), content.bridge_volume) &&
                       s.reduced_pressure() >= lowest_line_pressure;
            });
            if (states.size() >= 3) lines_.push_back(line_through(states));
        }
    }
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
        return nearly(s.friction(), friction) && nearly(s.bridge_volume(), bridge_volume) &&
               nearly(s.reduced_pressure(), reduced_pressure);
    });
    return found.empty() ? nullptr : found.front();
}

const StrengthLine* PaperStudy::line(double friction, double bridge_volume) const {
    const auto found = std::ranges::find_if(lines_, [&](const StrengthLine& line) {
        return nearly(line.friction, friction) && nearly(line.bridge_volume, bridge_volume);
    });
    return found == lines_.end() ? nullptr : &*found;
}

Mean PaperStudy::dry(Observable which, double friction, double inertial_number) const {
    const std::vector<Query> query = {
        {FlowState{.friction = friction, .inertial_number = inertial_number}, which}};
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
