#include "data/files/old_records.h"

#include <unicode/ustring.h>

#include <algorithm>

#include "data/files/little_endian.h"

namespace pendular {
namespace {

/// UTF-8 of a text in UTF-16, with a question mark in a diamond for what is no character.
std::string utf8_of(const std::u16string& text) {
    std::string utf8(3 * text.size(), '\0');  // at most three bytes for each unit
    UErrorCode error = U_ZERO_ERROR;
    int32_t length = 0;
    u_strToUTF8WithSub(utf8.data(), static_cast<int32_t>(utf8.size()), &length, text.data(),
                       static_cast<int32_t>(text.size()), 0xFFFD, nullptr, &error);
    utf8.resize(U_SUCCESS(error) ? static_cast<std::size_t>(length) : 0);
    return utf8;
}

}  // namespace

std::optional<OldRecord> next_record(std::string_view stream, std::size_t& at) {
    constexpr std::size_t head = 4;
    if (at + head > stream.size()) return std::nullopt;
    const OldRecord record = {two_bytes(stream, at),
                              stream.substr(at + head, two_bytes(stream, at + 2))};
    at += head + record.body.size();
    return record;
}

bool OldTexts::at_end() {
    while (part_ < parts_.size() && at_ >= parts_[part_].size()) {
        ++part_;
        at_ = 0;
    }
    return part_ >= parts_.size();
}

unsigned OldTexts::byte() {
    return at_end() ? 0 : static_cast<unsigned char>(parts_[part_][at_++]);
}

std::uint32_t OldTexts::number(std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i)
        value |= byte() << (8 * i);
    return value;
}

void OldTexts::skip(std::size_t bytes) {
    while (bytes > 0 && !at_end()) {
        const std::size_t here = std::min(bytes, parts_[part_].size() - at_);
        at_ += here;
        bytes -= here;
    }
}

std::string OldTexts::text(std::size_t length_bytes) {
    constexpr unsigned wide = 1, asian = 4, rich = 8;
    const std::size_t length = number(length_bytes);
    unsigned flags = byte();
    const std::size_t formats = (flags & rich) != 0 ? number(2) : 0,
                      pronunciation = (flags & asian) != 0 ? number(4) : 0;
    std::u16string text;
    for (std::size_t i = 0; i < length; ++i) {
        const std::size_t part = part_;
        if (at_end()) break;
        if (part_ != part) flags = byte();
        const unsigned low = byte(), high = (flags & wide) != 0 ? byte() : 0;
        text += static_cast<char16_t>(low | high << 8);
    }
    skip(4 * formats + pronunciation);
    return utf8_of(text);
}

}  // namespace pendular
