#include "data/files/old_workbook.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "data/files/compound_file.h"
#include "data/files/little_endian.h"
#include "data/files/old_records.h"
#include "data/files/old_sheet.h"
#include "data/files/sheet_path.h"

namespace pendular {

namespace kind = record_kind;

void OldWorkbook::refuse(const std::string& reason) const {
    refuse_workbook(file_, reason);
}

OldWorkbook::OldWorkbook(const std::string& bytes, const std::string& file) : file_(file) {
    auto streams = streams_of(bytes);
    if (streams.contains("ENCRYPTEDPACKAGE")) refuse("it is protected by a password");
    for (const char* const name : {"WORKBOOK", "BOOK"})
        if (stream_.empty()) stream_ = std::move(streams[name]);
    if (stream_.empty()) refuse("it holds no stream called Workbook");
    read_globals();
    if (names_.empty()) refuse("it has no sheet with cells");
    find_ends();
}

void OldWorkbook::read_globals() {
    constexpr unsigned year_1997 = 0x600;
    std::size_t at = 0;
    const auto first = next_record(stream_, at);
    if (!first || first->kind != kind::begin) refuse("its list of records does not begin as one");
    before_1997_ = two_bytes(first->body, 0) < year_1997;
    std::map<unsigned, CellFormat> written;
    std::vector<unsigned> used;  // identifiers of formats, by style
    while (const auto record = next_record(stream_, at)) {
        const std::string_view body = record->body;
        if (record->kind == kind::end) break;
        if (record->kind == kind::password) refuse("it is protected by a password");
        if (record->kind == kind::code_page) code_page_ = code_page_name(two_bytes(body, 0));
        if (record->kind == kind::date_mode) from_1904_ = two_bytes(body, 0) == 1;
        if (record->kind == kind::format)
            written[two_bytes(body, 0)] = format_of_code(text_at(body, 2, before_1997_ ? 1 : 2));
        if (record->kind == kind::style) used.push_back(two_bytes(body, 2));
        if (record->kind == kind::sheet) read_sheet(body);
        if (record->kind == kind::shared_texts) find_shared(body, at);
    }
    std::vector<CellFormat> styles;
    for (const unsigned identifier : used) {
        const auto found = written.find(identifier);
        styles.push_back(found == written.end() ? format_of_identifier(identifier) : found->second);
    }
    formats_ = CellFormats(std::move(styles), from_1904_);
}

void OldWorkbook::read_sheet(std::string_view record) {
    constexpr unsigned of_cells = 0;  // others are charts and macros
    constexpr unsigned state = 3;     // bits; the others have no meaning
    if (record.size() < 7 || record[5] != of_cells) return;
    names_.push_back({text_at(record, 6, 1), (one_byte(record, 4) & state) != 0});
    begins_.push_back(four_bytes(record, 0));
}

void OldWorkbook::find_ends() {
    std::map<std::size_t, std::size_t> sheets;  // by their beginnings
    for (std::size_t k = 0; k < begins_.size(); ++k)
        if (const auto [other, added] = sheets.emplace(begins_[k], k); !added)
            refuse(fmt::format("its sheets {} and {} begin at the same record",
                               names_[other->second].name, names_[k].name));
    for (const std::uint32_t begin : begins_) {
        const auto next = sheets.upper_bound(begin);
        ends_.push_back(next == sheets.end() ? stream_.size() : next->first);
    }
}

void OldWorkbook::find_shared(std::string_view record, std::size_t at) {
    std::vector<std::string_view> parts = {record.substr(std::min<std::size_t>(8, record.size()))};
    while (const auto more = next_record(stream_, at)) {
        if (more->kind != kind::continuation) break;
        parts.push_back(more->body);
    }
    for (const std::string_view part : parts)
        shared_size_ += part.size();
    shared_.push_back(std::move(parts));
}

const std::string* OldWorkbook::shared_text(std::size_t index) {
    // Each takes 32 bytes of memory or more. A sheet has 65,536 rows.
    constexpr std::size_t most_strings = 5'000'000;
    for (auto& parts : std::exchange(shared_, {}))
        for (OldTexts texts(std::move(parts)); !texts.at_end();) {
            if (strings_.size() >= most_strings) refuse("it has more than 5 million texts");
            strings_.push_back(texts.text(2));
        }
    return index < strings_.size() ? &strings_[index] : nullptr;
}

std::string OldWorkbook::text_at(std::string_view record, std::size_t at,
                                 std::size_t length_bytes) const {
    if (at >= record.size()) return "";
    if (!before_1997_) return OldTexts({record.substr(at)}).text(length_bytes);
    const std::size_t length = whole_number(record, at, length_bytes);
    if (at + length_bytes >= record.size()) return "";
    return text_in_code_page(record.substr(at + length_bytes, length), code_page_);
}

SheetText OldWorkbook::rows(std::size_t sheet) {
    const std::string path = path_of_sheet(file_, names_.at(sheet).name).string();
    OldSheet cells(
        path, formats_,
        [&](std::string_view record, std::size_t at) { return text_at(record, at, 2); },
        [&](std::size_t index) { return shared_text(index); });
    std::size_t at = begins_[sheet], depth = 0;
    while (const auto record = next_record(stream_, at)) {
        if (at > ends_[sheet])
            refuse(fmt::format("another sheet begins within its sheet {}", names_[sheet].name));
        // Charts within the sheet are lists of records of their own.
        if (record->kind == kind::begin) ++depth;
        if (record->kind == kind::end && depth-- <= 1) break;
        if (depth == 1) cells.take(*record);
    }
    return cells.text();
}

}  // namespace pendular
