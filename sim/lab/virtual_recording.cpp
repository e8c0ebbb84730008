#include "sim/lab/virtual_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

namespace pendular {
namespace {

/// Strain of the start-up that the steady part of a step leaves out: softening and dilation have
/// then decayed to exp(-0.5/0.15) = 4 %.
constexpr double transient_strain = 0.5;

// Start-up: the torque rises elastically, overshoots and softens while the sample dilates. Since it
// softens as it rises, it peaks at half of `overshoot`, 15 % above the steady torque.
constexpr double elastic_strain = 0.02, softening_strain = 0.15;
constexpr double overshoot = 0.3, dilation = 0.02;

double square(double x) {
    return x * x;
}

class InstrumentNoise {
  public:
    explicit InstrumentNoise(std::uint64_t seed) : random_(seed) {}
    double operator()() { return normal_(random_); }

  private:
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
};

/// First-order autoregressive noise x_k = rho x_(k-1) + ..., white if rho = 0.
class CorrelatedNoise {
  public:
    /// Noise whose mean over `rows` has a given standard error se, so that its variance is
    /// se^2 rows (1 - rho)/(1 + rho).
    CorrelatedNoise(double error_of_mean, double correlation_rows, double rows)
        : keep_(std::exp(-1 / correlation_rows)),
          deviation_(error_of_mean * std::sqrt(rows * (1 - keep_) / (1 + keep_))) {}
    /// Noise of a given standard deviation.
    CorrelatedNoise(double deviation, double correlation_rows)
        : keep_(std::exp(-1 / correlation_rows)), deviation_(deviation) {}

    double next(InstrumentNoise& random) {
        const double fresh = random();
        value_ = started_ ? keep_ * value_ + std::sqrt(1 - keep_ * keep_) * fresh : fresh;
        started_ = true;
        return deviation_ * value_;
    }

  private:
    double keep_;
    double deviation_;
    double value_ = 0;
    bool started_ = false;
};

/// Returns the random factor of a step, with the part of the scatter that is not due to the
/// simulation's standard error or to noise within the step.
double factor(const Mean& simulated, double scatter, double share_within, InstrumentNoise& random) {
    const double of_simulation = square(simulated.standard_error / simulated.value);
    const double left = square(scatter) * (1 - square(share_within)) - of_simulation;
    return 1 + std::sqrt(std::max(0.0, left)) * random();
}

/// Steady values that the instrument shows in a step after the transient.
struct Level {
    double torque, normal_force, height, angular_velocity, shear_rate;
    const TrueState* state;  ///< state that is shown
    CellState shown;  ///< what the instrument shows of it at the condition's time, without noise
};

/// Returns the state that an ideal instrument, without effects and noise, shows.
CellState as_it_is(const TrueState& state, const AnnularCell& cell, const GrainProperties& grains) {
    const Condition& c = state.condition;
    const double rate = shear_rate_at(c.inertial_number, c.normal_stress, grains);
    CellState shown;
    shown.torque = torque(state.stress_ratio.value * c.normal_stress, cell);
    shown.normal_force = normal_force(c.normal_stress, cell);
    shown.height = height(state.solid_fraction.value, cell);
    shown.angular_velocity = angular_velocity(rate, shown.height, cell);
    return shown;
}

/// Time between rows of a step [s].
double spacing_of_rows(const Instrument& instrument, double shear_rate) {
    return instrument.step_strain / instrument.rows / shear_rate;
}

Level level_of(const TrueState& state, const AnnularCell& cell, const GrainProperties& grains,
               const Instrument& instrument, InstrumentNoise& random) {
    const Condition& c = state.condition;
    const double rate = shear_rate_at(c.inertial_number, c.normal_stress, grains);
    const CellState shown = state.shown ? state.shown(c.time) : as_it_is(state, cell, grains);
    // Separate statements fix the order in which random numbers are drawn, which determines the
    // recording.
    const double share = instrument.share_within;
    const double of_torque =
        factor(state.stress_ratio, instrument.noise * instrument.torque_error, share, random);
    const double of_height = factor(
        state.solid_fraction, instrument.noise * instrument.solid_fraction_error, share, random);
    // If the shown solid fraction is too high, the shown gap is too small.
    return {shown.torque * of_torque,
            shown.normal_force,
            shown.height / of_height,
            shown.angular_velocity,
            rate,
            &state,
            shown};
}

/// Returns the first row of a step after the transient.
double first_steady_row(const Instrument& instrument) {
    return instrument.rows * transient_strain / instrument.step_strain;
}

/// Returns the values of a step at a time [s]: those of its mean time, times what the instrument
/// shows now over what it shows then.
Level at_time(Level level, double time) {
    if (!level.state->shown) return level;
    const CellState& then = level.shown;
    const CellState now = level.state->shown(time);
    level.torque *= now.torque / then.torque;
    level.normal_force *= now.normal_force / then.normal_force;
    level.height *= now.height / then.height;
    level.angular_velocity *= now.angular_velocity / then.angular_velocity;
    return level;
}

void append_step(Recording& recording, const Level& steady, const Instrument& instrument,
                 InstrumentNoise& random) {
    const double rows = instrument.rows, rows_per_strain = rows / instrument.step_strain;
    const double steady_rows = rows - first_steady_row(instrument);
    const double within = instrument.share_within * instrument.noise;
    CorrelatedNoise torque_noise(within * instrument.torque_error,
                                 rows_per_strain * instrument.torque_correlation, steady_rows);
    CorrelatedNoise height_noise(within * instrument.solid_fraction_error,
                                 rows_per_strain * instrument.gap_correlation, steady_rows);
    CorrelatedNoise force_noise(instrument.noise * instrument.force_noise,
                                rows_per_strain * instrument.force_correlation);
    const double spacing = spacing_of_rows(instrument, steady.shear_rate);
    const double mean_row = (first_steady_row(instrument) + rows - 1) / 2;
    const double start = recording.time.empty() ? 0 : recording.time.back() + spacing;
    const double interval = recording.interval.empty() ? 1 : recording.interval.back() + 1;
    for (int k = 0; k < instrument.rows; ++k) {
        const double strain = k / rows_per_strain;
        const double softening = std::exp(-strain / softening_strain);
        const double rising = std::exp(-strain / elastic_strain);
        const Level level =
            at_time(steady, steady.state->condition.time + (k - mean_row) * spacing);
        recording.line.push_back(static_cast<int>(recording.line.size()) + 2);
        recording.time.push_back(start + k * spacing);
        recording.torque.push_back(level.torque *
                                   (1 + overshoot * softening - (1 + overshoot) * rising) *
                                   (1 + torque_noise.next(random)));
        recording.normal_force.push_back(level.normal_force * (1 + force_noise.next(random)));
        recording.height.push_back(level.height * (1 - dilation * softening) *
                                   (1 + height_noise.next(random)));
        recording.angular_velocity.push_back(level.angular_velocity);
        recording.interval.push_back(interval);
    }
}

}  // namespace

double time_steps(std::vector<Condition>& steps, const GrainProperties& grains,
                  const Instrument& instrument, double now) {
    const int rows = instrument.rows;
    double start = 0, last = 0;
    for (Condition& step : steps) {
        const double rate = shear_rate_at(step.inertial_number, step.normal_stress, grains);
        const double spacing = spacing_of_rows(instrument, rate);
        if (&step != &steps.front()) start = last + spacing;
        last = start + (rows - 1) * spacing;
        const double steady = start + first_steady_row(instrument) * spacing;
        step.time = now + (steady + last) / 2;
    }
    return last;
}

Recording record(const std::vector<TrueState>& steps, const AnnularCell& cell,
                 const GrainProperties& grains, const Instrument& instrument, std::uint64_t seed) {
    InstrumentNoise random(seed);
    InstrumentNoise drifting(seed + 1);  // separate, so that drift changes no other random number
    const double of_torque =
        instrument.torque_drift.value_or(instrument.drift * instrument.torque_error) * drifting();
    const double of_height =
        instrument.gap_drift.value_or(instrument.drift * instrument.solid_fraction_error) *
        drifting();
    const double of_force = instrument.force_drift.value_or(0) * drifting();
    Recording recording;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const double course = steps.size() > 1 ? static_cast<double>(k) / (steps.size() - 1) : 0;
        Level level = level_of(steps[k], cell, grains, instrument, random);
        level.torque *= 1 + of_torque * course;
        level.height *= 1 + of_height * course;
        level.normal_force *= 1 + of_force * course;
        append_step(recording, level, instrument, random);
    }
    return recording;
}

std::string recording_csv(const Recording& r) {
    std::string csv =
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],Interval [1]\n";
    for (std::size_t k = 0; k < r.size(); ++k) {
        fmt::format_to(std::back_inserter(csv), "{:.6f},{:.7g},{:.7g},{:.7g},{:.7g},{:g}\n",
                       r.time[k], 1e3 * r.torque[k], r.normal_force[k], 1e3 * r.height[k],
                       r.angular_velocity[k], r.interval[k]);
    }
    return csv;
}

}  // namespace pendular
