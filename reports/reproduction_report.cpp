#include "reports/run_report.h"

#include <fmt/format.h>

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
    if (row.values == 1) return fmt::format("differs by {:.1f} standard errors", row.distance);
    return fmt::format("{} of {} values outside; {}", row.outside, row.values, row.where);
}

}  // namespace

std::string verdict_of(const Reproduction& r) {
    return fmt::format(
        "{} of {} numbers and ranges of Badetti et al. (2018) are reproduced, from {} simulated "
        "states of its parameter study: {} simulated at about its stiffness number, {:g}, and {} "
        "converted to this stiffness number with the emulator.",
        r.agreeing(), r.rows().size(), r.study().states().size(), r.study().stiff(),
        paper_stiffness, r.study().states().size() - r.study().stiff());
}

std::vector<std::string> scoreboard_table(const std::vector<ScoreboardRow>& rows, bool all) {
    std::vector<std::string> lines = {
        fmt::format("{:<95} {:<26} {:<22} {}", "what", "published", "simulated", "agrees")};
    for (const ScoreboardRow& row : rows) {
        if (!all && row.agrees) continue;
        lines.push_back(fmt::format("{:<95} {:<26} {:<22} {}", row.what, row.published, row.ours,
                                    row.agrees ? "yes" : "no: " + how_far(row)));
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
    page +=
        "\n## How to repeat it\n\n"
        "`pendular reproduce --out DIR` writes this page and the figures of the paper to DIR. "
        "`pendular reproduce --simulate --fidelity paper` first simulates the states that are "
        "missing, and goes on where it was interrupted.\n";
    return page;
}

Output reproduction_output(const Reproduction& reproduction, bool all) {
    Output output;
    output.answer(verdict_of(reproduction));
    output.table(scoreboard_table(reproduction.rows(), all), 40);
    if (const std::size_t missing = reproduction.study().missing().size(); missing > 0) {
        output.note(
            fmt::format("{} of the {} states of the article have not been simulated; 'pendular "
                        "reproduce --simulate' simulates them.",
                        missing, missing + reproduction.study().states().size()));
    }
    return output;
}

}  // namespace pendular
