#include "reports/reproduction_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace pendular {
namespace {

using dem::Observable;

/// Cell of a table in Markdown, in which a vertical bar would end the cell.
std::string cell(std::string text) {
    std::size_t at = 0;
    while ((at = text.find('|', at)) != std::string::npos) {
        text.replace(at, 1, "\\|");
        at += 2;
    }
    return text;
}

std::string how_far(const ScoreboardRow& row) {
    if (row.agrees) return row.values > 1 ? "" : fmt::format("{:.1f}", row.distance);
    if (row.values == 1) return fmt::format("{:.1f} errors", row.distance);
    return fmt::format("{} of {} outside; {}", row.outside, row.values, row.where);
}

/// Observables of structure that depend on stiffness, with their headings.
struct Column {
    Observable which;
    const char* heading;
    bool per_pressure;  ///< multiplied by P*, from s22 to F0/a^2
};
constexpr Column columns[] = {
    {Observable::contact_coordination, "Z_c", false},
    {Observable::distant_coordination, "Z_d", false},
    {Observable::distant_force, "F_d/F0", false},
    {Observable::fabric_12_contact, "F12c", false},
    {Observable::fabric_12_distant, "F12d", false},
    {Observable::capillary_shear_stress, "a^2 s12cap/F0", true},
    {Observable::stress_ratio, "stress ratio", false},
};

std::string value_of(const PaperState& state, const Column& column) {
    const double factor = column.per_pressure ? state.reduced_pressure() : 1;
    return fmt::format("{:.3f}", factor * state[column.which].value);
}

}  // namespace

std::string verdict_of(const Reproduction& r) {
    return fmt::format(
        "{} of {} numbers and ranges of Badetti et al. (2018) are reproduced, from {} simulated "
        "states of its parameter study at stiffness number {:g} and {} at {:g} or more.",
        r.agreeing(), r.rows().size(), r.study().states().size(), r.study().stiffness_number(),
        r.study().stiff_states().size(), paper_stiffness / 2);
}

std::vector<std::string> scoreboard_table(const std::vector<ScoreboardRow>& rows, bool all) {
    std::vector<std::string> lines = {
        fmt::format("{:<76} {:<24} {:<22} {}", "what", "published", "simulated", "agrees")};
    for (const ScoreboardRow& row : rows) {
        if (!all && row.agrees) continue;
        lines.push_back(fmt::format("{:<76} {:<24} {:<22} {}", row.what, row.published, row.ours,
                                    row.agrees ? "yes" : "no: " + how_far(row)));
    }
    return lines;
}

std::vector<std::string> stiffness_table(const PaperStudy& study) {
    if (study.stiffness_number() >= paper_stiffness / 2 || study.stiff_states().empty()) return {};
    std::string heading = fmt::format("{:>8} {:>8} {:>5}", "friction", "V0/a^3", "P*");
    for (const Column& column : columns) {
        heading += fmt::format(" {:>17}", column.heading);
    }
    std::vector<std::string> lines = {heading};
    for (const PaperState& stiff : study.stiff_states()) {
        const PaperState* soft =
            study.at(stiff.friction(), stiff.bridge_volume(), stiff.reduced_pressure());
        if (soft == nullptr) continue;
        std::string line = fmt::format("{:>8g} {:>8g} {:>5g}", stiff.friction(),
                                       stiff.bridge_volume(), stiff.reduced_pressure());
        for (const Column& column : columns) {
            line += fmt::format(" {:>17}",
                                value_of(stiff, column) + " (" + value_of(*soft, column) + ")");
        }
        lines.push_back(line);
    }
    return lines;
}

std::string reproduction_page(const Reproduction& r) {
    std::string page =
        "# Badetti et al. (2018), reproduced\n\n"
        "This page is written by `pendular reproduce`. It compares each number that Badetti, Fall, "
        "Chevoir and Roux, *Shear strength of wet granular materials: macroscopic cohesion and "
        "effective stress* (2018), states of dry and wet grains with the simulations that come "
        "with the program and those in the user's store. ";
    page +=
        verdict_of(r) +
        " A value agrees where it is within three combined standard errors of the published "
        "value or range. A published number without an error is taken to half a unit of its "
        "last digit, a range to half a unit of the last digit of its more precise end, a number "
        "of one digit with \"about\" to 10 %, and a word such as \"good\" as the row says. "
        "\"Distance\" is in combined standard errors; a row with large errors decides little.\n";
    std::string section;
    for (const ScoreboardRow& row : r.rows()) {
        if (row.section != section) {
            section = row.section;
            page += fmt::format(
                "\n## {}\n\n| what | published | simulated | agrees | distance "
                "|\n|---|---|---|---|---|"
                "\n",
                section);
        }
        page += fmt::format("| {} | {} | {} | {} | {} |\n", cell(row.what), cell(row.published),
                            cell(row.ours), row.agrees ? "yes" : "**no**", cell(how_far(row)));
    }
    if (const auto table = stiffness_table(r.study()); !table.empty()) {
        page +=
            "\n## Stiffness\n\nStructure depends on the stiffness of the grains; the rows under "
            "Structure are of the stiff states, all others of the grid. Each state of this table "
            "was simulated at two stiffness numbers: the first value is that of the larger "
            "one (8400, the paper's), the value in parentheses that of the smaller one (1000).\n\n"
            "```\n";
        for (const std::string& line : table) {
            page += line + "\n";
        }
        page += "```\n";
    }
    page +=
        "\n## How to repeat it\n\n"
        "`pendular reproduce --out DIR` writes this page and the figures of the paper to DIR. "
        "`pendular reproduce --simulate --fidelity paper` first simulates the states that are "
        "missing, and goes on where it was interrupted.\n";
    return page;
}

}  // namespace pendular
