#include "workflow/begin_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "data/files/file_access.h"
#include "data/files/formats/sheets.h"
#include "data/files/sheet_path.h"
#include "data/files/text_file.h"
#include "data/input_error.h"
#include "data/quantities/quantity.h"
#include "data/quantities/units.h"
#include "data/recordings/stated_sample.h"
#include "data/remarks/wording.h"
#include "data/study/study_edit.h"
#include "workflow/begun_tables.h"
#include "workflow/file_views.h"
#include "workflow/study_guesses.h"

namespace pendular {
namespace {

/// Text for a comment, without the control characters that TOML does not allow there.
std::string comment_text(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    return text;
}

std::string entry(const std::string& key, const Guess& guess) {
    const std::string setting = fmt::format("{} = {}", key, toml_string(guess.value));
    return fmt::format("{:<32} # {}\n", setting, comment_text(guess.from));
}

/// Whether the header of a file states both radii of the cell.
bool states_radii(const FileView& view) {
    return view.stated.inner_radius && view.stated.outer_radius &&
           view.stated.inner_radius->value < view.stated.outer_radius->value;
}

/// Whether a file has the force on a lever in place of a torque.
bool lacks_torque(const FileView& view) {
    return std::ranges::any_of(view.series, [](const IntervalSeries& series) {
        return !series.lever_force.empty() && series.shear() == series.lever_force;
    });
}

/// Comment on a value that stands above the table.
std::string from_line(const StatedValue& stated) {
    const std::string text =
        fmt::format("\"{}: {}\" in line {} of the file", stated.key, stated.text, stated.line);
    switch (stated.doubt) {
        case StatedDoubt::other_mark:
            return "GUESS: the mark in " + text + " may also be that of decimals";
        case StatedDoubt::range:
            return "GUESS: the middle of " + text;
        case StatedDoubt::name:
            return "GUESS: from " + text;
        case StatedDoubt::none:
            break;
    }
    return fmt::format("from line {} of the file", stated.line);
}

Guess guessed_mass(const BlockFile& file) {
    const auto mass = stated_sample(file).mass;
    if (!mass) return {"20 g", "GUESS: weigh the beads"};
    return {fmt::format("{:g} g", mass->value * 1e3), from_line(*mass)};
}

/// Radii of a common powder cell, but for the one that the file states, which then fits no other of
/// that cell.
std::string guessed_radii(const StatedCell& stated) {
    const char* const common = "GUESS: a common powder cell; no radii were found in the file";
    const auto& [inner, outer] = std::pair(stated.inner_radius, stated.outer_radius);
    if (inner.has_value() == outer.has_value())
        return entry("inner_radius", {"10.5 mm", common}) +
               entry("outer_radius", {"21.5 mm", common});
    const char* const other = "GUESS: twice the other; the file states no other radius";
    const char* const half = "GUESS: half of the other; the file states no other radius";
    const auto shown = [](double radius) { return fmt::format("{:g} mm", radius * 1e3); };
    if (inner)
        return entry("inner_radius", {shown(inner->value), from_line(*inner)}) +
               entry("outer_radius", {shown(2 * inner->value), other});
    return entry("inner_radius", {shown(outer->value / 2), half}) +
           entry("outer_radius", {shown(outer->value), from_line(*outer)});
}

/// @param steady whether any recording of the study needs the mass of the beads
std::string cell_text(const FileView& view, bool steady) {
    std::string text = "[cell]\n";
    if (states_radii(view)) {
        for (const auto& [key, stated] : {std::pair{"inner_radius", view.stated.inner_radius},
                                          std::pair{"outer_radius", view.stated.outer_radius}})
            text += entry(key, {fmt::format("{:g} mm", stated->value * 1e3), from_line(*stated)});
    } else if (view.cell.inner_radius) {
        const char* const from = "from the ratios of the file's own stresses to torque or force";
        text +=
            entry("inner_radius", {fmt::format("{:g} mm", *view.cell.inner_radius * 1e3), from});
        text +=
            entry("outer_radius", {fmt::format("{:g} mm", *view.cell.outer_radius * 1e3), from});
    } else {
        text += guessed_radii(view.stated);
    }
    if (lacks_torque(view))
        text += entry("lever_arm", {"0.2 m", "GUESS: distance of the load cell from the axis"});
    if (steady) text += entry("bead_mass", guessed_mass(view.file));
    return text + "\n";
}

/// Lines of an entry on how the file is to be read, as the user stated it.
std::string format_text(const FileFormat& format) {
    std::string text;
    for (const auto& [key, value] :
         {std::pair{"layout", format.layout}, std::pair{"encoding", format.encoding},
          std::pair{"decimal", format.decimal}, std::pair{"sheet", format.sheet}})
        if (!value.empty()) text += fmt::format("{} = {}\n", key, toml_string(value));
    std::vector<std::string> columns;
    for (const std::string& column : format.columns)
        columns.push_back(toml_string(column));
    for (const auto& [quantity, column] : format.named_columns)
        columns.push_back(fmt::format("{} = {}", quantity, toml_string(column)));
    const bool named = !format.named_columns.empty();
    if (!columns.empty())
        text += fmt::format("columns = {}{}{}\n", named ? "{ " : "[", fmt::join(columns, ", "),
                            named ? " }" : "]");
    return text;
}

/// The format that the user stated, with the columns that a view reads by their units.
FileFormat with_columns_by_unit(FileFormat format, const FileView& view) {
    format.named_columns.insert(view.by_unit.begin(), view.by_unit.end());
    return format;
}

/// Lines of an entry on how the file is to be read, as the user stated it and with the columns that
/// are read by their units.
std::string format_text(const FileFormat& format, const FileView& view) {
    std::string text = format_text(with_columns_by_unit(format, view));
    if (view.by_unit.empty()) return text;
    std::vector<std::string> guessed;
    for (const auto& [quantity_name, column] : view.by_unit)
        guessed.push_back(quantity_name);
    text.insert(text.size() - 1,
                fmt::format("   # GUESS: the file does not name {}", fmt::join(guessed, ", ")));
    return text;
}

/// Name of an interval in `intervals` of study.toml: its number, its name or, where these mean
/// other intervals too, the name of its test.
/// @throws InputError where no name tells the intervals of different roles apart
std::string name_in_study(const FileView& view, std::size_t i) {
    const auto alone = [&](const auto& is_meant) {
        for (std::size_t k = 0; k < view.roles.size(); ++k) {
            if (is_meant(view.file.blocks[k]) && view.roles[k].role != view.roles[i].role)
                return false;
        }
        return true;
    };
    const Block& block = view.file.blocks[i];
    if (block.number > 0 && alone([&](const Block& b) { return b.number == block.number; }))
        return std::to_string(block.number);
    if (!block.name.empty() && alone([&](const Block& b) { return b.name == block.name; }))
        return block.name;
    if (!block.test.empty() && alone([&](const Block& b) { return b.test == block.test; }))
        return block.test;
    throw InputError({view.file.file},
                     "holds several tests whose intervals have the same numbers and other roles; "
                     "export each test to a file of its own");
}

/// Line that gives the intervals of other roles than steady to these, so that only steady shear is
/// read from the recording; empty if there are none.
std::string roles_text(const FileView& view) {
    std::map<std::string, std::vector<std::string>> intervals;
    for (std::size_t i = 0; i < view.roles.size(); ++i) {
        const Block& block = view.file.blocks[i];
        const std::string& role = view.roles[i].role;
        if (role == "steady" || (block.number == 0 && block.name.empty() && block.test.empty()))
            continue;
        const std::string name = toml_string(name_in_study(view, i));
        if (std::ranges::find(intervals[role], name) == intervals[role].end())
            intervals[role].push_back(name);
    }
    std::vector<std::string> roles;
    for (const auto& [role, names] : intervals)
        roles.push_back(fmt::format("{} = [{}]", role, fmt::join(names, ", ")));
    return roles.empty() ? "" : fmt::format("intervals = {{ {} }}\n", fmt::join(roles, ", "));
}

/// Text with "# " before each line that is not blank.
std::string commented_out(const std::string& text) {
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        result += line.empty() ? "\n" : "# " + line + "\n";
        begin = end + 1;
    }
    return result;
}

/// Tables of a view, or of one group of its points, and their entries in study.toml.
struct Tables {
    std::map<std::string, std::string> files;
    std::string entries;
};

void add_table(Tables& tables, const std::string& name, std::string content,
               const std::string& what, const std::string& comment, const std::string& more) {
    if (content.empty()) return;
    tables.files[name] = std::move(content);
    const std::string file = "file = " + toml_string(name);
    tables.entries +=
        fmt::format("[[readings]]                     # {}\n{}\n{}\n", what,
                    comment.empty() ? file : fmt::format("{:<32} {}", file, comment), more);
}

/// @param suffix of the names of tables
/// @param comment behind the name of the table of failure
/// @param group of the points; empty: all
Tables tables_of(const FileView& view, double mass_ratio, const std::string& suffix,
                 const std::optional<std::string>& group, const std::string& comment,
                 const std::string& liquid_content) {
    const std::string of_rows = states_contents(view) ? "" : liquid_content;
    Tables tables;
    add_table(tables, fmt::format("steady{}.csv", suffix), steady_table(view, mass_ratio, group),
              "ends of the preshears, in steady shear", "", of_rows);
    if (view.loci.empty()) return tables;
    add_table(tables, fmt::format("failure{}.csv", suffix), failure_table(view, group),
              "points of failure: peaks, which may lie above steady shear", comment,
              fmt::format("state = \"failure\"{}\n{}",
                          view.file.table_of_points
                              ? "                # GUESS: peaks; for steady shear, remove this "
                                "line and the column failure"
                              : "",
                          of_rows));
    return tables;
}

std::string liquid_content_text(const LiquidGuess& liquid) {
    if (liquid.value == 0)
        return fmt::format("liquid_content = 0                # {}\n", comment_text(liquid.from));
    return fmt::format("liquid_content = {:<15g} # {}\n", liquid.value, comment_text(liquid.from));
}

/// Comment behind the name of a table of failure on what the file does not state.
/// @param group what it says of the group; empty: nothing
std::string comment_on_failure(const FileView& view, const std::string& group) {
    const bool invented = view.file.table_of_points && !states_errors(view);
    if (!invented && group.empty()) return "";
    return fmt::format("# GUESS: {}{}{}", group, invented && !group.empty() ? "; " : "",
                       invented ? "no errors are stated, and shear_stress_se is 1 %" : "");
}

/// Tables of each group of a table of points, of which the study reads the first alone: whether the
/// others are of its material is not known, and they would count as repeats of its points.
/// @param wet whether the study needs liquid contents
Tables tables_of_groups(const FileView& view, const std::vector<std::string>& groups,
                        const std::string& suffix, bool wet) {
    Tables all;
    std::set<std::string> taken;
    for (const std::string& group : groups) {
        const bool first = all.files.empty();
        const std::string named = comment_text(group.empty() ? "rows without a name" : group);
        const LiquidGuess liquid = liquid_guessed_from(texts_of_group(view, group));
        Tables own =
            tables_of(view, liquid.mass_ratio(), name_of_table(suffix, group, taken), group,
                      comment_on_failure(
                          view, first ? fmt::format("a study of \"{}\", the first of {} groups",
                                                    named, groups.size())
                                      : ""),
                      wet ? liquid_content_text(liquid) : "");
        all.files.merge(own.files);
        if (!first)
            all.entries += fmt::format(
                "# \"{}\" is not read. If its grains are those above, remove the \"# \" "
                "of these lines;\n# if not, it needs a study of its own.\n",
                named);
        all.entries += first ? own.entries : commented_out(own.entries);
    }
    return all;
}

/// Whether the name of any group of a table of points says that its grains are wet.
bool has_wet_group(const FileView& view) {
    return std::ranges::any_of(groups_of_points(view), [&](const std::string& group) {
        return guessed_mass_ratio(texts_of_group(view, group)) > 0;
    });
}

/// Entry of the steady shear in a recording; empty if there is none.
std::string recording_text(const FileView& view, const FileFormat& format,
                           const std::string& liquid_content) {
    if (!has_steady_recording(view)) return "";
    return fmt::format(
        "[[recording]]                    # intervals of steady shear\nfile = {}\n{}{}{}\n",
        toml_string(as_pattern(file_to_open(view.file.file).filename().string())),
        format_text(format, view), roles_text(view), liquid_content);
}

/// The view that shows the cell best: one whose header states the radii, else one whose columns
/// show them, else one of a recording, whose radii are guessed. Null: no cell is needed.
const FileView* view_with_cell(const std::vector<FileView>& views) {
    const auto first = [&](const auto& has) {
        const auto found = std::ranges::find_if(views, has);
        return found == views.end() ? nullptr : &*found;
    };
    if (const FileView* const stated = first(states_radii)) return stated;
    if (const FileView* const shown =
            first([](const FileView& view) { return view.cell.inner_radius.has_value(); }))
        return shown;
    return first([](const FileView& view) { return view.missing.empty(); });
}

/// Whether a file is a workbook with several sheets to be read, even if some cannot be.
bool has_several_sheets(const FileView& view) {
    return chosen_sheets(file_to_open(view.file.file), "").read.size() > 1;
}

/// Whether other views are sheets of a view's workbook.
bool sheets_of_one_book(const std::vector<FileView>& views, const FileView& view) {
    const auto book = file_to_open(view.file.file);
    return std::ranges::count_if(views, [&](const FileView& each) {
               return file_to_open(each.file.file) == book;
           }) > 1;
}

/// @throws InputError for a name that study.toml cannot hold
void check_name(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    if (printable(name) != name)
        throw InputError({path.string()},
                         "has a name that study.toml cannot hold; rename the file");
}

/// Adds a copy of each file of measurements with steady shear to the files of a study.
/// @throws InputError if another file of the study has its name
void add_recordings(const std::vector<FileView>& views, std::map<std::string, std::string>& files) {
    std::set<std::filesystem::path> added;  // a workbook has several views
    for (const FileView& view : views) {
        const std::filesystem::path path = file_to_open(view.file.file);
        if (!has_steady_recording(view) || !added.insert(path).second) continue;
        if (!files.emplace(path.filename().string(), read_bytes(path, largest_table)).second)
            throw InputError(
                {path.string()},
                "has the name of a file of the study; rename it, to recording.csv say");
    }
}

/// How study.toml states that a sheet or file is to be read.
FileFormat format_of_entry(const FileView& view, FileFormat format, bool one_of_several) {
    const auto sheet = as_sheet(view.file.file);
    if (sheet && (one_of_several || !format.sheet.empty())) format.sheet = sheet->sheet;
    return format;
}

/// Whether a row of a table of points states a liquid content of which this holds.
bool states_any(const FileView& view, bool (*holds)(double)) {
    return std::ranges::any_of(view.file.blocks, [&](const Block& block) {
        return block.liquid_content && holds(*block.liquid_content);
    });
}

/// Whether any file has dry grains, by its rows or else by its names.
bool has_dry(const std::vector<FileView>& views, const std::vector<LiquidGuess>& liquids) {
    for (std::size_t k = 0; k < views.size(); ++k) {
        const bool dry = states_contents(views[k])
                             ? states_any(views[k], [](double content) { return content == 0; })
                             : liquids[k].value == 0;
        if (dry) return true;
    }
    return false;
}

std::string liquid_text(const StatedSample& sample) {
    const auto& tension = sample.surface_tension;
    const auto& angle = sample.contact_angle;
    const double degree = Unit("deg").to_si(1);
    return entry("surface_tension", tension ? Guess{fmt::format("{:g} mN/m", tension->value * 1e3),
                                                    from_line(*tension)}
                                            : Guess{"72.8 mN/m", "GUESS: water"}) +
           entry("contact_angle",
                 angle ? Guess{fmt::format("{:g} deg", angle->value / degree), from_line(*angle)}
                       : Guess{"0 deg", "GUESS: the liquid wets the beads"});
}

std::string grains_text(const FileView& view, bool wet) {
    const StatedSample sample = stated_sample(view.file);
    std::string text = fmt::format(
        "# Begun by pendular import from {}.\n# Check every line marked GUESS: the file does not "
        "state it.\n\n[grains]\n",
        comment_text(file_to_open(view.file.file).filename().string()));
    const auto& diameter = sample.diameter;
    const auto& density = sample.density;
    text += entry("diameter", diameter ? Guess{fmt::format("{:g} um", diameter->value * 1e6),
                                               from_line(*diameter)}
                                       : guessed_diameter(texts_of(view)));
    text += entry("density",
                  density ? Guess{fmt::format("{:g} kg/m^3", density->value), from_line(*density)}
                          : Guess{"2500 kg/m^3", "GUESS: glass"}) +
            "\n";
    if (wet)
        text += "[liquid]\n" + liquid_text(sample) + "\n";
    else
        text +=
            "# [liquid]                       # for wet grains; each [[recording]] then needs\n"
            "# surface_tension = \"72.8 mN/m\"  # liquid_content = 0.01, volume of liquid over\n"
            "# contact_angle = \"0 deg\"        # volume of grains, and 0 where they are dry\n\n";
    return text;
}

std::string end_text(bool cell, bool all_wet) {
    return fmt::format(
               "[instrument]                     # errors that all readings share\n"
               "class = {:<24} # GUESS: typical ones; state your own in place of it\n\n",
               cell ? "\"rheometer\"" : "\"table\"") +
           "[model]\n" +
           (all_wet
                ? "fit_to = \"all\"                   # no dry reading: wet readings are fitted\n"
                : "fit_to = \"dry\"\n");
}

}  // namespace

std::map<std::string, std::string> begin_study(const std::vector<FileView>& views,
                                               const FileFormat& format) {
    for (const FileView& view : views)
        check_name(file_to_open(view.file.file));
    std::vector<LiquidGuess> liquids;
    for (const FileView& view : views)
        liquids.push_back(guessed_liquid(view));
    const bool wet =
        std::ranges::any_of(liquids, [](const auto& each) { return each.value > 0; }) ||
        std::ranges::any_of(views, has_wet_group) ||
        std::ranges::any_of(views, [](const FileView& view) {
            return states_any(view, [](double content) { return content > 0; });
        });
    std::map<std::string, std::string> files;
    std::string entries;
    for (std::size_t k = 0; k < views.size(); ++k) {
        const FileView& view = views[k];
        const std::string suffix = views.size() == 1 ? "" : fmt::format("_{}", k + 1);
        const bool several_sheets =
            sheets_of_one_book(views, view) || (format.sheet.empty() && has_several_sheets(view));
        const std::string content = wet ? liquid_content_text(liquids[k]) : "";
        const std::vector<std::string> groups = groups_of_points(view);
        Tables tables = groups.empty() ? tables_of(view, liquids[k].mass_ratio(), suffix, {},
                                                   comment_on_failure(view, ""), content)
                                       : tables_of_groups(view, groups, suffix, wet);
        entries += recording_text(view, format_of_entry(view, format, several_sheets), content) +
                   tables.entries;
        files.merge(tables.files);
    }
    if (entries.empty()) refuse_to_begin(views.front());
    const FileView* const cell = view_with_cell(views);
    const bool any_steady = std::ranges::any_of(views, has_steady_recording);
    const bool dry = has_dry(views, liquids);
    files["study.toml"] = grains_text(views.front(), wet) +
                          (cell ? cell_text(*cell, any_steady) : "") + entries +
                          end_text(cell != nullptr, !dry);
    add_recordings(views, files);
    return files;
}

}  // namespace pendular
