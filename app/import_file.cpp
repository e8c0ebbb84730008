#include "app/import_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "app/command.h"
#include "data/files/file_access.h"
#include "data/files/formats/layouts.h"
#include "data/files/text_pattern.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/recordings/file_view.h"
#include "data/recordings/locus_table.h"
#include "data/remarks/wording.h"
#include "data/study/study.h"
#include "reports/file_report.h"
#include "reports/locus_figures.h"
#include "reports/locus_report.h"
#include "reports/recording_figures.h"
#include "workflow/begin_study.h"
#include "workflow/begun_tables.h"
#include "workflow/file_views.h"
#include "workflow/json/measurements.h"
#include "workflow/study_input.h"
#include "workflow/tidy_table.h"

namespace pendular::app {
namespace {

/// Checks a word that the user gave for an option.
/// @throws InputError if it is not one of `words`
void check_choice(const char* option, const std::string& word,
                  const std::vector<std::string>& words) {
    if (word.empty() || std::ranges::find(words, word) != words.end()) return;
    throw InputError(
        fmt::format("--{}: unknown \"{}\"; {}", option, word, did_you_mean(word, words)));
}

/// Columns of a text as in study.toml: { torque = "Md [mN m]", time = "Zeit" }.
/// @throws InputError for a text of another form, and for a name of no quantity
std::map<std::string, std::string> named_columns(const std::string& text) {
    static const TextPattern pair(R"re(([A-Za-z_]+)\s*=\s*"([^"]*)")re");
    std::map<std::string, std::string> columns;
    for (const PatternMatch& each : pair.all(text.substr(text.find('{')))) {
        const std::string& key = each.parts[1];
        const Quantity* const known = find_quantity(key);
        if (!known) throw InputError(fmt::format("--columns: '{}' is no quantity", key));
        columns[std::string(known->name)] = each.parts[2];
    }
    if (columns.empty()) throw InputError("--columns: write it as in { torque = \"Md [mN m]\" }");
    return columns;
}

FileFormat format_of(const ImportFileOptions& options) {
    check_choice("layout", options.layout, layout_names());
    check_choice("decimal", options.decimal, {".", ","});
    FileFormat format;
    format.layout = options.layout;
    format.encoding = options.encoding;
    format.decimal = options.decimal;
    format.sheet = options.sheet;
    format.prorate = options.prorate;
    format.wall = options.wall;
    if (options.columns.find('{') != std::string::npos) {
        format.named_columns = named_columns(options.columns);
        return format;
    }
    // As messages and study.toml have it: columns = ["Time [s]", "Torque [mN m]"].
    const std::size_t list = options.columns.find("[\"");
    const auto array =
        list == std::string::npos
            ? nlohmann::ordered_json()
            : nlohmann::ordered_json::parse(options.columns.substr(list), nullptr, false);
    if (array.is_array()) {
        for (const auto& column : array)
            format.columns.push_back(column.is_string() ? column.get<std::string>() : "");
        return format;
    }
    for (std::string_view rest = options.columns; !rest.empty();) {
        const std::size_t end = std::min(rest.find(';'), rest.size());
        format.columns.emplace_back(trimmed(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return format;
}

/// Number of times that a text contains a word.
std::size_t count_of(const std::string& text, std::string_view word) {
    std::size_t count = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

/// Files of a new study, by file name.
/// @throws InputError if the folder has a file of one of their names
std::map<std::string, std::string> files_of_study(const std::filesystem::path& folder,
                                                  const std::vector<FileView>& views,
                                                  const FileFormat& format) {
    const auto files = begin_study(views, format);
    for (const auto& [name, content] : files)
        if (std::filesystem::exists(folder / name))
            throw InputError({(folder / name).string()},
                             "is there already; nothing was written: name another folder in "
                             "--study");
    return files;
}

/// JSON of a file; of several sheets, that of the first with the others in "further_sheets".
nlohmann::ordered_json json_of(const std::vector<FileView>& views) {
    auto json = to_json(views.front());
    for (std::size_t k = 1; k < views.size(); ++k)
        json["further_sheets"].push_back(to_json(views[k]));
    return json;
}

std::vector<Figure> figures_of(const std::vector<FileView>& views) {
    std::vector<Figure> figures;
    for (const FileView& view : views)
        for (Figure& figure : file_figures(view)) {
            figure.name = unused_name(figure.name, figures);
            figures.push_back(std::move(figure));
        }
    if (auto flow = flow_function_figure(views)) figures.push_back(std::move(*flow));
    return figures;
}

}  // namespace

void ImportFileOptions::declare(Options& options) {
    options.begin_section("Options for a single file");
    options.add(
        "study", &study,
        "folder for a new study with these files, or with all of a folder; guessed values in its "
        "study.toml are marked GUESS",
        a_folder());
    options.add("figures", &figures,
                "folder for figures: the recording with the rows that are averaged, and yield "
                "loci; for a study: all its recordings",
                a_folder());
    options.add("tidy", &tidy, "CSV file for all rows in SI units, with header and unit rows",
                a_file());
    options.add("loci", &loci,
                "CSV file for the results of yield loci and wall yield loci, with standard errors",
                a_file());
    options.add_switch("prorate", &prorate,
                       "multiply shear stresses at failure by the mean shear stress of the "
                       "preshears over that of their own");
    options.add_switch("wall", &wall, "the file holds grains sheared along a wall");
    options.add("layout", &layout, "layout of the file (default: recognised by its content)",
                one_of(layout_names()));
    options.add("encoding", &encoding, "character encoding of the file (default: detected)");
    options.add(
        "sheet", &sheet,
        "sheet of a workbook (.xlsx, .xls), or a pattern such as '* kPa' (default: every sheet "
        "with a table)");
    options.add("decimal", &decimal, "decimal mark of the file, '.' or ',' (default: detected)");
    options.add(
        "columns", &columns,
        "names and units of all columns where the file has none: 'Time [s]; Torque [mN m]', or of "
        "single ones, as in study.toml: '{ torque = \"Md [mN m]\" }'");
}

void ImportFileOptions::refuse_for_studies(const Options& options) const {
    for (const char* const name : {"study", "tidy", "loci", "prorate", "wall", "layout", "encoding",
                                   "sheet", "decimal", "columns"})
        if (options.given(name))
            throw InputError(
                fmt::format("--{} belongs to a single file; for a study, write it in "
                            "[[recording]] of study.toml",
                            name));
}

bool is_folder_of_files(const std::filesystem::path& path) {
    std::error_code error;  // set where the path cannot be looked at, which reading it tells of
    return std::filesystem::is_directory(path, error) &&
           !std::filesystem::exists(path / "study.toml", error);
}

bool is_bare_file(const std::filesystem::path& path) {
    std::error_code error;  // set for a link to itself, which reading the study tells of
    return std::filesystem::is_regular_file(path, error) && path.extension() != ".toml";
}

namespace {

/// Whether two paths name one file, which need not exist yet.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;  // set where one of them does not exist
    if (std::filesystem::equivalent(a, b, error)) return true;
    return std::filesystem::weakly_canonical(a, error) ==
           std::filesystem::weakly_canonical(b, error);
}

/// Files of a folder, in the order of their names.
/// @throws InputError if it has none
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths = matching_files(folder, "*");
    std::erase_if(paths, [](const std::filesystem::path& each) {
        return !is_bare_file(each) || each.filename().string().starts_with('.');
    });
    if (paths.empty())
        throw InputError({folder.string()}, "has no file of measurements to begin a study with");
    return paths;
}

/// Files that the user named, or all of a folder.
/// @throws InputError for an argument that is none, and for a file that is named twice
std::vector<std::filesystem::path> all_files(const std::filesystem::path& first,
                                             const std::vector<std::string>& more) {
    std::vector<std::filesystem::path> paths = {first};
    if (!is_bare_file(first)) paths = files_in(first);
    for (const std::string& path : more) {
        if (!is_bare_file(path))
            throw InputError({path},
                             "is no file of measurements; each of several arguments must "
                             "be one");
        if (std::ranges::any_of(paths, [&](const auto& each) { return same_file(each, path); }))
            throw InputError({path}, "is named twice; name each file once");
        paths.emplace_back(path);
    }
    return paths;
}

/// @throws InputError if a table that the user wants cannot be written, or is an input or named
/// twice
void check_tables(const ImportFileOptions& options,
                  const std::vector<std::filesystem::path>& inputs) {
    for (const std::string& table : {options.tidy, options.loci})
        for (const std::filesystem::path& input : inputs)
            if (!table.empty() && same_file(table, input))
                throw InputError({table}, "is the file to be read; name another one");
    if (!options.tidy.empty() && !options.loci.empty() && same_file(options.tidy, options.loci))
        throw InputError({options.loci},
                         "is named by --tidy and by --loci; name a file for each table");
    if (!options.tidy.empty()) {
        demand_writable(options.tidy, "--tidy", false);
        demand_table(options.tidy, tidy_table_begin);
    }
    if (options.loci.empty()) return;
    demand_writable(options.loci, "--loci", false);
    demand_table(options.loci, locus_table_begin);
}

/// Options, as the user gave them, on how files are to be read.
std::string reading_options(const ImportFileOptions& options) {
    std::string text;
    for (const auto& [name, value] :
         {std::pair("layout", options.layout), std::pair("encoding", options.encoding),
          std::pair("sheet", options.sheet), std::pair("decimal", options.decimal),
          std::pair("columns", options.columns)})
        if (!value.empty()) text += fmt::format(" --{} {}", name, shell_word(value));
    if (options.prorate) text += " --prorate";
    if (options.wall) text += " --wall";
    return text;
}

/// The command to give next; empty for none.
std::string next_command(const std::vector<std::filesystem::path>& paths,
                         const std::vector<FileView>& views, const ImportFileOptions& options,
                         std::size_t guesses) {
    const std::string study = shell_word(options.study);
    if (!options.study.empty() && guesses > 0)
        return fmt::format("edit {}, then pendular import {}",
                           shell_word(std::filesystem::path(options.study) / "study.toml"), study);
    if (!options.study.empty()) return "pendular import " + study;
    if (std::ranges::none_of(views, begins_study)) return "";
    std::string command = "pendular import";
    for (const std::filesystem::path& path : paths)
        command += " " + shell_word(path);
    return command + reading_options(options) + " --study my-study";
}

/// Prints one line for each file or sheet, and its faults.
void print_in_short(const std::vector<FileView>& views, Console& console) {
    for (const FileView& view : views) {
        console.line(file_sentence(view));
        for (const Remark& finding : view.findings)
            console.line("  " + with_lines(finding));
    }
    console.note("Columns and intervals of each file: option --all, or pendular import FILE.");
}

/// Prints what the files hold. Returns whether anything of it is used.
bool print_views(const SheetViews& read, Console& console) {
    constexpr std::size_t most = 4;  // with about 15 lines each; chosen
    const std::string unused = unused_sentence(read.views);
    if (!unused.empty()) console.answer(unused);
    if (unused.empty() && !console.all() && read.views.size() > most)
        print_in_short(read.views, console);
    else
        for (const FileView& view : read.views)
            console.print(file_output(view, console.all(), unused.empty()));
    if (const auto flow = flow_function_table(read.views); !flow.empty()) {
        console.line(flow.front());
        console.table({flow.begin() + 1, flow.end()}, 10);
    }
    for (const std::string& sentence : read.not_read)
        console.note(sentence);
    return unused.empty();
}

}  // namespace

int import_file(const std::filesystem::path& path, const ImportFileOptions& options,
                Console& console) {
    const FileFormat format = format_of(options);
    const auto paths = all_files(path, options.more);
    const auto read_all = options.study.empty() ? views_of_files
                          : is_bare_file(path)  ? views_of_named_files
                                                : views_to_begin_with;
    const SheetViews read = read_all(paths, format);
    const std::vector<FileView>& views = read.views;
    check_tables(options, paths);
    std::size_t guesses = 0;
    if (!options.study.empty()) {
        const auto files = files_of_study(options.study, views, format);
        guesses = count_of(files.at("study.toml"), "# GUESS:");
        write_whole_folder(options.study, files);
    }
    if (!options.tidy.empty()) write_whole(options.tidy, tidy_table(views));
    if (!options.loci.empty()) write_whole(options.loci, locus_table(views));
    const bool used = print_views(read, console);
    const auto toml = std::filesystem::path(options.study) / "study.toml";
    if (!options.study.empty())
        for (const FileView& view : views)
            if (const auto groups = groups_of_points(view); !groups.empty())
                console.line(groups_sentence(view, groups, toml));
    if (guesses > 0) console.line(guesses_sentence(guesses, toml));
    if (const std::string next = next_command(paths, views, options, guesses); !next.empty())
        console.next(next);
    console.json(json_of(views));
    if (!options.figures.empty()) console.figures(options.figures, figures_of(views));
    return used ? done : wrong_input;
}

}  // namespace pendular::app
