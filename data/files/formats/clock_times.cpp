#include "data/files/formats/clock_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <vector>

#include "data/files/text_pattern.h"
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

/// Order of the numbers in dates between slashes, where it does not begin with the year.
enum class DateOrder { day_first, month_first };

/// Day since 1970 of a date between slashes or hyphens, or of eight digits from the year on; empty
/// for other texts.
std::optional<double> day_of(const std::string& date, DateOrder order) {
    static const TextPattern form(
        R"((\d{4}|\d{1,2})[/-](\d{1,2})[/-](\d{1,4})|(\d{4})(\d\d)(\d\d))");
    const auto found = form.whole(date);
    if (!found) return std::nullopt;
    const auto& part = found->parts;
    if (!part[4].empty())
        return day_number(std::stoi(part[4]), std::stoi(part[5]), std::stoi(part[6]));
    int first = std::stoi(part[1]), last = std::stoi(part[3]);
    const int middle = std::stoi(part[2]);
    if (part[1].size() == 4) return day_number(first, middle, last);
    if (part[3].size() == 2) last += 2000;
    return order == DateOrder::day_first ? day_number(last, middle, first)
                                         : day_number(last, first, middle);
}

/// Date between slashes in a cell.
struct PlacedDate {
    std::string text;
    Position at;
};

/// Order of the numbers in the dates of a file; empty if all dates are the same, so that they do
/// not matter.
/// @throws InputError at the first date that is another day in either order, if both are possible,
///         and at the first that is no day in the order of the others
std::optional<DateOrder> order_of(const std::vector<PlacedDate>& dates) {
    if (dates.size() < 2) return std::nullopt;
    const auto wrong = [&](DateOrder order) {
        return std::ranges::find_if(
            dates, [&](const PlacedDate& date) { return !day_of(date.text, order); });
    };
    const auto no_day = wrong(DateOrder::day_first), no_month = wrong(DateOrder::month_first);
    if (no_day == dates.end() && no_month != dates.end()) return DateOrder::day_first;
    if (no_month == dates.end() && no_day != dates.end()) return DateOrder::month_first;
    if (no_day != dates.end())
        throw InputError(std::max(no_day, no_month)->at,
                         fmt::format("\"{}\" is no date that goes with \"{}\"; write dates as "
                                     "2024-03-01",
                                     std::max(no_day, no_month)->text, dates.front().text));
    const auto since_first = [&](const PlacedDate& date, DateOrder order) {
        return *day_of(date.text, order) - *day_of(dates.front().text, order);
    };
    for (const PlacedDate& date : dates)
        if (since_first(date, DateOrder::day_first) != since_first(date, DateOrder::month_first))
            throw InputError(date.at, fmt::format("the dates \"{}\" and \"{}\" may be day/month or "
                                                  "month/day; write them as 2024-03-01",
                                                  dates.front().text, date.text));
    return DateOrder::day_first;
}

/// Different dates between slashes in the clock times of a file, in their order.
std::vector<PlacedDate> dates_in(const BlockFile& file) {
    std::vector<PlacedDate> dates;
    std::set<std::string> known;
    for (const Block& block : file.blocks) {
        const auto index = column_of_clock_times(block);
        if (!index) continue;
        for (const Row& row : block.table.rows)
            if (const auto time = clock_time(row.cells[*index].text))
                if (!time->date.empty() && known.insert(time->date).second)
                    dates.push_back({time->date, block.table.at(row, *index)});
    }
    return dates;
}

}  // namespace

namespace {

/// Date before a clock time: 2024-03-01, 1.3.2024 or 01.03.24, 01-Mar-2024, or numbers between
/// slashes or hyphens, whose order the other dates of the file tell.
constexpr const char* date_form =
    R"((?:(\d{4})-(\d\d?)-(\d\d?)|(\d\d?)\.(\d\d?)\.(\d{4}|\d\d)|)"
    R"((\d\d?)[- ](Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)[- ](\d{4})|([\d/-]{6,10})))";

/// Hours, minutes and seconds with decimals, or milliseconds after a colon; AM or PM; the
/// difference to universal time.
constexpr const char* time_form =
    R"((\d{1,6}):([0-5]\d):([0-5]\d(?:[.,]\d+|:\d{3})?)\s*([AaPp][Mm])?(?:Z|([+-])(\d\d):?(\d\d))?)";

/// Day since 1970 of the date in the parts 1 to 9 of `date_form`; empty for none.
std::optional<double> date_in(const std::vector<std::string>& part, bool& stated) {
    const auto number = [&](std::size_t i) { return std::stoi(part[i]); };
    stated = true;
    if (!part[1].empty()) return day_number(number(1), number(2), number(3));
    if (!part[4].empty())
        return day_number(number(6) < 100 ? 2000 + number(6) : number(6), number(5), number(4));
    constexpr std::string_view months = "JanFebMarAprMayJunJulAugSepOctNovDec";
    if (!part[7].empty())
        return day_number(number(9), 1 + static_cast<int>(months.find(part[8]) / 3), number(7));
    stated = false;
    return std::nullopt;
}

/// Seconds in a text such as "07.5", "07,5" or "07:500".
double seconds_in(std::string text) {
    for (char& c : text)
        if (c == ',' || c == ':') c = '.';
    return parse_number(text).value_or(0);
}

/// Minutes and seconds with decimals, as spreadsheets show times: "2:03.5"; empty for other texts.
std::optional<ClockTime> minutes_and_seconds(std::string_view text) {
    static const TextPattern form(R"((\d{1,6}):([0-5]\d[.,]\d+))");
    const auto found = form.whole(text);
    if (!found) return std::nullopt;
    return ClockTime{60.0 * std::stoi(found->parts[1]) + seconds_in(found->parts[2]), false, ""};
}

}  // namespace

std::optional<ClockTime> clock_time(std::string_view text) {
    if (text.size() > 40 || text.find(':') == std::string_view::npos) return std::nullopt;
    if (const auto time = minutes_and_seconds(text)) return time;
    static const TextPattern form(std::string("(?:") + date_form + "[T ]+)?" + time_form);
    const auto match = form.whole(text);
    if (!match) return std::nullopt;
    const auto& part = match->parts;
    const auto number = [&](std::size_t i) { return std::stoi(part[i]); };
    int hours = number(11);
    if (!part[14].empty()) {
        if (hours < 1 || hours > 12) return std::nullopt;
        const char half = part[14].front();
        hours = hours % 12 + (half == 'p' || half == 'P' ? 12 : 0);
    }
    ClockTime time{3600.0 * hours + 60 * number(12) + seconds_in(part[13]), false, part[10]};
    bool stated = false;
    const std::optional<double> date = date_in(part, stated);
    if (stated && !date) return std::nullopt;
    if (date) time = {time.seconds + day * *date, true, ""};
    if (date && !part[15].empty())
        time.seconds -= (part[15] == "-" ? -60.0 : 60.0) * (60 * number(16) + number(17));
    return time;
}

namespace {

/// @throws InputError at the first text in a column of times without a unit that looks like a clock
///         time but is none that is read
void refuse_other_clocks(const Block& block) {
    const auto column = std::ranges::find(block.columns, "time", &BlockColumn::quantity);
    if (column == block.columns.end() || !column->unit.empty()) return;
    const auto index = static_cast<std::size_t>(column - block.columns.begin());
    for (const Row& row : block.table.rows) {
        const std::string& text = row.cells[index].text;
        if (text.find(':') == std::string::npos || clock_time(text)) continue;
        throw InputError(block.table.at(row, index),
                         fmt::format("\"{}\" is no clock time that can be read; write hours, "
                                     "minutes and seconds, as in 14:03:07.5 or 2024-03-01 "
                                     "14:03:07.5, or the seconds since the start below 'Time [s]'",
                                     text));
    }
}

}  // namespace

void read_clock_times(BlockFile& file) {
    Clock clock;
    const std::optional<DateOrder> order = order_of(dates_in(file));
    for (Block& block : file.blocks) {
        refuse_other_clocks(block);
        const auto index = column_of_clock_times(block);
        if (!index) continue;
        for (Row& row : block.table.rows) {
            std::string& text = row.cells[*index].text;
            // Microseconds, as fine as a number of days can be stored.
            auto time = clock_time(text);
            if (!time) continue;
            if (const auto date = order ? day_of(time->date, *order) : std::nullopt)
                time = {time->seconds + day * *date, true, ""};
            text = fmt::format("{:.6f}", clock.since_first(*time));
        }
        block.columns[*index].unit = "h:min:s";
        block.table.header.cells[*index].text = "time [s]";
    }
}

}  // namespace pendular
