#include "data/files/formats/clock_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <regex>

#include "data/quantities/number.h"

namespace pendular {
namespace {

constexpr double day = 86'400;  // [s]

/// Day since 1970 of three numbers; empty for days that do not exist.
std::optional<double> day_number(int year, int month, int day_of_month) {
    const std::chrono::year_month_day date(std::chrono::year(year),
                                           std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day_of_month)));
    if (!date.ok()) return std::nullopt;
    return static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

/// Clock of the times of a file, in their order.
class Clock {
  public:
    /// Seconds since the first time.
    double since_first(const ClockTime& time) {
        if (first_ && !time.dated && time.seconds < before_ - day / 2) midnights_ += day;
        before_ = time.seconds;
        const double seconds = time.seconds + midnights_;
        if (!first_) first_ = seconds;
        return seconds - *first_;
    }

  private:
    std::optional<double> first_;
    double before_ = 0, midnights_ = 0;
};

/// Index of the column of times if all its cells with a text are clock times.
std::optional<std::size_t> column_of_clock_times(const Block& block) {
    const auto column = std::ranges::find(block.columns, "time", &BlockColumn::quantity);
    if (column == block.columns.end()) return std::nullopt;
    const auto index = static_cast<std::size_t>(column - block.columns.begin());
    bool any = false;
    for (const Row& row : block.table.rows) {
        const std::string& text = row.cells[index].text;
        if (text.empty()) continue;
        if (!clock_time(text)) return std::nullopt;
        any = true;
    }
    return any ? std::optional(index) : std::nullopt;
}

}  // namespace

std::optional<ClockTime> clock_time(std::string_view text) {
    if (text.size() > 40 || text.find(':') == std::string_view::npos) return std::nullopt;
    static const std::regex form(
        R"((?:(?:(\d{4})-(\d\d?)-(\d\d?)|(\d\d?)\.(\d\d?)\.(\d{4})|[\d/]{6,10})[T ]+)?)"
        R"((\d{1,6}):([0-5]\d):([0-5]\d(?:[.,]\d+)?)\s*([AaPp][Mm])?Z?)");
    std::match_results<std::string_view::const_iterator> part;
    if (!std::regex_match(text.begin(), text.end(), part, form)) return std::nullopt;
    const auto number = [&](std::size_t i) { return std::stoi(part[i].str()); };
    std::string seconds = part[9].str();
    for (char& c : seconds)
        if (c == ',') c = '.';
    int hours = number(7);
    if (part[10].matched) {
        if (hours < 1 || hours > 12) return std::nullopt;
        const char half = *part[10].first;
        hours = hours % 12 + (half == 'p' || half == 'P' ? 12 : 0);
    }
    ClockTime time{3600.0 * hours + 60 * number(8) + parse_number(seconds).value_or(0), false};
    std::optional<double> date;
    if (part[1].matched) date = day_number(number(1), number(2), number(3));
    if (part[4].matched) date = day_number(number(6), number(5), number(4));
    if ((part[1].matched || part[4].matched) && !date) return std::nullopt;
    if (date) time = {time.seconds + day * *date, true};
    return time;
}

void read_clock_times(BlockFile& file) {
    Clock clock;
    for (Block& block : file.blocks) {
        const auto index = column_of_clock_times(block);
        if (!index) continue;
        for (Row& row : block.table.rows) {
            std::string& text = row.cells[*index].text;
            // Microseconds, as fine as a number of days can be stored.
            if (const auto time = clock_time(text))
                text = fmt::format("{:.6f}", clock.since_first(*time));
        }
        block.columns[*index].unit = "h:min:s";
        block.table.header.cells[*index].text = "time [s]";
    }
}

}  // namespace pendular
