#include "sim/catalogue/instrument.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace pendular {
namespace {

constexpr std::array unknowns = {&CellState::torque,         &CellState::normal_force,
                                 &CellState::height,         &CellState::angular_velocity,
                                 &CellState::liquid_content, &CellState::bead_volume};
using Vector = Eigen::Vector<double, unknowns.size()>;
using Matrix = Eigen::Matrix<double, unknowns.size(), unknowns.size()>;

const ChangeInstrument& change_of(const ActiveEffect& active) {
    return std::get<ChangeInstrument>(active.effect->change);
}

/// Returns the scale of each value of a state, by which residuals are divided; never 0.
CellState scales_of(const CellState& shown) {
    const auto size = [](double value, double at_rest) {
        return std::max(std::abs(value), at_rest);
    };
    CellState scales;
    scales.normal_force = size(shown.normal_force, std::max(std::abs(shown.weight()), 1e-6));
    // A shown torque may be close to zero: its size is that of a stress ratio of 0.1 at the force.
    scales.torque = size(shown.torque, 0.1 * scales.normal_force * shown.outer_radius);
    scales.height = size(shown.height, shown.diameter);
    scales.angular_velocity = shown.angular_velocity != 0 ? std::abs(shown.angular_velocity) : 1;
    scales.liquid_content = shown.liquid_content != 0 ? std::abs(shown.liquid_content) : 1;
    scales.bead_volume = shown.bead_volume != 0 ? std::abs(shown.bead_volume) : 1;
    return scales;
}

/// Relative size of residuals at which a state is found, if no step comes closer: far below 1e-8,
/// as derivatives by differences of fits need.
constexpr double close_enough = 1e-13;

/// The equations show(x) = shown, with each unknown divided by its scale.
class Equations {
  public:
    Equations(const InstrumentMap& map, const CellState& shown)
        : map_(map), shown_(shown), scales_(scales_of(shown)) {}

    /// Returns the unknowns of a state, each divided by its scale.
    Vector scaled(const CellState& state) const {
        Vector x;
        for (std::size_t k = 0; k < unknowns.size(); ++k) {
            x[static_cast<Eigen::Index>(k)] = state.*unknowns[k] / (scales_.*unknowns[k]);
        }
        return x;
    }
    CellState state(const Vector& x) const {
        CellState state = shown_;
        for (std::size_t k = 0; k < unknowns.size(); ++k) {
            state.*unknowns[k] = x[static_cast<Eigen::Index>(k)] * (scales_.*unknowns[k]);
        }
        return state;
    }

    Vector residual(const Vector& x) const { return scaled(map_.show(state(x))) - scaled(shown_); }

    /// Returns the Jacobian by central differences; a step of 1e-5 gives relative errors of 1e-10.
    Matrix slopes(const Vector& x) const {
        Matrix result;
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            const double step = 1e-5 * std::max(std::abs(x[k]), 1e-3);
            Vector below = x, above = x;
            below[k] -= step;
            above[k] += step;
            result.col(k) = (residual(above) - residual(below)) / (above[k] - below[k]);
        }
        return result;
    }

  private:
    const InstrumentMap& map_;
    const CellState& shown_;
    CellState scales_;
};

double size_of(const Vector& residual) {
    return residual.allFinite() ? residual.lpNorm<Eigen::Infinity>()
                                : std::numeric_limits<double>::infinity();
}

/// Solves by Broyden's method, which begins with the derivatives of an instrument without effects,
/// those of the unit matrix. Where a step comes no closer, derivatives are computed anew, which
/// takes as long as twelve steps, and steps are shortened. Stops where rounding prevents further
/// progress. Source: Broyden, Math. Comput. 19 (1965) 577.
Vector solve(const Equations& equations, Vector x) {
    // Chosen: the method needs a few of both. The limits end the search for a state that the
    // instrument cannot show.
    constexpr int most_steps = 100, most_halvings = 12;
    // Residuals of a few roundings: a further step finds nothing closer, or by luck only.
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    Vector residual = equations.residual(x);
    Matrix inverse = Matrix::Identity();  // of the derivatives
    bool exact = false;                   // whether they are those at x
    for (int step = 0; step < most_steps && size_of(residual) > rounding; ++step) {
        Vector change = -inverse * residual;
        bool closer = false;
        for (int halving = 0; halving <= (exact ? most_halvings : 0) && !closer; ++halving) {
            if (halving > 0) change /= 2;
            const Vector left = equations.residual(x + change);
            closer = size_of(left) < size_of(residual);
            if (!closer) continue;
            const Vector expected = inverse * (left - residual);
            if (const double along = change.dot(expected); along != 0)
                inverse += (change - expected) * (change.transpose() * inverse) / along;
            x += change;
            residual = left;
        }
        if (!closer && (exact || size_of(residual) < close_enough)) break;
        exact = !closer;
        if (exact) inverse = equations.slopes(x).fullPivLu().inverse();
    }
    return x;
}

std::string names_of(const std::vector<ActiveEffect>& effects) {
    std::vector<std::string> names;
    for (const ActiveEffect& active : effects) {
        names.push_back(to_string(active));
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string cell_state_text(const CellState& state) {
    return fmt::format(
        "a normal force of {:.4g} N, a gap of {:.4g} mm and a bead volume of {:.4g} cm^3",
        state.normal_force, 1e3 * state.height, 1e6 * state.bead_volume);
}

/// Impossible quantity of a state, as text; empty where the state is possible.
std::string impossible(const CellState& state) {
    return !(state.normal_force > 0) ? fmt::format("normal force is {:.4g} N", state.normal_force)
           : !(state.height > 0)     ? fmt::format("gap is {:.4g} mm", 1e3 * state.height)
           : !(state.bead_volume > 0)
               ? fmt::format("bead volume is {:.4g} cm^3", 1e6 * state.bead_volume)
               : "";
}

}  // namespace

InstrumentMap::InstrumentMap(const std::vector<ActiveEffect>& effects) {
    std::ranges::copy_if(effects, std::back_inserter(effects_), [](const ActiveEffect& active) {
        return active.effect->of_instrument() && !active.is_neutral();
    });
    std::ranges::sort(effects_, {}, [](const ActiveEffect& active) {
        return std::pair(change_of(active).where, active.effect->name);
    });
}

CellState InstrumentMap::show(CellState state) const {
    for (const ActiveEffect& active : effects_) {
        state = change_of(active).show(state, active.by_name());
    }
    return state;
}

CellState InstrumentMap::truth(const CellState& shown, const CellState* near) const {
    if (empty()) {
        return shown;
    }
    constexpr double tolerance = 1e-11;  // relative: above rounding, below all that matters
    const Equations equations(*this, shown);
    const Vector x = solve(equations, equations.scaled(near ? *near : shown));
    const CellState truth = equations.state(x);
    if (!(size_of(equations.residual(x)) <= tolerance)) {
        throw std::domain_error(
            fmt::format("with {} no state of the cell shows {}; use smaller values of the effect",
                        names_of(effects_), cell_state_text(shown)));
    }
    if (const std::string what = impossible(truth); !what.empty()) {
        throw std::domain_error(
            fmt::format("with {} the true {} where {} are shown; use smaller values of the effect, "
                        "or leave the reading out",
                        names_of(effects_), what, cell_state_text(shown)));
    }
    return truth;
}

CellState shown_state(const Condition& shown, double shear_stress, double solid_fraction,
                      AnnularCell cell, const GrainProperties& grains) {
    cell.bead_volume = shown.bead_volume.value_or(cell.bead_volume);
    const double gap = shown.height.value_or(height(solid_fraction, cell));
    const double rate = shear_rate_at(shown.inertial_number, shown.normal_stress, grains);
    return {.torque = torque(shear_stress, cell),
            .normal_force = normal_force(shown.normal_stress, cell),
            .height = gap,
            .angular_velocity = angular_velocity(rate, gap, cell),
            .liquid_content = shown.liquid_content,
            .bead_volume = cell.bead_volume,
            .time = shown.time,
            .inner_radius = cell.inner_radius,
            .outer_radius = cell.outer_radius,
            .density = grains.density,
            .diameter = grains.diameter};
}

Condition true_condition(const Condition& shown, const CellState& truth, const InstrumentMap& map) {
    if (map.empty()) {
        return shown;
    }
    // Computed from ratios of true to shown values, which are exactly 1 where no effect acts.
    const CellState seen = map.show(truth);
    const double force = truth.normal_force / seen.normal_force;
    Condition condition = shown;
    condition.normal_stress *= force;
    if (shown.inertial_number != 0) {
        const double rate = truth.angular_velocity / seen.angular_velocity;
        condition.inertial_number *= rate * (seen.height / truth.height) / std::sqrt(force);
    }
    condition.liquid_content = truth.liquid_content;
    condition.height = truth.height;
    condition.bead_volume = truth.bead_volume;
    return condition;
}

namespace {

/// Returns a true state with the torque and height that follow from a shear stress [Pa] and a solid
/// fraction [1].
CellState flowing(CellState truth, double shear_stress, double solid_fraction, AnnularCell cell) {
    cell.bead_volume = truth.bead_volume;
    truth.torque = torque(shear_stress, cell);
    truth.height = height(solid_fraction, cell);
    return truth;
}

}  // namespace

Eigen::Vector2d shown_reading(const Eigen::Vector2d& predicted, CellState truth,
                              const InstrumentMap& map, const AnnularCell& cell) {
    if (map.empty()) {
        return predicted;
    }
    const CellState shown = map.show(flowing(truth, predicted(0), predicted(1), cell));
    const AnnularCell nominal{cell.inner_radius, cell.outer_radius, shown.bead_volume,
                              cell.torque_formula};
    return {shear_stress(shown.torque, nominal), solid_fraction(shown.height, nominal)};
}

CellState truth_at_set_points(const Condition& asked, const FlowPoint& flow,
                              const InstrumentMap& map, const AnnularCell& cell,
                              const GrainProperties& grains) {
    // Torque and height follow from the true force and bead volume, which depend on them only
    // weakly (through friction at the side walls), so that each round is far closer than the last.
    constexpr int most_rounds = 100;
    Condition set = asked;
    set.height.reset();
    const double rate = shear_rate_at(set.inertial_number, set.normal_stress, grains);
    CellState shown =
        shown_state(set, flow.stress_ratio * set.normal_stress, flow.solid_fraction, cell, grains);
    CellState truth = shown;
    if (map.empty()) {
        return shown;
    }
    for (int round = 0; round < most_rounds; ++round) {
        truth = map.truth(shown);
        truth = flowing(truth, flow.stress_ratio * normal_stress(truth.normal_force, cell),
                        flow.solid_fraction, cell);
        const CellState next = map.show(truth);
        const double change = std::abs(next.height / shown.height - 1) +
                              std::abs(next.torque / shown.torque - 1) +
                              std::abs(next.normal_force / shown.normal_force - 1);
        shown.torque = next.torque;
        shown.height = next.height;
        shown.angular_velocity = angular_velocity(rate, next.height, cell);
        if (change < 1e-13) {
            break;
        }
    }
    return truth;
}

}  // namespace pendular
