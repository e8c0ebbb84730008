#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Kinds of records of an old workbook (.xls) that are read.
namespace record_kind {
constexpr unsigned formula = 0x06, end = 0x0A, date_mode = 0x22, password = 0x2F,
                   continuation = 0x3C, code_page = 0x42, sheet = 0x85, numbers = 0xBD,
                   rich_text = 0xD6, style = 0xE0, merged = 0xE5, shared_texts = 0xFC,
                   shared_text = 0xFD, number = 0x203, text = 0x204, truth_or_error = 0x205,
                   result_text = 0x207, row = 0x208, short_number = 0x27E, format = 0x41E,
                   begin = 0x809;
}

/// Record of an old workbook: what kind it is of, and its bytes.
struct OldRecord {
    unsigned kind = 0;
    std::string_view body;
};

/// Returns the record at a place of a stream, which moves to the next; empty at the end.
std::optional<OldRecord> next_record(std::string_view stream, std::size_t& at);

/// Reads the texts of a record and its continuations. Numbers and formats continue as if they were
/// one; characters that continue begin with a byte that says how wide they are.
class OldTexts {
  public:
    explicit OldTexts(std::vector<std::string_view> parts) : parts_(std::move(parts)) {}

    bool at_end();
    std::uint32_t number(std::size_t bytes);
    /// Returns a text in Unicode as UTF-8, without its formats.
    /// @param length_bytes size of the number of characters before it [bytes]
    std::string text(std::size_t length_bytes);

  private:
    unsigned byte();
    void skip(std::size_t bytes);

    std::vector<std::string_view> parts_;
    std::size_t part_ = 0, at_ = 0;
};

}  // namespace pendular
