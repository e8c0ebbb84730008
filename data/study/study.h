#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/grains.h"
#include "data/input_error.h"
#include "data/reading.h"
#include "data/study/direct_table.h"
#include "data/study/effect_tables.h"
#include "data/study/rig.h"
#include "data/study/stated_scatter.h"

namespace pendular {

/// One [[recording]] or [[readings]] entry with its glob already resolved.
struct Source {
    enum class Kind { recording, readings };
    Kind kind = Kind::recording;
    std::string pattern;                       ///< of its files, relative to the study's folder
    std::vector<std::filesystem::path> files;  ///< matches of the pattern, by name
    std::optional<double> liquid_content;      ///< Phi_L/Phi_S [1]
    std::optional<double> bead_volume;         ///< [m^3], where the entry overrides the cell's
    Position position;                         ///< of the entry in the study file
};

/// An effect that a study switches on.
struct ListedEffect {
    std::string name;
    Position position;  ///< in the list
};

/// Settings of the model: [model] in study.toml.
struct ModelSettings {
    std::string base = "dem";
    std::vector<std::string> calibrate = {"friction"};
    std::string fit_to = "dry";         ///< "dry" or "all"
    std::vector<ListedEffect> effects;  ///< each once; whether they exist is not known here
    FormulaVariant bridge_force = FormulaVariant::derived;
};

/// Settings of import: [import] in study.toml.
struct ImportSettings {
    bool keep_implausible = false;  ///< doubted readings are used all the same
    double least_strain = 1;        ///< of the steady part of a step [1]; less is no steady shear
};

/// A study folder: what belongs together.
struct Study {
    std::filesystem::path folder;
    std::filesystem::path file;
    GrainProperties grains;
    std::optional<Liquid> liquid;
    std::optional<AnnularCell> cell;  ///< needed by recordings
    std::vector<Source> sources;      ///< in run order
    ImportSettings import;
    std::optional<StatedScatter> scatter;  ///< of the instrument, where the study knows it
    ModelSettings model;
    std::vector<WrittenEffect> written_effects;
    std::vector<StatedDirect> direct;  ///< effects that were measured by themselves
    std::optional<Rig> rig;
};

/// Reads STUDY/study.toml (or the file itself). Every key is checked; quantities are strings with
/// their unit, or plain numbers where dimensionless.
/// @throws InputError at file:line:column for anything missing, unknown (with the nearest known
///         key), of the wrong dimension, or impossible (Ri >= Re, density <= 0, ...)
Study read_study(const std::filesystem::path& study);

/// Warning where a liquid content [1] is beyond the range of separate liquid bridges; empty within
/// it.
std::optional<std::string> pendular_range_warning(double liquid_content);

}  // namespace pendular
