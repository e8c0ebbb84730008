#include "data/remarks/remark.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

namespace pendular {
namespace {

using Kind = Remark::Kind;
using Outcome = Remark::Outcome;

/// Consequence of a kind of remark, in an ordinary study and in one that keeps implausible
/// readings, where an empty outcome means that nothing is said.
struct Rule {
    Kind kind;
    Outcome outcome;
    std::optional<Outcome> if_kept;
    const char* name = "";  ///< in JSON
};

constexpr Rule found(Kind kind, const char* name) {
    return {kind, Outcome::found, Outcome::found, name};
}

// Of a reading with many saturated rows, `set_spoilt_aside` (recordings/measurements.cpp) says
// more.
constexpr std::array rules = {found(Kind::saturation, "saturation"),
                              found(Kind::level_change, "level-change"),
                              found(Kind::wobble, "wobble"),
                              found(Kind::stick_slip, "stick-slip"),
                              found(Kind::drift, "drift"),
                              found(Kind::unfinished_run_in, "unfinished-run-in"),
                              found(Kind::swapped_columns, "swapped-columns"),
                              found(Kind::declared_rows, "declared-rows"),
                              found(Kind::time_goes_back, "time"),
                              found(Kind::no_compression, "no-compression"),
                              found(Kind::repeated_rows, "repeated-rows"),
                              found(Kind::several_tests, "several-tests"),
                              found(Kind::header_constant, "header-constant"),
                              found(Kind::header_cell, "header-cell"),
                              found(Kind::missed_set_point, "set-point"),
                              found(Kind::missing_values, "missing-values"),
                              found(Kind::hidden_rows, "hidden-rows"),
                              found(Kind::filled_down, "filled-down"),
                              found(Kind::far_values, "far-values"),
                              found(Kind::impossible_points, "impossible-points"),
                              found(Kind::returning_load, "returning-load"),
                              found(Kind::falling_line, "falling-line"),
                              found(Kind::cycles_in_one_interval, "cycles-in-one-interval"),
                              Rule{Kind::repaired_torques, Outcome::kept, Outcome::kept},
                              Rule{Kind::restated_copy, Outcome::set_aside, Outcome::set_aside},
                              Rule{Kind::wrong_factor, Outcome::set_aside, Outcome::kept},
                              Rule{Kind::contradicting_rows, Outcome::set_aside, Outcome::kept},
                              Rule{Kind::constant_torque, Outcome::set_aside, Outcome::kept},
                              Rule{Kind::constant_gap, Outcome::kept, Outcome::kept},
                              Rule{Kind::impossible_filling, Outcome::set_aside, std::nullopt},
                              Rule{Kind::impossible_value, Outcome::set_aside, Outcome::kept},
                              Rule{Kind::saturated_column, Outcome::set_aside, Outcome::kept},
                              Rule{Kind::other_speed_unit, Outcome::kept, Outcome::kept},
                              Rule{Kind::far_files, Outcome::kept, Outcome::kept},
                              Rule{Kind::far_condition, Outcome::kept, Outcome::kept},
                              Rule{Kind::creeping_gap, Outcome::kept, Outcome::kept},
                              Rule{Kind::uneven_shear, Outcome::kept, Outcome::kept},
                              Rule{Kind::contradicting_row, Outcome::left_out, std::nullopt},
                              Rule{Kind::impossible_reading, Outcome::left_out, std::nullopt}};

/// Whether each kind of doubt has a rule: without one, its readings would be left out silently.
constexpr bool all_doubts_have_rules() {
    for (Kind kind = Kind::repaired_torques; kind <= Kind::uneven_shear;
         kind = static_cast<Kind>(static_cast<int>(kind) + 1))
        if (std::ranges::find(rules, kind, &Rule::kind) == rules.end()) return false;
    return true;
}
static_assert(all_doubts_have_rules());

Rule rule_of(Kind kind) {
    const auto rule = std::ranges::find(rules, kind, &Rule::kind);
    if (rule != rules.end()) return *rule;
    const Outcome other = kind < Kind::repaired_torques ? Outcome::found
                          : kind < Kind::averaged_rows  ? Outcome::left_out
                                                        : Outcome::note;
    return {kind, other, other};
}

}  // namespace

void Remark::add(const Position& at) {
    if (files.empty() || files.back() != at.file) files.push_back(at.file);
    lines.push_back({at.line, at.line, files.size() - 1});
}

std::string to_string(const Remark& remark) {
    if (remark.kind == Kind::ratio_of_columns)
        return remark.quantity == "torque" ? "torque-shear_stress" : "normal_force-normal_stress";
    return rule_of(remark.kind).name;
}

std::vector<Remark> decide(std::vector<Remark> remarks, bool keep_implausible) {
    std::erase_if(remarks, [&](Remark& remark) {
        if (remark.outcome != Outcome::undecided) return false;
        const Rule rule = rule_of(remark.kind);
        const auto outcome = keep_implausible ? rule.if_kept : rule.outcome;
        remark.outcome = outcome.value_or(Outcome::found);
        // A saturation is told in any study; `corrected` says whether its readings are removed.
        if (remark.kind == Kind::saturation) remark.corrected = !keep_implausible;
        return !outcome;
    });
    return remarks;
}

void append(std::vector<Remark>& to, std::vector<Remark> more) {
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void add_line(std::vector<Lines>& lines, int line) {
    if (!lines.empty() && lines.back().last + 1 == line)
        lines.back().last = line;
    else
        lines.push_back({line, line});
}

std::set<int> all_lines(const std::vector<Lines>& ranges) {
    std::set<int> lines;
    for (const auto& [first, last, file] : ranges)
        for (int line = first; line <= last; ++line)
            lines.insert(lines.end(), line);
    return lines;
}

std::size_t lines_within(const std::set<int>& lines, int first, int last) {
    return static_cast<std::size_t>(
        std::distance(lines.lower_bound(first), lines.upper_bound(last)));
}

}  // namespace pendular
