#include "analysis/misfit/unit_mistakes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "data/grains.h"
#include "data/quantities/units.h"
#include "data/recordings/plausibility.h"
#include "data/remarks/wording.h"

namespace pendular {
namespace {

/// Column of a recording that may be in a wrong unit, with the effect on a reading.
struct Column {
    std::string_view quantity;
    int powers;  ///< largest power of ten that a wrong prefix may amount to
    bool (*is_column_of)(const Reading& reading);  ///< whether the reading comes of such a column
    void (*multiply)(Reading& reading, double factor);
    bool changes_condition;  ///< whether the condition, and therefore the prediction, changes
};

void multiply_shear_stress(Reading& reading, double factor) {
    reading.value(0) *= factor;
    reading.covariance.row(0) *= factor;
    reading.covariance.col(0) *= factor;
}

void multiply_solid_fraction(Reading& reading, double factor) {
    reading.value(1) *= factor;
    reading.covariance.row(1) *= factor;
    reading.covariance.col(1) *= factor;
}

void multiply_normal_force(Reading& reading, double factor) {
    reading.condition.normal_stress *= factor;
    reading.condition.inertial_number /= std::sqrt(factor);
}

void multiply_gap(Reading& reading, double factor) {
    multiply_solid_fraction(reading, 1 / factor);
    if (reading.condition.height) *reading.condition.height *= factor;
    reading.condition.inertial_number /= factor;
}

void multiply_bead_mass(Reading& reading, double factor) {
    multiply_solid_fraction(reading, factor);
    if (reading.condition.bead_volume) *reading.condition.bead_volume *= factor;
}

void multiply_shear_rate(Reading& reading, double factor) {
    reading.condition.inertial_number *= factor;
    reading.shear_rate *= factor;
}

void multiply_liquid_content(Reading& reading, double factor) {
    reading.condition.liquid_content *= factor;
}

/// Whether a reading was averaged from a recording; the others come from a table of readings.
bool recorded(const Reading& reading) {
    return reading.within_run_only;
}

// Stresses and solid fractions in a table of readings are not tried: a wrong prefix makes them
// impossible, which the import says (data/recordings/plausibility.h), and inertial numbers have no
// unit.
constexpr Column columns[] = {
    {"angular_velocity", 3, recorded, multiply_shear_rate, true},
    {"torque", 6, recorded, multiply_shear_stress, false},
    {"normal_force", 3, recorded, multiply_normal_force, true},
    {"height", 3, recorded, multiply_gap, true},
    {"bead_mass", 3, recorded, multiply_bead_mass, true},
    {"shear_rate", 3, [](const Reading& r) { return !recorded(r) && r.shear_rate > 0; },
     multiply_shear_rate, true},
    {"liquid_content", 2, [](const Reading& r) { return !r.condition.dry(); },
     multiply_liquid_content, true}};

/// Factor by which a column in a wrong unit must be multiplied.
struct Factor {
    double value;
    std::string meaning;  ///< such as "numbers in rpm were read as rad/s"
    bool prefix = false;  ///< whether the units differ by their prefix alone
};

std::vector<Factor> factors_of(const Column& column) {
    std::vector<Factor> factors;
    for (const UnitMixUp& units : unit_mix_ups(column.quantity))
        factors.push_back({units.factor, units.meaning()});
    for (int n = 1; n <= column.powers; ++n)
        for (const int power : {n, -n})
            factors.push_back({std::pow(10.0, power), "a prefix of the unit is wrong", true});
    return factors;
}

/// Whether a reading is within the range of steady shear of grains for which a model can be
/// evaluated, with wide margins. 0.74 is the solid fraction of the densest packing of equal
/// spheres.
bool possible(const Reading& reading, const Study& study) {
    const Condition& c = reading.condition;
    const double ratio = reading.stress_ratio();
    const double pressure =
        c.dry() || !study.liquid
            ? INFINITY
            : reduced_pressure(c.normal_stress, study.grains, study.liquid.value());
    return ratio > 0.05 && ratio < 1.5 * (1 + 1 / pressure) && reading.value(1) > 0.4 &&
           reading.value(1) < 0.74 && c.inertial_number < 0.2 && c.normal_stress > 1 &&
           c.normal_stress < 1e6 &&
           (c.dry() || (pressure > 0.3 && beyond_pendular_range(c.liquid_content) == 0));
}

/// Assumed relative errors of the model far from its runs, for (shear stress, solid fraction) [1].
/// Chosen: so that very precise readings at a true unit do not look as bad as at a wrong one.
const Eigen::Array2d model_floor(0.005, 0.001);

/// Computes chi2 of readings against a model's predictions, which are interpolated in friction.
class Misfits {
  public:
    Misfits(const Predictor& model, const Eigen::VectorXd& parameters)
        : model_(model), parameters_(parameters) {
        const ParameterBounds range = model.bounds();
        // Densest at small frictions, with which the flow changes fastest.
        for (const double share : {0.0, 0.08, 0.16, 0.25, 0.4, 0.6, 1.0})
            frictions_.push_back(std::lerp(range.lower(0), range.upper(0), share));
    }
    /// Predictions of readings, one column for each friction of a fixed grid.
    Eigen::MatrixXd predictions(const std::vector<Reading>& readings) const {
        std::vector<Condition> conditions;
        for (const Reading& reading : readings)
            conditions.push_back(reading.condition);
        Eigen::MatrixXd all(2 * std::ssize(readings), std::ssize(frictions_));
        Eigen::VectorXd at = parameters_;
        for (Eigen::Index k = 0; k < all.cols(); ++k) {
            at(0) = frictions_[static_cast<std::size_t>(k)];
            all.col(k) = model_.predict(at, conditions, PredictionPart::values).value;
        }
        return all;
    }
    /// Smallest chi2 that any friction, common to all readings, gives.
    static double least(const std::vector<Reading>& readings, const Eigen::MatrixXd& predictions) {
        // Chosen: between the frictions of the grid, interpolation costs no prediction.
        constexpr int parts = 12;
        double best = INFINITY;
        for (Eigen::Index k = 0; k + 1 < predictions.cols(); ++k) {
            for (int part = 0; part <= parts; ++part) {
                const double share = static_cast<double>(part) / parts;
                best = std::min(best, chi2(readings, (1 - share) * predictions.col(k) +
                                                         share * predictions.col(k + 1)));
            }
        }
        return best;
    }

  private:
    static double chi2(const std::vector<Reading>& readings, const Eigen::VectorXd& predicted) {
        double sum = 0;
        for (std::size_t k = 0; k < readings.size(); ++k) {
            const Eigen::Array2d value =
                predicted.segment<2>(2 * static_cast<Eigen::Index>(k)).array();
            const Eigen::Array2d variance = readings[k].covariance.diagonal().array() +
                                            (model_floor * readings[k].value.array()).square();
            sum += ((readings[k].value.array() - value).square() / variance).sum();
        }
        return sum;
    }

    const Predictor& model_;
    Eigen::VectorXd parameters_;
    std::vector<double> frictions_;
};

// Chosen: a wrong unit leaves far larger misfits than what other faults cause, and such faults may
// remain when the unit is right.
constexpr double mended = 0.3;       ///< largest ratio of chi2 with the factor to chi2 without it
constexpr double bad_enough = 2;     ///< smallest chi2 per degree of freedom that needs a search
constexpr double good_enough = 3.5;  ///< largest chi2 per degree of freedom with the factor

/// Readings after one column was multiplied by a factor.
struct Trial {
    std::vector<Reading> readings;     ///< all readings
    std::vector<std::size_t> changed;  ///< indices of the readings that the factor changed
};

/// Files whose columns may all be in the same wrong unit.
struct FileGroup {
    std::set<std::string> files;
    std::string name;  ///< as in "the torque of wet_1.csv": "of wet_1.csv"; empty: all files
};

/// Readings after one column of a group of files was multiplied by a factor; empty where the factor
/// changes no reading or makes a reading impossible.
std::optional<Trial> multiplied(const std::vector<Reading>& readings, const FileGroup& group,
                                const Column& column, double factor, const Study& study) {
    Trial trial{.readings = readings, .changed = {}};
    for (std::size_t k = 0; k < readings.size(); ++k) {
        if (!group.files.contains(readings[k].origin.file)) continue;
        if (!column.is_column_of(readings[k])) continue;
        column.multiply(trial.readings[k], factor);
        if (!possible(trial.readings[k], study)) return std::nullopt;
        trial.changed.push_back(k);
    }
    if (trial.changed.empty()) return std::nullopt;
    return trial;
}

/// Smallest chi2 over the friction of multiplied readings. Only readings whose condition changed
/// are predicted again; `as_read`: predictions before the multiplication.
double chi2_of(const Trial& trial, const Column& column, const Misfits& misfits,
               const Eigen::MatrixXd& as_read) {
    if (!column.changes_condition) return Misfits::least(trial.readings, as_read);
    std::vector<Reading> changed;
    for (const std::size_t k : trial.changed)
        changed.push_back(trial.readings[k]);
    const Eigen::MatrixXd anew = misfits.predictions(changed);
    Eigen::MatrixXd predictions = as_read;
    for (std::size_t k = 0; k < trial.changed.size(); ++k) {
        predictions.middleRows<2>(2 * static_cast<Eigen::Index>(trial.changed[k])) =
            anew.middleRows<2>(2 * static_cast<Eigen::Index>(k));
    }
    return Misfits::least(trial.readings, predictions);
}

/// Groups of files on which to try a factor: all files, the files of each entry of the study, and
/// each single file; no group occurs twice.
std::vector<FileGroup> groups_to_try(const std::vector<Reading>& readings, const Study& study) {
    std::set<std::string> all;
    for (const Reading& reading : readings)
        all.insert(reading.origin.file);
    std::vector<FileGroup> groups = {{.files = all, .name = ""}};
    const auto add = [&](const FileGroup& group) {
        if (!group.files.empty() &&
            std::ranges::find(groups, group.files, &FileGroup::files) == groups.end())
            groups.push_back(group);
    };
    for (const Source& source : study.sources) {
        FileGroup entry{.files = {}, .name = "of the files " + source.pattern};
        for (const auto& file : source.files) {
            if (all.contains(file.string())) entry.files.insert(file.string());
        }
        if (entry.files.size() > 1) add(entry);
    }
    for (const std::string& file : all)
        add({.files = {file}, .name = "of " + std::filesystem::path(file).filename().string()});
    return groups;
}

/// Text with the files in which a factor changed readings, such as "of all recordings".
std::string files_of(const FileGroup& group, const Trial& trial) {
    if (!group.name.empty()) return group.name;
    const auto from_recordings = std::ranges::count_if(
        trial.changed, [&](std::size_t k) { return recorded(trial.readings[k]); });
    if (from_recordings == std::ssize(trial.changed)) return "of all recordings";
    return from_recordings == 0 ? "of all tables of readings" : "of all files";
}

/// Whether a factor reduces chi2 more than the best factor so far, or about equally and is the more
/// likely mistake. `dof`: degrees of freedom; chi2 is about equal within sqrt(2 dof).
bool better(double chi2, const Factor& factor, const std::optional<UnitMistake>& best, int dof) {
    if (!best) return true;
    const double alike = std::sqrt(2.0 * dof);
    const double handicap = factor.prefix == best->prefix ? 0 : factor.prefix ? alike : -alike;
    return chi2 + handicap < best->chi2_after;
}

}  // namespace

std::string UnitMistake::sentence() const {
    return fmt::format(
        "Multiplying the {} {} by {:.4g} reduces chi2 from {:.3g} to {:.2g} for {} degrees of "
        "freedom, as if {}: check the unit in the file.",
        column, files, factor, chi2_before, chi2_after, dof, unit);
}

std::optional<UnitMistake> find_unit_mistake(const Predictor& model,
                                             const std::vector<Reading>& readings,
                                             const Study& study,
                                             const Eigen::VectorXd& parameters) {
    const Misfits misfits(model, parameters);
    const Eigen::MatrixXd as_read = misfits.predictions(readings);
    const double before = Misfits::least(readings, as_read);
    const int dof = std::max(1, static_cast<int>(2 * readings.size()) - 1);
    if (before < bad_enough * dof) return std::nullopt;
    std::optional<UnitMistake> best;
    for (const FileGroup& group : groups_to_try(readings, study)) {
        for (const Column& column : columns) {
            for (const Factor& factor : factors_of(column)) {
                const auto trial = multiplied(readings, group, column, factor.value, study);
                if (!trial) continue;
                const double after = chi2_of(*trial, column, misfits, as_read);
                if (after > mended * before || after > good_enough * dof ||
                    !better(after, factor, best, dof))
                    continue;
                best = UnitMistake{.column = words_for_quantity(std::string(column.quantity)),
                                   .files = files_of(group, *trial),
                                   .factor = factor.value,
                                   .unit = factor.meaning,
                                   .prefix = factor.prefix,
                                   .chi2_before = before,
                                   .chi2_after = after,
                                   .dof = dof};
            }
        }
    }
    return best;
}

}  // namespace pendular
