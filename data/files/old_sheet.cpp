#include "data/files/old_sheet.h"

#include <fmt/format.h>
#include <unicode/ucnv.h>
#include <unicode/unistr.h>

#include <algorithm>
#include <map>

#include "data/files/csv.h"
#include "data/files/little_endian.h"

namespace pendular {
namespace {

CellPlace place_of_record(std::string_view record) {
    return {two_bytes(record, 0), two_bytes(record, 2)};
}

/// Number in the four bytes of an "RK": a whole number or the upper half of a double, of which one
/// bit says that it is a hundred times the value.
double value_of_short(std::uint32_t bits) {
    constexpr std::uint32_t hundredfold = 1, whole = 2, flags = 3;
    const double value = (bits & whole) != 0
                             ? static_cast<double>(static_cast<std::int32_t>(bits) >> 2)
                             : double_of(std::uint64_t(bits & ~flags) << 32);
    return (bits & hundredfold) != 0 ? value / 100 : value;
}

/// Text of an error or of a truth value, which is no number.
std::string truth_or_error_text(unsigned value, bool error) {
    static const std::map<unsigned, std::string> errors = {
        {0x00, "#NULL!"}, {0x07, "#DIV/0!"}, {0x0F, "#VALUE!"}, {0x17, "#REF!"},
        {0x1D, "#NAME?"}, {0x24, "#NUM!"},   {0x2A, "#N/A"}};
    if (!error) return value != 0 ? "TRUE" : "FALSE";
    const auto known = errors.find(value);
    return known == errors.end() ? "#ERROR!" : known->second;
}

}  // namespace

std::string code_page_name(unsigned number) {
    // Those whose number is that of another code page of IBM, and those that ICU has by names.
    static const std::map<unsigned, std::string> others = {
        {708, "ASMO-708"},    {874, "windows-874"}, {932, "Shift_JIS"},   {936, "GBK"},
        {949, "windows-949"}, {950, "windows-950"}, {10000, "macintosh"}, {0x8000, "macintosh"}};
    if (const auto found = others.find(number); found != others.end()) return found->second;
    if (number >= 1250 && number <= 1258) return fmt::format("windows-{}", number);
    const std::string of_dos = fmt::format("ibm-{}", number);
    UErrorCode error = U_ZERO_ERROR;
    const bool known =
        number >= 437 && number <= 869 && ucnv_countAliases(of_dos.c_str(), &error) > 0;
    return known ? of_dos : "windows-1252";
}

std::string text_in_code_page(std::string_view bytes, const std::string& code_page) {
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    if (std::ranges::all_of(bytes, is_ascii)) return std::string(bytes);
    icu::UnicodeString text(bytes.data(), static_cast<int32_t>(bytes.size()), code_page.c_str());
    // In place of half a character of Shift-JIS, ICU has a control character of ASCII.
    text.findAndReplace(icu::UnicodeString(UChar32{0x1A}), icu::UnicodeString(UChar32{0xFFFD}));
    std::string utf8;
    text.toUTF8String(utf8);
    return utf8;
}

void OldSheet::add(Cell cell) {
    check_cell_count(cells_.size() + 1, file_, static_cast<int>(cell.place.row) + 1);
    cells_.push_back(std::move(cell));
}

void OldSheet::add(std::string_view record, std::string text) {
    add({.place = place_of_record(record), .text = std::move(text)});
}

void OldSheet::add_number(const CellPlace& place, unsigned style, double value) {
    add({.place = place,
         .text = formats_.text_of(fmt::format("{}", value), style),
         .percent = formats_.shows_percent(style)});
}

void OldSheet::take_numbers(std::string_view record) {
    CellPlace place = place_of_record(record);
    // Six bytes for each number; the last two bytes repeat the last column.
    for (std::size_t at = 4; at + 8 <= record.size(); at += 6, ++place.column)
        add_number(place, two_bytes(record, at), value_of_short(four_bytes(record, at + 2)));
}

void OldSheet::take_formula(std::string_view record) {
    constexpr unsigned text = 0, truth = 1, error = 2;
    awaits_text_ = false;
    if (two_bytes(record, 12) != 0xFFFF) {
        computed_ = true;
        add_number(place_of_record(record), two_bytes(record, 4),
                   double_of(whole_number(record, 6, 8)));
        return;
    }
    const unsigned type = one_byte(record, 6), value = one_byte(record, 8);
    computed_ = computed_ || type <= error;
    awaits_text_ = type == text;
    if (type > error) without_result_.push_back(cells_.size());
    add(record, type == truth || type == error ? truth_or_error_text(value, type == error) : "");
}

void OldSheet::take_merged(std::string_view record) {
    for (std::size_t at = 2; at + 8 <= record.size(); at += 8)
        merged_.push_back({{two_bytes(record, at), two_bytes(record, at + 4)},
                           {two_bytes(record, at + 2), two_bytes(record, at + 6)}});
}

void OldSheet::take(const OldRecord& record) {
    namespace kind = record_kind;
    constexpr std::size_t least_cell = 6;  // row, column and style
    const std::string_view body = record.body;
    if (record.kind == kind::result_text && awaits_text_ && !cells_.empty()) {
        cells_.back().text = text_at_(body, 0);
        awaits_text_ = false;
    }
    if (record.kind == kind::merged) take_merged(body);
    if (body.size() < least_cell) return;
    if (record.kind == kind::formula) take_formula(body);
    if (record.kind == kind::numbers) take_numbers(body);
    if (record.kind == kind::number)
        add_number(place_of_record(body), two_bytes(body, 4), double_of(whole_number(body, 6, 8)));
    if (record.kind == kind::short_number)
        add_number(place_of_record(body), two_bytes(body, 4), value_of_short(four_bytes(body, 6)));
    if (record.kind == kind::text || record.kind == kind::rich_text) add(body, text_at_(body, 6));
    if (record.kind == kind::shared_text)
        add({.place = place_of_record(body),
             .text = {},
             .shared = shared_text_(four_bytes(body, 6))});
    if (record.kind == kind::truth_or_error)
        add(body, truth_or_error_text(one_byte(body, 6), one_byte(body, 7) != 0));
    constexpr std::uint64_t no_height = 0x20;
    if (record.kind == kind::row && (four_bytes(body, 12) & no_height) != 0)
        hidden_.insert(two_bytes(body, 0));
}

SheetText OldSheet::text() {
    if (!computed_)
        for (const std::size_t index : without_result_)
            cells_[index].text = "=";
    std::erase_if(cells_, [](const Cell& cell) { return cell.content().empty(); });
    std::ranges::stable_sort(cells_, {}, &Cell::place);
    std::size_t width = 0;
    for (const Cell& cell : cells_)
        width = std::max(width, cell.place.column + 1);
    SheetLines lines(file_, width);
    for (const auto& [first, last] : merged_)
        lines.merge(first, last);
    for (std::size_t i = 0; i < cells_.size();) {
        const std::size_t row = cells_[i].place.row;
        lines.add_empty_until(row);
        lines.begin_row(hidden_.contains(row));
        for (; i < cells_.size() && cells_[i].place.row == row; ++i)
            lines.set(cells_[i].place.column, cells_[i].content(), cells_[i].percent);
        lines.end_row();
    }
    return lines.take();
}

}  // namespace pendular
