#include "sim/lab/lab_like.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "data/input_error.h"
#include "data/quantities/statistics.h"
#include "data/recordings/autoregression.h"
#include "data/recordings/recording.h"
#include "data/recordings/steps.h"
#include "data/recordings/time_series.h"

namespace pendular {
namespace {

/// Values of a set point [SI], of which nearly equal ones count as one.
class Levels {
  public:
    explicit Levels(std::vector<double> values) {
        // Replicates are readings whose set points agree to 2 %; see `are_replicates`.
        constexpr double equal = 0.02;
        std::ranges::sort(values);
        for (const double value : values) {
            if (groups_.empty() || value > groups_.back().back() * (1 + equal))
                groups_.emplace_back();
            groups_.back().push_back(value);
        }
    }
    std::size_t size() const { return groups_.size(); }
    /// Returns the median of the values that count as equal to `value`, to four digits.
    double of(double value) const {
        for (const std::vector<double>& group : groups_) {
            if (value <= group.back()) return std::stod(fmt::format("{:.4g}", median(group)));
        }
        return value;
    }

  private:
    std::vector<std::vector<double>> groups_;
};

/// Angular velocity of the lid at a reading [rad/s]; 0 where only the inertial number is known.
double speed_of(const Reading& reading, const AnnularCell& cell) {
    const double rate = reading.shear_rate;
    return rate > 0 && reading.condition.height
               ? angular_velocity(rate, *reading.condition.height, cell)
               : 0;
}

/// Set points of all readings of steady shear, by file in the order of measurement.
class SetPoints {
  public:
    SetPoints(const std::vector<Reading>& readings, const AnnularCell& cell) : cell_(cell) {
        std::vector<double> stresses, speeds, numbers;
        bool all_speeds = true;
        for (const Reading& reading : readings) {
            stresses.push_back(reading.condition.normal_stress);
            speeds.push_back(speed_of(reading, cell));
            numbers.push_back(reading.condition.inertial_number);
            all_speeds = all_speeds && speeds.back() > 0;
        }
        stresses_ = Levels(stresses), speeds_ = Levels(speeds), numbers_ = Levels(numbers);
        at_speed_ = all_speeds && speeds_.size() <= numbers_.size();
    }
    LabSetPoint of(const Reading& reading) const {
        // The quasi-static limit is measured at an inertial number at which it is reached to 1 %.
        constexpr double quasi_static = 1e-3;
        const Condition& c = reading.condition;
        LabSetPoint step{.normal_stress = stresses_.of(c.normal_stress)};
        if (at_speed_) {
            step.angular_velocity = speeds_.of(speed_of(reading, cell_));
        } else {
            step.inertial_number =
                c.inertial_number > 0 ? numbers_.of(c.inertial_number) : quasi_static;
        }
        return step;
    }

  private:
    AnnularCell cell_;
    Levels stresses_{{}}, speeds_{{}}, numbers_{{}};
    bool at_speed_ = false;
};

bool same_steps(const LabSeries& series, double content, const std::vector<LabSetPoint>& steps) {
    return series.liquid_content == content &&
           std::ranges::equal(series.steps, steps, [](const auto& a, const auto& b) {
               return a.normal_stress == b.normal_stress &&
                      a.inertial_number == b.inertial_number &&
                      a.angular_velocity == b.angular_velocity;
           });
}

/// A pass through set points at one liquid content.
struct Pass {
    double liquid_content = 0;
    std::vector<LabSetPoint> steps;
};

/// Returns the passes of one file of readings. A recording is one pass. A table lists replicates of
/// a condition in any order, so that the k-th reading of each condition belongs to the k-th pass.
std::vector<Pass> passes_of(const std::vector<const Reading*>& readings, const SetPoints& points) {
    std::map<double, std::vector<Pass>> by_content;
    std::vector<double> order;
    for (const Reading* reading : readings) {
        const double content = reading->condition.liquid_content;
        const LabSetPoint step = points.of(*reading);
        auto& passes = by_content[content];
        if (passes.empty()) order.push_back(content);
        std::size_t which = 0;
        const auto measured = [&](const Pass& pass) {
            return !reading->within_run_only &&
                   std::ranges::any_of(pass.steps, [&](const LabSetPoint& other) {
                       return same_steps({0, {other}, 1}, 0, {step});
                   });
        };
        while (which < passes.size() && measured(passes[which]))
            ++which;
        if (which == passes.size()) passes.push_back({content, {}});
        passes[which].steps.push_back(step);
    }
    std::vector<Pass> all;
    for (const double content : order) {
        all.insert(all.end(), by_content[content].begin(), by_content[content].end());
    }
    return all;
}

std::vector<LabSeries> series_like(const std::vector<Reading>& readings, const SetPoints& points) {
    std::vector<LabSeries> all;
    for (std::size_t begin = 0, end = 0; begin < readings.size(); begin = end) {
        std::vector<const Reading*> of_file;
        while (end < readings.size() && readings[end].origin.file == readings[begin].origin.file) {
            of_file.push_back(&readings[end++]);
        }
        for (const Pass& pass : passes_of(of_file, points)) {
            if (!all.empty() && same_steps(all.back(), pass.liquid_content, pass.steps)) {
                ++all.back().replicates;
            } else {
                all.push_back({pass.liquid_content, pass.steps, 1});
            }
        }
    }
    return all;
}

/// Properties of the rows of steady steps, one value for each step.
struct RowsOfSteps {
    std::vector<double> rows, strain, force_noise;
    std::vector<double> torque_within, gap_within;  ///< relative standard errors of means [1]
    std::vector<double> torque_correlation, gap_correlation, force_correlation;  ///< strains [1]

    void look_at(const Recording& recording, const AnnularCell& cell) {
        for (const RecordedStep& step : recorded_steps(recording)) {
            const auto steady = step.lid_turns ? level_part(step) : std::nullopt;
            if (steady && steady->size() >= shortest_step) add(step, *steady, recording, cell);
        }
    }

  private:
    void add(const RecordedStep& step, const StepSeries& steady, const Recording& recording,
             const AnnularCell& cell) {
        const double rate = shear_rate(std::abs(plain_mean(steady.angular_velocity)),
                                       plain_mean(steady.height), cell);
        const double duration = step.series.time.back() - step.series.time.front();
        const auto count = static_cast<double>(step.series.size());
        rows.push_back(count * recording.averaged_rows);
        strain.push_back(rate * duration * count / (count - 1));
        const double between = rate * duration / (count - 1);
        torque_within.push_back(relative(mean_of_correlated(steady.torque)));
        gap_within.push_back(relative(mean_of_correlated(steady.height)));
        force_noise.push_back(deviation(steady.normal_force) /
                              std::abs(plain_mean(steady.normal_force)));
        torque_correlation.push_back(correlation_strain(steady.torque, between));
        gap_correlation.push_back(correlation_strain(steady.height, between));
        force_correlation.push_back(correlation_strain(steady.normal_force, between));
    }
    static double relative(const Mean& mean) { return std::abs(mean.standard_error / mean.value); }
    static double deviation(const std::vector<double>& samples) {
        return std::sqrt(std::max(0.0, LaggedCovariances(samples, samples)(0)));
    }
    /// Strain [1] over which first-order autoregressive noise loses its correlation; 0: white.
    static double correlation_strain(const std::vector<double>& samples, double between_rows) {
        LaggedCovariances covariance(samples, samples);
        const double variance = covariance(0);
        const double next = variance > 0 ? covariance(1) / variance : 0;
        // White noise of n rows has an apparent correlation of 1/sqrt(n).
        const double by_chance = 2 / std::sqrt(static_cast<double>(samples.size()));
        return next > by_chance && next < 1 ? -between_rows / std::log(next) : 0;
    }
};

RowsOfSteps rows_of(const Study& study) {
    RowsOfSteps rows;
    for (const Source& source : study.sources) {
        if (source.kind != Source::Kind::recording) continue;
        for (const std::filesystem::path& file : source.files) {
            Recording recording = read_recording(file, source.format);
            fill_from_stresses(recording, *study.cell);
            rows.look_at(recording, *study.cell);
        }
    }
    return rows;
}

void take_rows(const RowsOfSteps& rows, Instrument& instrument, std::vector<std::string>& notes) {
    if (rows.rows.empty()) {
        notes.push_back(
            "The study has no recordings: rows, strain and correlation of each step are the usual "
            "ones of the virtual laboratory.");
        return;
    }
    instrument.rows = static_cast<int>(std::lround(median(rows.rows)));
    instrument.step_strain = median(rows.strain);
    instrument.force_noise = median(rows.force_noise);
    instrument.torque_correlation = median(rows.torque_correlation);
    instrument.gap_correlation = median(rows.gap_correlation);
    instrument.force_correlation = median(rows.force_correlation);
    // One share serves torque and gap; that of the torque matters more to a calibration.
    const double share = median(rows.torque_within) / instrument.torque_error;
    instrument.share_within = std::clamp(share, 0.02, 1.0);
}

void take_scatter(const std::vector<Reading>& readings, Instrument& instrument) {
    std::vector<double> torque, fraction;
    for (const Reading& reading : readings) {
        const Eigen::Matrix2d covariance = reading.estimated_covariance();
        torque.push_back(std::sqrt(covariance(0, 0)) / reading.value(0));
        fraction.push_back(std::sqrt(covariance(1, 1)) / reading.value(1));
    }
    instrument.torque_error = median(torque);
    instrument.solid_fraction_error = median(fraction);
}

/// Takes the volume of grains, where entries of the study state their own, from the first of them.
void take_bead_volume(const Study& study, LabPlan& plan, std::vector<std::string>& notes) {
    std::vector<double> own;
    for (const Source& source : study.sources) {
        if (source.bead_volume) own.push_back(*source.bead_volume);
    }
    if (own.empty()) return;
    plan.cell.bead_volume = own.front();
    if (*std::ranges::max_element(own) > *std::ranges::min_element(own)) {
        notes.push_back(fmt::format(
            "The study has several fillings; all recordings are made with {:.4g} g. Make one "
            "laboratory for each --bead-mass to have the others.",
            1e3 * own.front() * plan.grains.density));
    }
}

}  // namespace

LabPlan plan_like(const Study& study, const Measurements& measured, LabPlan plan,
                  std::vector<std::string>& notes) {
    std::vector<Reading> readings;
    std::ranges::copy_if(measured.readings, std::back_inserter(readings),
                         [](const Reading& reading) { return !reading.condition.at_failure; });
    if (readings.empty()) {
        throw InputError(fmt::format(
            "{} has no reading of steady shear, so that there are no set points to take; state "
            "them by options, without --like",
            study.file.string()));
    }
    if (readings.size() < measured.readings.size()) {
        notes.push_back(
            "Points of failure of the study are left out: the virtual laboratory "
            "measures steady shear.");
    }
    plan.grains = study.grains;
    if (study.liquid) plan.liquid = *study.liquid;
    if (study.cell) {
        plan.cell = *study.cell;
        plan.cell.torque_formula = FormulaVariant::derived;
    } else {
        notes.push_back(
            "The study states no [cell]: the cell is the usual one of the virtual "
            "laboratory.");
    }
    take_bead_volume(study, plan, notes);
    plan.series = series_like(readings, SetPoints(readings, plan.cell));
    take_scatter(readings, plan.instrument);
    take_rows(rows_of(study), plan.instrument, notes);
    return plan;
}

}  // namespace pendular
