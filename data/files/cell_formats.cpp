#include "data/files/cell_formats.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <map>

#include "data/files/xml_nodes.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Code without quoted text, escaped characters, colours and conditions, up to the first semicolon;
/// of the brackets only those with hours, minutes or seconds stay.
std::string bare_code(std::string_view code) {
    std::string bare;
    for (std::size_t i = 0; i < code.size() && code[i] != ';'; ++i) {
        if (code[i] == '"') {
            i = std::min(code.find('"', i + 1), code.size());
        } else if (code[i] == '\\' || code[i] == '_' || code[i] == '*') {
            ++i;  // the next character is shown, or its width left blank
        } else if (code[i] == '[') {
            const std::size_t end = std::min(code.find(']', i), code.size());
            const std::string_view inside = code.substr(i + 1, end - i - 1);
            if (inside.find_first_not_of("hHmMsS") == std::string_view::npos) bare += inside;
            i = end;
        } else {
            bare += static_cast<char>(std::tolower(static_cast<unsigned char>(code[i])));
        }
    }
    return bare;
}

std::string clock_text(std::int64_t microseconds) {
    constexpr std::int64_t second = 1'000'000, minute = 60 * second, hour = 60 * minute;
    std::string text = fmt::format("{:02}:{:02}:{:02}", microseconds / hour,
                                   microseconds % hour / minute, microseconds % minute / second);
    if (const std::int64_t part = microseconds % second; part > 0) {
        text += fmt::format(".{:06}", part);
        text.erase(text.find_last_not_of('0') + 1);
    }
    return text;
}

/// Date of a day number. The calendar that counts from 1900 has a 29 February 1900, number 60.
std::string date_text(std::int64_t day, bool from_1904) {
    using namespace std::chrono;
    const sys_days first = from_1904  ? sys_days(year(1904) / 1 / 1)
                           : day < 60 ? sys_days(year(1899) / 12 / 31)
                                      : sys_days(year(1899) / 12 / 30);
    const year_month_day date(first + days(day));
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

}  // namespace

// Source: ECMA-376 part 1, section 18.8.30; 27 to 36 and 50 to 58 are those of East Asia.
CellFormat format_of_identifier(unsigned identifier) {
    const auto within = [&](unsigned from, unsigned to) {
        return identifier >= from && identifier <= to;
    };
    const bool east_asian = within(27, 36) || within(50, 58);
    return {.date = within(14, 17) || identifier == 22 || east_asian,
            .time = within(18, 22) || within(45, 47),
            .percent = within(9, 10)};
}

CellFormat format_of_code(std::string_view code) {
    std::string bare = bare_code(code);
    if (bare == "general") return {};
    for (const std::string_view half : {"am/pm", "a/p"})
        if (const std::size_t at = bare.find(half); at != std::string::npos)
            bare.erase(at, half.size());
    const bool time = bare.find_first_of("hs") != std::string::npos;
    const bool day = bare.find_first_of("yd") != std::string::npos;
    const bool month = bare.find('m') != std::string::npos && !time;  // else minutes
    return {day || month, time, bare.find('%') != std::string::npos};
}

CellFormats::CellFormats(const pugi::xml_node& styles, bool from_1904) : from_1904_(from_1904) {
    std::map<unsigned, CellFormat> written;
    for (const pugi::xml_node& each : child_named(styles, "numFmts").children())
        written[each.attribute("numFmtId").as_uint()] =
            format_of_code(each.attribute("formatCode").value());
    for (const pugi::xml_node& each : child_named(styles, "cellXfs").children()) {
        if (local_name(each.name()) != "xf") continue;
        const unsigned identifier = each.attribute("numFmtId").as_uint();
        const auto found = written.find(identifier);
        by_style_.push_back(found == written.end() ? format_of_identifier(identifier)
                                                   : found->second);
    }
}

std::string CellFormats::text_of(std::string_view number, std::size_t style) const {
    constexpr double last_day = 2'958'466;  // of the year 9999
    const CellFormat format = style < by_style_.size() ? by_style_[style] : CellFormat{};
    const auto value = parse_number(number);
    if ((!format.date && !format.time) || !value || *value < 0 || *value >= last_day)
        return std::string(number);
    constexpr std::int64_t day = 86'400'000'000;
    const std::int64_t microseconds = std::llround(*value * static_cast<double>(day));
    if (!format.date) return clock_text(microseconds);
    std::string date = date_text(microseconds / day, from_1904_);
    if (!format.time && microseconds % day == 0) return date;
    return date + " " + clock_text(microseconds % day);
}

}  // namespace pendular
