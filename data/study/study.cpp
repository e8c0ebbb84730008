#include "data/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "data/files/file_access.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/number_style.h"
#include "data/files/formats/sheets.h"
#include "data/files/text_file.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/study/study_table.h"

namespace pendular {
namespace {

using Keys = std::vector<std::string>;

const Keys top_keys = {"grains",  "liquid",     "cell",         "recording", "readings",
                       "model",   "effect",     "direct",       "rig",       "import",
                       "scatter", "instrument", "allow_outside"};
const Keys grains_keys = {"diameter", "density", "youngs_modulus", "poisson_ratio"};
const Keys liquid_keys = {"surface_tension", "contact_angle", "viscosity"};
const Keys cell_keys = {"inner_radius",   "outer_radius", "bead_mass",    "bead_volume",
                        "torque_formula", "lever_arm",    "wall_friction"};
const Keys readings_keys = {"file",    "liquid_content", "bead_mass", "bead_volume", "encoding",
                            "decimal", "state",          "sheet",     "missing",     "columns"};
const Keys recording_keys = {"file",      "liquid_content", "bead_mass", "bead_volume",
                             "encoding",  "layout",         "decimal",   "columns",
                             "intervals", "repair",         "sheet",     "missing"};
const Keys import_keys = {"keep_implausible", "least_strain"};
const Keys model_keys = {"base", "calibrate", "fit_to", "effects", "bridge_force", "discrepancy"};

const Keys scatter_keys = {"shear_stress", "solid_fraction", "shear_stress_of_filling",
                           "solid_fraction_of_filling"};
/// Largest shares [1] that a study may state. Larger numbers are percentages, or a model that
/// describes nothing.
constexpr double largest_scatter = 0.5;
constexpr double largest_discrepancy = 0.2;

/// Largest friction coefficient [1] of side walls that a study may state: an angle of 56 deg.
/// Larger numbers are angles in degrees.
constexpr double largest_wall_friction = 1.5;

constexpr double right_angle = 1.5707963267948966;

/// Columns by the quantities as which they are read.
/// @throws InputError at a key that names no quantity
std::map<std::string, std::string> read_named_columns(const StudyTable& table) {
    std::map<std::string, std::string> columns;
    for (const std::string& key : table.keys()) {
        const Quantity* const known = find_quantity(key);
        if (!known) {
            std::vector<std::string> names;
            for (const Quantity& each : quantities())
                names.emplace_back(each.name);
            throw InputError(table.at(key),
                             fmt::format("'{}' is no quantity; {}", key, did_you_mean(key, names)));
        }
        columns[std::string(known->name)] = table.text(key).value_or("");
    }
    return columns;
}

/// Values that an entry declares missing.
/// @throws InputError at one that is no number in any style
std::vector<std::string> read_missing(const StudyTable& entry) {
    std::vector<std::string> values;
    for (Word& word : entry.placed_words("missing")) {
        const auto is_number = [&](char mark) {
            return parse_number(rewritten(word.text, {.decimal = mark, .rewrite = true}));
        };
        if (!is_number('.') && !is_number(','))
            throw InputError(word.position,
                             fmt::format("'missing': \"{}\" is no number; write a number such as "
                                         "\"-999\", and leave out words such as \"NaN\", which "
                                         "count as missing anyway",
                                         word.text));
        values.push_back(std::move(word.text));
    }
    return values;
}

/// File format that an entry [[recording]] or [[readings]] states.
/// @throws InputError at the key for an unknown layout, role of an interval or decimal mark
FileFormat read_file_format(const StudyTable& entry) {
    FileFormat format;
    if (entry.has("layout")) format.layout = entry.choice("layout", layout_names());
    if (entry.has("decimal")) format.decimal = entry.choice("decimal", {".", ","});
    format.sheet = entry.text("sheet").value_or("");
    format.encoding = entry.text("encoding").value_or("");
    if (entry.holds_table("columns"))
        format.named_columns = read_named_columns(*entry.open_table("columns"));
    else
        format.columns = entry.words("columns", {});
    format.missing = read_missing(entry);
    format.repair = entry.flag("repair").value_or(false);
    if (const auto intervals = entry.table("intervals", interval_roles())) {
        for (const std::string& role : interval_roles())
            if (intervals->has(role)) format.roles[role] = intervals->words(role, {});
    }
    return format;
}

/// Path of study.toml, from the path of this file or of its folder.
/// @throws InputError if the file does not exist
std::filesystem::path study_file(const std::filesystem::path& study) {
    std::error_code error;  // set for a link to itself, for example
    if (!std::filesystem::exists(study, error))
        throw InputError({study.string()},
                         error == std::errc::too_many_symbolic_link_levels
                             ? "is a link that leads to itself; name the folder of a study"
                             : "does not exist; name a study folder or its study.toml");
    if (!std::filesystem::is_directory(study, error)) {
        if (study.extension() == ".csv" || study.extension() == ".txt" ||
            study.extension() == ".xlsx")
            throw InputError({study.string()},
                             "is no study but a file of measurements; begin a study with it: "
                             "pendular import FILE --study DIR");
        return study;
    }
    if (!std::filesystem::exists(study / "study.toml", error))
        throw InputError({study.string()},
                         "has no study.toml; name a folder that has one, or begin a study from a "
                         "file of measurements or all files of a folder: pendular import "
                         "FILE_OR_FOLDER --study NEW_FOLDER");
    return study / "study.toml";
}

GrainProperties read_grains(const StudyTable& root) {
    const auto table = root.table("grains", grains_keys);
    if (!table)
        throw InputError(root.position(), "[grains] is missing; add it with diameter and density");
    GrainProperties grains;
    grains.diameter = table->positive_quantity("diameter", "m");
    grains.density = table->positive_quantity("density", "kg/m^3");
    if (table->has("youngs_modulus"))
        grains.youngs_modulus = table->positive_quantity("youngs_modulus", "Pa");
    grains.poisson_ratio = table->quantity("poisson_ratio", "1").value_or(grains.poisson_ratio);
    if (grains.poisson_ratio <= -1 || grains.poisson_ratio >= 0.5)
        table->refuse("poisson_ratio", "must lie between -1 and 0.5");
    return grains;
}

std::optional<Liquid> read_liquid(const StudyTable& root) {
    const auto table = root.table("liquid", liquid_keys);
    if (!table) return std::nullopt;
    Liquid liquid;
    liquid.surface_tension = table->positive_quantity("surface_tension", "N/m");
    // Rhenium has 2.7 N/m where it melts, the most of all elements (Keene,
    // International Materials Reviews 38, 1993).
    constexpr double largest_surface_tension = 3;
    if (liquid.surface_tension > largest_surface_tension)
        table->refuse("surface_tension",
                      "is above that of any liquid (water 72.8 mN/m, silicone oil 21 mN/m, mercury "
                      "485 mN/m): check its unit, which may be mN/m rather than N/m");
    liquid.contact_angle = table->required_quantity("contact_angle", "rad");
    if (liquid.contact_angle < 0 || liquid.contact_angle >= right_angle)
        table->refuse(
            "contact_angle",
            "must lie between 0 and 90 deg: above 90 deg a liquid does not attract the beads");
    liquid.viscosity = table->quantity("viscosity", "Pa s").value_or(0);
    if (liquid.viscosity < 0) table->refuse("viscosity", "must not be negative");
    return liquid;
}

/// Solid volume of the grains [m^3] that a table states as mass or volume; empty if it states
/// neither.
/// @throws InputError if it states both, or a value that is not positive
std::optional<double> bead_volume(const StudyTable& table, const GrainProperties& grains) {
    if (table.has("bead_mass") && table.has("bead_volume"))
        table.refuse("bead_volume", "'bead_mass' is given too; remove one");
    if (table.has("bead_mass")) return table.positive_quantity("bead_mass", "kg") / grains.density;
    if (table.has("bead_volume")) return table.positive_quantity("bead_volume", "m^3");
    return std::nullopt;
}

/// Whether the cell or an entry states the volume of the grains in place of their mass.
bool states_volume(const StudyTable& root) {
    const auto has_volume = [](const StudyTable& table) { return table.has("bead_volume"); };
    const auto cell = root.table("cell", cell_keys);
    return (cell && has_volume(*cell)) ||
           std::ranges::any_of(root.tables("recording", recording_keys), has_volume) ||
           std::ranges::any_of(root.tables("readings", readings_keys), has_volume);
}

FormulaVariant form(const StudyTable& table, std::string_view key) {
    return formula_variant_named(table.choice(key, formula_variant_names()));
}

std::optional<AnnularCell> read_cell(const StudyTable& root, const GrainProperties& grains) {
    const auto table = root.table("cell", cell_keys);
    if (!table) return std::nullopt;
    AnnularCell cell;
    cell.inner_radius = table->required_quantity("inner_radius", "m");
    cell.outer_radius = table->positive_quantity("outer_radius", "m");
    if (cell.inner_radius < 0) table->refuse("inner_radius", "must not be negative");
    if (cell.inner_radius >= cell.outer_radius)
        table->refuse("inner_radius", "must be smaller than 'outer_radius'");
    cell.bead_volume = bead_volume(*table, grains).value_or(0);
    cell.torque_formula = form(*table, "torque_formula");
    cell.wall_friction = table->quantity("wall_friction", "1");
    if (cell.wall_friction.value_or(0) < 0 ||
        cell.wall_friction.value_or(0) > largest_wall_friction)
        table->refuse(
            "wall_friction",
            fmt::format("must lie between 0 and {}; it is the tangent of the angle of wall "
                        "friction",
                        largest_wall_friction));
    if (table->has("lever_arm")) cell.lever_arm = table->positive_quantity("lever_arm", "m");
    return cell;
}

/// Checks that the beads fit into the cell: between its walls and, as a filling, below the lid.
/// @throws InputError if a bead is larger than the gap between the walls, or than the height of the
///         filling
void check_bead_size(const StudyTable& root, const Study& study) {
    if (!study.cell) return;
    // Random loose packing has a solid fraction of 0.55; a filling under load is denser than 0.4,
    // even one that bridges hold open.
    constexpr double too_loose = 0.4;
    const double diameter = study.grains.diameter,
                 width = study.cell->outer_radius - study.cell->inner_radius,
                 volume = study.cell->bead_volume,
                 height = volume / (too_loose * study.cell->area());
    const StudyTable grains = *root.table("grains", grains_keys);
    const auto refuse = [&](const std::string& than) {
        grains.refuse("diameter", fmt::format("beads of {:.4g} mm are larger than {}; check the "
                                              "diameter and its unit, and [cell]",
                                              1e3 * diameter, than));
    };
    if (diameter > width)
        refuse(fmt::format("the gap between the walls of the cell, {:.4g} mm", 1e3 * width));
    if (volume > 0 && diameter > height)
        refuse(
            fmt::format("the height of the filling, which the beads in the cell reach even as "
                        "a loose bed, {:.4g} mm",
                        1e3 * height));
}

std::string no_file(const std::string& pattern, const Study& study) {
    return fmt::format("no file matches \"{}\" in {}; put the file there, or correct the name",
                       pattern, study.folder.string());
}

/// Files of an entry, which are in the study's folder unless `allow_outside`. A pattern with a
/// wildcard may match no file yet.
/// @throws InputError if a file that is named without a wildcard is missing, or a file is elsewhere
std::vector<std::filesystem::path> files_of(const StudyTable& table, const std::string& pattern,
                                            const Study& study, bool allow_outside) {
    const auto refuse_outside = [&](const std::string& path) {
        if (allow_outside) return;
        table.refuse("file",
                     fmt::format("{} is outside of the study's folder; write allow_outside "
                                 "= true above the first table of study.toml if it is to be "
                                 "read, or copy it to the study",
                                 path));
    };
    // Checked before the search, which could open folders of the whole disk.
    const std::filesystem::path normal = std::filesystem::path(pattern).lexically_normal();
    const bool elsewhere = normal.is_absolute() && !is_within(normal.parent_path(), study.folder);
    if (elsewhere || (!normal.empty() && *normal.begin() == ".."))
        refuse_outside(fmt::format("\"{}\"", pattern));
    std::vector<std::filesystem::path> files;
    try {
        files = matching_files(study.folder, pattern);
    } catch (const std::invalid_argument& error) {
        table.refuse("file", error.what());
    }
    if (files.empty() && pattern.find_first_of("*?[") == std::string::npos)
        table.refuse("file", no_file(pattern, study));
    for (const std::filesystem::path& file : files)
        if (!is_within(file, study.folder)) refuse_outside(file.string());
    return files;
}

Source read_source(const StudyTable& table, Source::Kind kind, const Study& study,
                   bool allow_outside) {
    Source source{.kind = kind,
                  .pattern = {},
                  .files = {},
                  .liquid_content = {},
                  .bead_volume = {},
                  .format = read_file_format(table),
                  .position = table.position()};
    const auto pattern = table.text("file");
    if (!pattern) throw InputError(table.position(), "lacks 'file'; add file = \"....csv\"");
    source.pattern = *pattern;
    for (const auto& file : files_of(table, source.pattern, study, allow_outside)) {
        const auto sheets = chosen_sheets(file, source.format.sheet).read;
        source.files.insert(source.files.end(), sheets.begin(), sheets.end());
    }
    source.liquid_content = table.quantity("liquid_content", "1");
    if (source.liquid_content.value_or(0) < 0)
        table.refuse("liquid_content", "must not be negative");
    if (source.liquid_content.value_or(0) > 0 && !study.liquid)
        table.refuse("liquid_content", "is above 0, but the study has no [liquid]; add it");
    source.bead_volume = bead_volume(table, study.grains);
    return source;
}

/// Checks that a study has what an entry [[recording]] needs: the cell, the volume of the grains in
/// it and, if the study has a liquid, the entry's liquid content.
/// @throws InputError if cell, volume or liquid content is missing
void check_recording(const Source& source, const Study& study) {
    if (!study.cell)
        throw InputError(source.position,
                         "recordings need [cell] with inner_radius, outer_radius and bead_mass");
    if (!source.bead_volume && study.cell->bead_volume == 0)
        throw InputError(source.position,
                         "'bead_mass' is given neither here nor in [cell]; add it to one");
    if (study.liquid && !source.liquid_content)
        throw InputError(source.position,
                         "lacks 'liquid_content'; add it, 0 where the beads were dry");
}

/// Checks that no file belongs to two entries of study.toml.
/// @throws InputError if a file belongs to two entries
void check_overlap(const std::vector<Source>& sources) {
    std::map<std::filesystem::path, int> line_of;
    for (const Source& source : sources) {
        for (const std::filesystem::path& file : source.files) {
            const auto [earlier, added] = line_of.emplace(file, source.position.line);
            if (added) continue;
            throw InputError(source.position,
                             fmt::format("'file': {} was already matched by the entry of line {}; "
                                         "narrow one of the patterns",
                                         file.filename().string(), earlier->second));
        }
    }
}

std::vector<Source> read_sources(const StudyTable& root, const Study& study) {
    std::vector<Source> sources;
    const bool allow_outside = root.flag("allow_outside").value_or(false);
    std::optional<Position> first_pattern;
    for (const StudyTable& table : root.tables("recording", recording_keys)) {
        sources.push_back(read_source(table, Source::Kind::recording, study, allow_outside));
        check_recording(sources.back(), study);
        if (!first_pattern) first_pattern = table.at("file");
    }
    for (const StudyTable& table : root.tables("readings", readings_keys)) {
        sources.push_back(read_source(table, Source::Kind::readings, study, allow_outside));
        sources.back().at_failure = table.choice("state", {"steady", "failure"}) == "failure";
        if (!first_pattern) first_pattern = table.at("file");
    }
    if (sources.empty())
        throw InputError(root.position(),
                         "nothing was measured; add a [[recording]] or [[readings]] with its file");
    if (std::ranges::all_of(sources, [](const Source& s) { return s.files.empty(); })) {
        throw InputError(*first_pattern, "'file': " + no_file(sources.front().pattern, study));
    }
    std::stable_sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) {
        return a.position.line < b.position.line;  // order of measurement
    });
    check_overlap(sources);
    return sources;
}

ImportSettings read_import(const StudyTable& root) {
    ImportSettings choice;
    const auto table = root.table("import", import_keys);
    if (!table) return choice;
    choice.keep_implausible = table->flag("keep_implausible").value_or(choice.keep_implausible);
    choice.least_strain = table->quantity("least_strain", "1").value_or(choice.least_strain);
    if (choice.least_strain < 0.5)
        table->refuse(
            "least_strain",
            "must be 0.5 or more: after smaller strains, grains are not yet in steady shear");
    return choice;
}

std::optional<StatedScatter> read_scatter(const StudyTable& root) {
    const auto table = root.table("scatter", scatter_keys);
    if (!table) return std::nullopt;
    StatedScatter scatter;
    scatter.step = {table->positive_quantity("shear_stress", "1"),
                    table->positive_quantity("solid_fraction", "1")};
    scatter.filling = {table->quantity("shear_stress_of_filling", "1").value_or(0),
                       table->quantity("solid_fraction_of_filling", "1").value_or(0)};
    for (const auto& key : scatter_keys) {
        const double value = table->quantity(key, "1").value_or(0);
        if (value < 0 || value > largest_scatter)
            table->refuse(key, "must lie between 0 and 50 % of the value");
    }
    return scatter;
}

std::vector<ListedEffect> read_listed_effects(const StudyTable& model) {
    std::vector<ListedEffect> effects;
    for (const auto& [name, position] : model.placed_words("effects")) {
        if (std::ranges::find(effects, name, &ListedEffect::name) != effects.end())
            throw InputError(position,
                             fmt::format("'effects': \"{}\" is listed twice; remove one", name));
        effects.push_back({name, position});
    }
    return effects;
}

/// Expected error of the model: one number for the stress ratio, or two.
std::array<double, 2> read_discrepancy(const StudyTable& table) {
    const std::vector<double> numbers = table.numbers("discrepancy");
    if (numbers.empty() && !table.has("discrepancy")) return usual_discrepancy;
    if (numbers.empty() || numbers.size() > 2) {
        table.refuse("discrepancy",
                     "must be one number (of the stress ratio) or two (of stress ratio and solid "
                     "fraction), as in [0.005, 0.001]");
    }
    for (const double number : numbers) {
        if (number < 0 || number > largest_discrepancy) {
            table.refuse("discrepancy",
                         fmt::format("must be between 0 and {}, relative to the value",
                                     largest_discrepancy));
        }
    }
    return {numbers[0], numbers.size() == 2 ? numbers[1] : 0};
}

ModelSettings read_model(const StudyTable& root) {
    ModelSettings model;
    model.discrepancy = usual_discrepancy;
    const auto table = root.table("model", model_keys);
    if (!table) return model;
    model.base = table->choice("base", {"dem", "rumpf", "mohr-coulomb"});
    model.calibrate = table->words("calibrate", model.calibrate);
    if (model.calibrate != Keys{"friction"})
        table->refuse("calibrate",
                      "must be [\"friction\"], the only parameter that can be calibrated");
    model.fit_to = table->choice("fit_to", {"dry", "all"});
    model.effects = read_listed_effects(*table);
    model.bridge_force = form(*table, "bridge_force");
    model.discrepancy = read_discrepancy(*table);
    model.discrepancy_stated = table->has("discrepancy");
    return model;
}

}  // namespace

Study read_study(const std::filesystem::path& path) {
    Study study;
    study.file = study_file(path);
    study.folder = study.file.has_parent_path() ? study.file.parent_path() : ".";
    const StudyTable root = StudyTable::read(study.file, top_keys);
    study.grains = read_grains(root);
    study.liquid = read_liquid(root);
    study.cell = read_cell(root, study.grains);
    check_bead_size(root, study);
    study.model = read_model(root);
    study.written_effects = read_written_effects(root);
    study.direct = read_direct(root);
    study.instrument = read_instrument(root);
    study.beads_weighed = !states_volume(root);
    study.rig = read_rig(root, study.grains, study.liquid.has_value());
    study.sources = read_sources(root, study);
    study.import = read_import(root);
    study.scatter = read_scatter(root);
    return study;
}

bool allows_outside(const std::filesystem::path& study) {
    return StudyTable::read(study_file(study), top_keys).flag("allow_outside").value_or(false);
}

std::vector<FilePattern> read_patterns(const std::filesystem::path& study) {
    const StudyTable root = StudyTable::read(study_file(study), top_keys);
    std::vector<FilePattern> patterns;
    const auto read = [&](const char* name, const Keys& keys, Source::Kind kind) {
        for (const StudyTable& entry : root.tables(name, keys))
            if (const auto pattern = entry.text("file"))
                patterns.push_back({kind, *pattern, read_file_format(entry)});
    };
    read("recording", recording_keys, Source::Kind::recording);
    read("readings", readings_keys, Source::Kind::readings);
    return patterns;
}

std::optional<SetPoint> set_point_of(const Condition& condition, const Study& study) {
    if (!study.cell) return {};
    AnnularCell cell = *study.cell;
    cell.bead_volume = condition.bead_volume.value_or(cell.bead_volume);
    constexpr double typical_solid_fraction = 0.6;  // the height is known only after the filling
    const double rate =
        shear_rate_at(condition.inertial_number, condition.normal_stress, study.grains);
    return SetPoint{normal_force(condition.normal_stress, cell),
                    angular_velocity(rate, height(typical_solid_fraction, cell), cell)};
}

}  // namespace pendular
