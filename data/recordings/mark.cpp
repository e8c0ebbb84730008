#include "data/recordings/checks.h"

#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Removes readings of which more than 1 in 100 rows are among `lines`.
void set_rows_aside(std::vector<Reading>& readings, const std::set<int>& lines, int averaged_rows,
                    const Remark& words, std::vector<Remark>& marks) {
    std::erase_if(readings, [&](const Reading& reading) {
        const auto spoilt = lines_within(lines, reading.origin.line, reading.last_line);
        const auto rows =
            static_cast<std::size_t>((reading.last_line - reading.origin.line) / averaged_rows + 1);
        if (100 * spoilt <= rows) return false;
        Remark& mark = marks.emplace_back(reading.remark(words.kind));
        mark.quantity = words.quantity;
        mark.count = spoilt;
        mark.of = rows;
        mark.limit = words.size;
        return true;
    });
}

/// Removes all readings if a column is doubtful throughout.
void set_all_aside(std::vector<Reading>& readings, const Remark& doubt,
                   std::vector<Remark>& marks) {
    for (const Reading& reading : readings) {
        marks.push_back(reading.remark(Kind::reading_of_wrong_column));
        marks.back().because = {doubt};
    }
    readings.clear();
}

}  // namespace

std::vector<Remark> set_spoilt_aside(std::vector<Reading>& readings,
                                     const std::vector<Remark>& faults, int averaged_rows) {
    std::vector<Remark> marks;
    std::set<int> contradicting;
    for (const Remark& fault : faults) {
        if (fault.outcome != Remark::Outcome::set_aside) continue;
        if (fault.kind == Kind::wrong_factor) set_all_aside(readings, fault, marks);
        if (fault.kind == Kind::contradicting_rows)
            contradicting.merge(all_lines(fault.because.front().lines));
    }
    set_rows_aside(readings, contradicting, averaged_rows, {.kind = Kind::contradicted_reading},
                   marks);
    for (const Remark& fault : faults)
        if (fault.kind == Kind::saturation && fault.corrected)
            set_rows_aside(
                readings, all_lines(fault.lines), averaged_rows,
                {.kind = Kind::saturated_reading, .quantity = fault.quantity, .size = fault.size},
                marks);
    for (const Remark& fault : faults)
        if (fault.kind == Kind::constant_torque && fault.outcome == Remark::Outcome::set_aside)
            set_all_aside(readings, fault, marks);
    return decide(std::move(marks), false);
}

void set_named_aside(std::vector<Reading>& readings, const std::vector<Remark>& remarks) {
    std::set<std::tuple<std::string, int, int>> named;
    for (const Remark& remark : remarks)
        if (remark.outcome == Remark::Outcome::left_out &&
            (remark.kind == Kind::impossible_reading || remark.kind == Kind::repeated_reading))
            named.emplace(remark.file(), remark.first_line(), remark.step);
    std::erase_if(readings, [&](const Reading& reading) {
        return named.contains({reading.origin.file, reading.origin.line, reading.step});
    });
}

}  // namespace pendular
