#include "workflow/begin_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>

#include "data/files/file_bytes.h"
#include "data/quantities/number.h"
#include "data/study/files.h"

namespace pendular {
namespace {

/// A value for study.toml with a comment on where it is from.
struct Guess {
    std::string value, from;
};

/// Texts of a file that may say what was measured, the most specific first: names of tests and
/// samples, the file's name, the project's name.
std::string texts_of(const FileView& view) {
    std::string text;
    for (const Block& block : view.file.blocks)
        if (text.empty()) text = block.test;
    for (const std::string key : {"Sample name", "Name"})
        text += " | " + view.file.fact(key);
    text += " | " + std::filesystem::path(view.file.file).stem().string();
    for (const std::string key : {"Project", "Projet", "Projekt"})
        text += " | " + view.file.fact(key);
    return text;
}

Guess guessed_diameter(const std::string& texts) {
    static const std::regex length(R"((\d+(?:[.,]\d+)?)\s*(mm|um|µm|μm)\b)");
    std::smatch found;
    if (!std::regex_search(texts, found, length))
        return {"500 um", "GUESS: the file does not state the diameter"};
    std::string number = found[1];
    std::ranges::replace(number, ',', '.');
    return {fmt::format("{} {}", number, std::string(found[2])),
            fmt::format("GUESS: from \"{}\" in the names of file and test", std::string(found[0]))};
}

/// Mass of liquid over mass of grains that the names of file and test state, in per cent.
std::optional<double> stated_percent(const std::string& texts) {
    static const std::regex percent(R"((\d+(?:[.,p]\d+)?)\s*(?:%|pct))");
    static const std::regex water(R"(_w(\d+)_)");
    std::smatch found;
    if (!std::regex_search(texts, found, percent) && !std::regex_search(texts, found, water))
        return std::nullopt;
    std::string number = found[1];
    std::ranges::replace(number, ',', '.');
    std::ranges::replace(number, 'p', '.');
    return parse_number(number);
}

bool named_wet(const std::string& texts) {
    return texts.find("wet") != std::string::npos || texts.find("_w") != std::string::npos ||
           texts.find("water") != std::string::npos;
}

constexpr double glass_density = 2500, water_density = 1000;

/// Liquid content by volume [1] that the names of file and test suggest; empty for dry grains.
std::optional<double> guessed_liquid(const std::string& texts) {
    if (!named_wet(texts)) return std::nullopt;
    return stated_percent(texts).value_or(1) / 100 * glass_density / water_density;
}

/// Text as a string of TOML, whose escapes are those of JSON.
std::string toml_string(const std::string& text) {
    return nlohmann::json(text).dump();
}

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

std::string cell_text(const FileView& view) {
    std::string text = "[cell]\n";
    if (view.cell.inner_radius) {
        const char* const from = "from the ratios of the file's own stresses to torque or force";
        text +=
            entry("inner_radius", {fmt::format("{:g} mm", *view.cell.inner_radius * 1e3), from});
        text +=
            entry("outer_radius", {fmt::format("{:g} mm", *view.cell.outer_radius * 1e3), from});
    } else {
        const char* const from = "GUESS: a common powder cell; the file does not show the radii";
        text += entry("inner_radius", {"10.5 mm", from});
        text += entry("outer_radius", {"21.5 mm", from});
    }
    return text + entry("bead_mass", {"20 g", "GUESS: weigh the beads"}) + "\n";
}

bool has_role(const FileView& view, const char* role) {
    return std::ranges::any_of(view.roles,
                               [&](const IntervalRole& each) { return each.role == role; });
}

constexpr const char* points_header =
    "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction [1],"
    "solid_fraction_sd [1],inertial_number [1],line [1]\n";

std::string point_row(double normal, double shear, double deviation, int line) {
    // At least 1 %: a peak without noise is no exact reading.
    return fmt::format("{:.6g},{:.6g},{:.3g},0.60,0.1,0,{}\n", normal, shear,
                       std::max(deviation, 0.01 * shear), line);
}

std::string failure_table(const FileView& view) {
    std::string text = points_header;
    for (const YieldLocus& locus : view.loci)
        for (const FailurePoint& point : locus.points)
            text += point_row(point.smoothed_normal_stress, point.smoothed_shear_stress,
                              point.shear_stress - point.smoothed_shear_stress, point.line);
    return text;
}

std::string steady_table(const FileView& view) {
    std::string text = points_header;
    for (std::size_t i = 0; i < view.series.size(); ++i) {
        const IntervalSeries& series = view.series[i];
        if (view.roles[i].role != "preshear" || series.shear_stress.empty() ||
            series.normal_stress.empty())
            continue;
        const PreshearPoint point = preshear_point(series);
        text += point_row(point.normal_stress, point.shear_stress, point.shear_stress_deviation,
                          series.line.back());
    }
    return text;
}

/// Lines of an entry on how the file is to be read, as the user stated it.
std::string format_text(const FileFormat& format) {
    std::string text;
    for (const auto& [key, value] :
         {std::pair{"layout", format.layout}, std::pair{"encoding", format.encoding},
          std::pair{"decimal", format.decimal}})
        if (!value.empty()) text += fmt::format("{} = {}\n", key, toml_string(value));
    std::vector<std::string> columns;
    for (const std::string& column : format.columns)
        columns.push_back(toml_string(column));
    if (!columns.empty()) text += fmt::format("columns = [{}]\n", fmt::join(columns, ", "));
    return text;
}

std::string entries_text(const FileView& view, const FileFormat& format,
                         const std::string& liquid_content) {
    std::string text;
    if (has_role(view, "steady") && view.missing.empty())
        text += fmt::format(
            "[[recording]]                    # intervals of steady shear\nfile = {}\n{}{}\n",
            toml_string(as_pattern(std::filesystem::path(view.file.file).filename().string())),
            format_text(format), liquid_content);
    if (has_role(view, "preshear"))
        text += fmt::format(
            "[[readings]]                     # ends of the preshears, in steady "
            "shear\nfile = \"steady.csv\"\n{}\n",
            liquid_content);
    if (!view.loci.empty())
        text += fmt::format(
            "[[readings]]                     # points of failure: peaks, which may lie above "
            "steady shear\nfile = \"failure.csv\"\n{}\n",
            liquid_content);
    return text;
}

}  // namespace

std::map<std::string, std::string> begin_study(const FileView& view, const FileFormat& format) {
    const std::string texts = texts_of(view);
    const std::optional<double> liquid = guessed_liquid(texts);
    std::string text = fmt::format(
        "# Begun by pendular import from {}.\n# Check every line marked GUESS: the file does not "
        "state it.\n\n[grains]\n",
        comment_text(std::filesystem::path(view.file.file).filename().string()));
    text += entry("diameter", guessed_diameter(texts));
    text += entry("density", {"2500 kg/m^3", "GUESS: glass"}) + "\n";
    std::string content;
    if (liquid) {
        text += "[liquid]\n" + entry("surface_tension", {"72.8 mN/m", "GUESS: water"}) +
                entry("contact_angle", {"0 deg", "GUESS: the liquid wets the beads"}) + "\n";
        content = fmt::format(
            "liquid_content = {:<15g} # GUESS: volume of water over volume of "
            "glass, from the names of file and test\n",
            *liquid);
    }
    if (view.missing.empty() || view.cell.inner_radius) text += cell_text(view);
    text += entries_text(view, format, content);
    text += "[model]\n";
    text += liquid
                ? "fit_to = \"all\"                   # no dry reading: wet readings are fitted\n"
                : "fit_to = \"dry\"\n";
    std::map<std::string, std::string> files = {{"study.toml", text}};
    if (has_role(view, "steady") && view.missing.empty())
        files.emplace(std::filesystem::path(view.file.file).filename().string(),
                      read_bytes(view.file.file, largest_table));
    if (!view.loci.empty()) files["failure.csv"] = failure_table(view);
    if (has_role(view, "preshear")) files["steady.csv"] = steady_table(view);
    return files;
}

}  // namespace pendular
