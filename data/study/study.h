#pragma once

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
#include "data/study/direct_table.h"
#include "data/study/effect_tables.h"
#include "data/study/rig.h"
#include "data/study/stated_scatter.h"

namespace pendular {

/// Entry [[recording]] (raw time series) or [[readings]] (table of readings) of study.toml, with
/// the files that the entry names.
struct Source {
    enum class Kind { recording, readings };
    Kind kind = Kind::recording;
    std::string pattern;  ///< pattern of file paths, relative to the study's folder
    std::vector<std::filesystem::path> files;  ///< files that match the pattern, sorted by path
    /// Liquid content: volume of liquid divided by volume of grains [1]; empty if the entry does
    /// not state the liquid content.
    std::optional<double> liquid_content;
    /// Solid volume of the grains in the cell [m^3], if the entry states the volume; empty: the
    /// volume in the table [cell] holds.
    std::optional<double> bead_volume;
    /// Whether the readings of the entry are points of failure (state = "failure") rather than
    /// steady shear.
    bool at_failure = false;
    /// Settings that the entry states for reading the entry's files, such as layout and decimal
    /// mark.
    FileFormat format = {};
    Position position;  ///< position of the entry in study.toml
};

/// Physical effect in the list `effects` of the table [model] in study.toml, which makes the effect
/// part of the study's model.
struct ListedEffect {
    std::string name;
    Position position;  ///< position of the effect's name in study.toml
};

/// Measured stress ratio of a wet reading, to which a constant cohesion is fitted. The cohesion is
/// the slope of the stress ratio against the reciprocal normal stress.
struct MeasuredStrength {
    Condition condition;        ///< condition of the wet reading
    double stress_ratio = 0;    ///< measured stress ratio of the wet reading [1]
    double standard_error = 0;  ///< standard error of the reading's stress ratio [1]
};

/// Settings of the model that is fitted to the readings: table [model] of study.toml.
struct ModelSettings {
    /// Base model of wet grains: "dem", "rumpf" or "mohr-coulomb". The model "dem" predicts wet
    /// grains by simulations. The model "rumpf" adds a cohesion by Rumpf's formula to the simulated
    /// strength of dry grains. The model "mohr-coulomb" adds constant cohesions, which are fitted
    /// to `strengths`, to the simulated strength of dry grains.
    std::string base = "dem";
    /// Strengths (stress ratios) of the study's wet readings, which are needed if the base model is
    /// "mohr-coulomb". The strengths are not part of study.toml; the function `with_strengths`
    /// computes the strengths.
    std::vector<MeasuredStrength> strengths = {};
    /// Names of the model's parameters to fit, such as "friction".
    std::vector<std::string> calibrate = {"friction"};
    std::string fit_to = "dry";  ///< readings to which the model is fitted: "dry" or "all"
    /// Physical effects that study.toml lists for the model, each once. The names of the effects
    /// are not checked, so that a name may be unknown.
    std::vector<ListedEffect> effects;
    /// Variant of the formula of the bridge force: `derived`, or `as_printed` in Badetti et al.
    /// (2018).
    FormulaVariant bridge_force = FormulaVariant::derived;
    /// Expected relative standard errors [1] of the model's predictions of the stress ratio (first
    /// element) and of the solid fraction (second element). The standard errors are 0 if the model
    /// counts as exact.
    std::array<double, 2> discrepancy = {0, 0};
};

/// Settings for the conversion of recordings to readings: table [import] of study.toml.
struct ImportSettings {
    /// Whether physically implausible readings are used rather than excluded.
    bool keep_implausible = false;
    /// Smallest allowed shear strain of the steady part of a step [1]. A step with a shorter steady
    /// part is excluded.
    double least_strain = 1;
};

/// Content of the file study.toml of a study: grains, liquid, cell, measured files and model.
struct Study {
    std::filesystem::path folder;  ///< folder of the study, to which paths are relative
    std::filesystem::path file;    ///< path of the study's file study.toml
    GrainProperties grains;
    std::optional<Liquid> liquid;
    /// Annular cell of the rheometer, if stated; always stated if the study has recordings.
    std::optional<AnnularCell> cell;
    std::vector<Source> sources;  ///< recordings and tables of readings, in the order of study.toml
    ImportSettings import;
    /// Scatter between repeated readings, if the user stated the scatter in the table [scatter].
    std::optional<StatedScatter> scatter;
    ModelSettings model;
    std::vector<WrittenEffect> written_effects;  ///< effects that the study defines by formulas
    /// Direct measurements of effect parameters, made without shearing grains, in the order of
    /// study.toml.
    std::vector<StatedDirect> direct;
    /// Conditions at which the measuring rig can take further readings, with the costs of the
    /// readings, if stated in the table [rig].
    std::optional<Rig> rig;
};

/// Reads the file study.toml of a study and checks every key. Quantities are texts with a unit, or
/// plain numbers if dimensionless.
/// @param study folder of the study, or path of its study.toml
/// @throws InputError at file:line:column if a key is missing or unknown (the message suggests the
///         nearest known key), a unit has the wrong dimension, a value is invalid (an inner radius
///         above the outer radius for example), a file is missing or belongs to two entries, or the
///         study has no file of measurements. A file outside of the study's folder is an error
///         unless allow_outside is true.
Study read_study(const std::filesystem::path& study);

/// Pattern of file paths in an entry [[recording]] or [[readings]] of study.toml. Files that match
/// the pattern need not exist.
struct FilePattern {
    Source::Kind kind = Source::Kind::recording;
    std::string pattern;  ///< pattern of file paths, relative to the study's folder
    /// Settings that the entry states for reading the entry's files, such as layout and decimal
    /// mark.
    FileFormat format = {};
};

/// Reads only the patterns of file paths from study.toml, first from the entries [[recording]],
/// then from the entries [[readings]]. The files are not read. The study may have no measurements
/// yet.
/// @param study folder of the study, or path of its study.toml
/// @throws InputError at file:line:column if study.toml cannot be read, has a syntax error or an
///         unknown key of the top level or of an entry, or if a key that says how files are read
///         has a wrong value
std::vector<FilePattern> read_patterns(const std::filesystem::path& study);

/// Returns a warning for the user if a liquid content is outside of the pendular range (0.002 to
/// 0.075), in which the liquid forms separate bridges. The result is empty inside the pendular
/// range and for dry grains.
/// @param liquid_content volume of liquid divided by volume of grains [1]
std::optional<std::string> pendular_range_warning(double liquid_content);

}  // namespace pendular
