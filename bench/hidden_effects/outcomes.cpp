#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <iterator>
#include <sstream>

#include "bench/hidden_effects/walk.h"
#include "data/files/csv.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular::bench {
namespace {

constexpr std::array outcome_columns = {"truth",
                                        "study",
                                        "verdict",
                                        "complete",
                                        "named",
                                        "suspects",
                                        "faults",
                                        "confidence_set",
                                        "set_size",
                                        "set_has_truth",
                                        "chi2",
                                        "dof",
                                        "foretold_drop",
                                        "refitted_drop",
                                        "p_after",
                                        "shear_stress_rms_before",
                                        "solid_fraction_rms_before",
                                        "shear_stress_rms_after",
                                        "solid_fraction_rms_after",
                                        "shear_stress_scatter",
                                        "solid_fraction_scatter",
                                        "shear_stress_noise",
                                        "solid_fraction_noise",
                                        "shear_stress_left_out_before",
                                        "solid_fraction_left_out_before",
                                        "shear_stress_left_out_after",
                                        "solid_fraction_left_out_after",
                                        "friction_pull",
                                        "seconds"};

std::string text_of(std::optional<double> value) {
    return value ? fmt::format("{:.4g}", *value) : "";
}

/// Cells of a row in turn.
class Cells {
  public:
    Cells(const Table& table, const Row& row) : table_(table), row_(row) {}
    const std::string& text() { return row_.cells.at(next_++).text; }
    std::optional<double> number() {
        const std::size_t at = next_++;
        const std::string& text = row_.cells.at(at).text;
        const auto value = parse_number(text);
        if (!text.empty() && !value) {
            throw InputError(table_.at(row_, at), fmt::format("'{}' is no number", text));
        }
        return value;
    }
    std::array<double, 2> two() {
        const double first = number().value_or(0);
        return {first, number().value_or(0)};
    }
    std::vector<std::string> words() {
        std::istringstream words(text());
        return {std::istream_iterator<std::string>(words), {}};
    }

  private:
    const Table& table_;
    const Row& row_;
    std::size_t next_ = 0;
};

std::vector<std::string> cells_of(const Outcome& o) {
    std::vector<std::string> cells = {o.truth,
                                      std::to_string(o.study),
                                      o.verdict,
                                      o.complete ? "1" : "0",
                                      fmt::format("{}", fmt::join(o.named, " ")),
                                      fmt::format("{}", fmt::join(o.suspects, "; ")),
                                      fmt::format("{}", fmt::join(o.faults, " ")),
                                      o.confidence_set,
                                      std::to_string(o.set_size),
                                      o.set_has_truth ? "1" : "0",
                                      text_of(o.chi2),
                                      std::to_string(o.dof),
                                      text_of(o.predicted_reduction),
                                      text_of(o.refitted_reduction)};
    if (o.added) {
        const auto& a = *o.added;
        cells.push_back(text_of(a.p));
        for (const auto& two :
             {a.rms_before, a.rms_after, a.scatter, a.noise, a.left_out_before, a.left_out_after}) {
            cells.push_back(text_of(two[0]));
            cells.push_back(text_of(two[1]));
        }
    } else {
        cells.resize(outcome_columns.size() - 2);
    }
    cells.push_back(text_of(o.pull));
    cells.push_back(text_of(o.seconds));
    return cells;
}

}  // namespace

std::vector<Outcome> read_outcomes(const std::filesystem::path& file) {
    std::vector<Outcome> outcomes;
    if (!std::filesystem::exists(file)) return outcomes;
    const Table table = read_table(file);
    for (const Row& row : table.rows) {
        Cells cells(table, row);
        Outcome o;
        o.truth = cells.text();
        o.study = static_cast<int>(cells.number().value_or(0));
        o.verdict = cells.text();
        o.complete = cells.number() == 1;
        o.named = cells.words();
        if (const std::string& suspects = cells.text(); !suspects.empty()) o.suspects = {suspects};
        o.faults = cells.words();
        o.confidence_set = cells.text();
        o.set_size = static_cast<std::size_t>(cells.number().value_or(0));
        o.set_has_truth = cells.number() == 1;
        o.chi2 = cells.number().value_or(0);
        o.dof = static_cast<int>(cells.number().value_or(0));
        o.predicted_reduction = cells.number();
        o.refitted_reduction = cells.number();
        const auto p = cells.number();
        Outcome::Added a{.p = p.value_or(0)};
        for (auto* two : {&a.rms_before, &a.rms_after, &a.scatter, &a.noise, &a.left_out_before,
                          &a.left_out_after}) {
            *two = cells.two();
        }
        if (p) o.added = a;
        o.pull = cells.number();
        o.seconds = cells.number().value_or(0);
        outcomes.push_back(std::move(o));
    }
    return outcomes;
}

void write_outcomes(const std::filesystem::path& file, const std::vector<Outcome>& outcomes) {
    std::string text = fmt::format("{}\n", fmt::join(outcome_columns, ","));
    for (const Outcome& outcome : outcomes) {
        std::vector<std::string> cells;
        for (const std::string& cell : cells_of(outcome)) {
            cells.push_back(csv_cell(cell));
        }
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    write_whole(file, text);
}

}  // namespace pendular::bench
