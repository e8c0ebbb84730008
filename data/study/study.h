#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/files/formats/file_format.h"
#include "data/grains.h"
#include "data/input_error.h"
#include "data/reading.h"
#include "data/study/effect_tables.h"
#include "data/study/rig.h"

namespace pendular {

/// Entry [[recording]] (raw time series) or [[readings]] (table of readings) of study.toml.
struct Source {
    enum class Kind { recording, readings };
    Kind kind = Kind::recording;
    std::string pattern;  ///< of file paths, relative to the study's folder
    /// Files that match the pattern, sorted by path; of workbooks the sheets that are read, in the
    /// order of the workbook (`SheetPath`).
    std::vector<std::filesystem::path> files;
    std::optional<double> liquid_content;  ///< [1]; empty: not stated
    /// Solid volume of the grains in the cell [m^3]; empty: the volume in [cell] holds.
    std::optional<double> bead_volume;
    bool at_failure = false;  ///< points of failure (state = "failure") rather than steady shear
    FileFormat format = {};
    Position position;
};

/// Effect in the list `effects` of [model], which makes it part of the study's model.
struct ListedEffect {
    std::string name;
    Position position;
};

/// Stress ratio of a wet reading, to which a constant cohesion is fitted: the slope of the stress
/// ratio against the reciprocal normal stress.
struct MeasuredStrength {
    Condition condition;
    double stress_ratio = 0;    ///< [1]
    double standard_error = 0;  ///< [1]
};

/// Model that is fitted to the readings: table [model] of study.toml.
struct ModelSettings {
    /// Base model of wet grains. "dem" predicts wet grains by simulations. "rumpf" adds a cohesion
    /// by Rumpf's formula to the simulated strength of dry grains, and "mohr-coulomb" constant
    /// cohesions, which are fitted to `strengths`.
    std::string base = "dem";
    /// Strengths of the study's wet readings, for the base "mohr-coulomb". They are not part of
    /// study.toml: `with_strengths` computes them.
    std::vector<MeasuredStrength> strengths = {};
    std::vector<std::string> calibrate = {"friction"};  ///< parameters to fit
    std::string fit_to = "dry";         ///< readings to which the model is fitted: "dry" or "all"
    std::vector<ListedEffect> effects;  ///< each once; names are not checked and may be unknown
    FormulaVariant bridge_force = FormulaVariant::derived;
    /// Expected relative standard errors [1] of the predicted stress ratio and solid fraction; 0
    /// if the model counts as exact. `read_study` sets `usual_discrepancy` where study.toml states
    /// none.
    std::array<double, 2> discrepancy = {0, 0};
    bool discrepancy_stated = false;  ///< whether study.toml states it
};

/// Relative standard errors [1] of stress ratio and solid fraction that a model is expected to
/// have: about what independent codes differ by at equal states. The means of five sets of states
/// differ by up to 0.40 +- 0.26 % and 0.024 +- 0.059 % between LAMMPS and the solver, and five
/// states by 0.2 +- 0.2 % and up to 0.15 % between YADE and the solver (docs/validation.md). Half
/// of the variance is smooth (`discrepancy_correlation`).
inline constexpr std::array<double, 2> usual_discrepancy = {0.004, 0.0006};

/// Settings for the conversion of recordings to readings: table [import] of study.toml.
struct ImportSettings {
    bool keep_implausible = false;  ///< use physically implausible readings
    /// Smallest shear strain of the steady part of a step [1]; a step with less is excluded.
    double least_strain = 1;
};

/// Scatter that the user states in the table [scatter] of study.toml: relative standard deviations
/// [1] of the shear stress (index 0) and the solid fraction (index 1).
struct StatedScatter {
    Eigen::Vector2d step = Eigen::Vector2d::Zero();     ///< between repetitions of one step
    Eigen::Vector2d filling = Eigen::Vector2d::Zero();  ///< between fillings of the cell
};

/// Content of study.toml.
struct Study {
    std::filesystem::path folder;  ///< to which paths are relative
    std::filesystem::path file;    ///< path of study.toml
    GrainProperties grains;
    std::optional<Liquid> liquid;
    std::optional<AnnularCell> cell;  ///< always stated if the study has recordings
    std::vector<Source> sources;      ///< in the order of study.toml
    ImportSettings import;
    std::optional<StatedScatter> scatter;
    ModelSettings model;
    std::vector<WrittenEffect> written_effects;
    std::vector<StatedDirect> direct;
    InstrumentTable instrument;
    /// Whether the volume of the grains follows from their weighed mass, nowhere from a volume.
    bool beads_weighed = true;
    std::optional<Rig> rig;  ///< empty: `next` stays within the range of the readings
};

/// Reads the file study.toml of a study and checks every key. Quantities are texts with a unit, or
/// plain numbers if dimensionless.
/// @param study folder of the study, or path of its study.toml
/// @throws InputError at file:line:column if a key is missing or unknown (the message suggests the
///         nearest known key), a unit has the wrong dimension, a value is invalid (an inner radius
///         above the outer radius for example), a file is missing, belongs to two entries or,
///         unless allow_outside is true, is outside of the folder, or the study has no file of
///         measurements
Study read_study(const std::filesystem::path& study);

/// Pattern of file paths in an entry of study.toml. Files that match it need not exist.
struct FilePattern {
    Source::Kind kind = Source::Kind::recording;
    std::string pattern;  ///< relative to the study's folder
    FileFormat format = {};
};

/// Returns the patterns of file paths in study.toml, first of [[recording]], then of [[readings]].
/// Nothing else is checked, and the study may have no measurements yet.
/// @param study folder of the study, or path of its study.toml
/// @throws InputError if study.toml cannot be read, or has an error of syntax, of its top level or
///         of these entries
std::vector<FilePattern> read_patterns(const std::filesystem::path& study);

/// Whether a study may use files outside of its folder: allow_outside of study.toml, by default
/// false.
/// @param study folder of the study, or path of its study.toml
/// @throws InputError if study.toml cannot be read, or has an error of syntax or of its top level
bool allows_outside(const std::filesystem::path& study);

/// Set points of the lid of an annular rheometer.
struct SetPoint {
    double normal_force = 0;      ///< [N]
    double angular_velocity = 0;  ///< [rad/s]
};

/// Returns the set points that impose the normal stress and the inertial number of a condition;
/// empty if the study states no cell. The sample height is computed from a typical solid fraction
/// of 0.6, so that the angular velocity is right within a few per cent.
std::optional<SetPoint> set_point_of(const Condition& condition, const Study& study);

}  // namespace pendular
