#include "data/files/text_file.h"

#include <fmt/format.h>
#include <unicode/ucnv.h>
#include <unicode/ucsdet.h>
#include <unicode/utf8.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "data/input_error.h"

namespace pendular {
namespace {

/// Whether Shift-JIS is the most likely encoding of a text according to the charset detection of
/// ICU.
bool looks_japanese(std::string_view bytes) {
    UErrorCode error = U_ZERO_ERROR;
    UCharsetDetector* const detector = ucsdet_open(&error);
    // Only the first mebibyte is examined, since the time of detection is proportional to the
    // length.
    const auto length = static_cast<int32_t>(std::min<std::size_t>(bytes.size(), 1 << 20));
    ucsdet_setText(detector, bytes.data(), length, &error);
    const UCharsetMatch* const match = ucsdet_detect(detector, &error);
    const char* const name = match ? ucsdet_getName(match, &error) : nullptr;
    const bool japanese = U_SUCCESS(error) && name && std::string_view(name) == "Shift_JIS";
    ucsdet_close(detector);
    return japanese;
}

/// Name of the encoding of a text, from its byte-order mark or from the zero bytes of ASCII
/// characters in UTF-16; UTF-8 if neither is found.
const char* encoding_of(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) return "UTF-8";
    if (bytes.starts_with("\xFF\xFE")) return "UTF-16LE";
    if (bytes.starts_with("\xFE\xFF")) return "UTF-16BE";
    if (bytes.size() >= 2 && bytes[0] != 0 && bytes[1] == 0) return "UTF-16LE";
    if (bytes.size() >= 2 && bytes[0] == 0 && bytes[1] != 0) return "UTF-16BE";
    return "UTF-8";
}

/// Converts a text to UTF-8. Returns false if the bytes are not well-formed in `encoding`.
bool convert(std::string_view bytes, const char* encoding, std::string& utf8) {
    UErrorCode error = U_ZERO_ERROR;
    UConverter* const from = ucnv_open(encoding, &error);
    UConverter* const to = ucnv_open("UTF-8", &error);
    if (U_FAILURE(error)) {
        ucnv_close(from);
        ucnv_close(to);
        return false;
    }
    ucnv_setToUCallBack(from, UCNV_TO_U_CALLBACK_STOP, nullptr, nullptr, nullptr, &error);
    utf8.assign(3 * bytes.size() + 16, '\0');  // at most three times the length
    char* target = utf8.data();
    const char* source = bytes.data();
    ucnv_convertEx(to, from, &target, utf8.data() + utf8.size(), &source, source + bytes.size(),
                   nullptr, nullptr, nullptr, nullptr, true, true, &error);
    utf8.resize(static_cast<std::size_t>(target - utf8.data()));
    ucnv_close(from);
    ucnv_close(to);
    return U_SUCCESS(error);
}

}  // namespace

namespace {

/// @throws InputError for a file whose first bytes show another kind than text
void refuse_binary(std::string_view bytes, const std::filesystem::path& path) {
    using namespace std::string_view_literals;
    // A ZIP archive, a compound file, and workbooks of Excel 2 to 4, which need no container.
    for (const std::string_view begin : {"PK\x03\x04"sv, "\xD0\xCF\x11\xE0"sv, "\x09\x00\x04\x00"sv,
                                         "\x09\x02\x06\x00"sv, "\x09\x04\x06\x00"sv})
        if (bytes.starts_with(begin))
            throw InputError({path.string()},
                             "is a spreadsheet, not text; save it as CSV and name that file");
    constexpr std::pair<std::string_view, const char*> kinds[] = {
        {"%PDF-", "a PDF document"},
        {"{\\rtf", "an RTF document"},
        {"\x89PNG", "a picture (PNG)"},
        {"\xFF\xD8\xFF", "a picture (JPEG)"},
        {"\x1F\x8B", "a compressed file (gzip)"},
        {"7z\xBC\xAF", "an archive (7z)"},
        {"\x89HDF", "HDF5"},
        {"\x93NUMPY", "an array of NumPy"},
        {"MATLAB 5.0 MAT-file", "a MAT-file of MATLAB"},
        {"SQLite format 3", "a database (SQLite)"}};
    for (const auto& [begin, kind] : kinds)
        if (bytes.starts_with(begin))
            throw InputError(
                {path.string()},
                fmt::format("is {}, not a table of text; export the measurement as CSV "
                            "and name that file",
                            kind));
}

}  // namespace

DecodedText decode_bytes(const std::string& bytes, const std::filesystem::path& path,
                         const std::string& encoding) {
    refuse_binary(bytes, path);
    DecodedText result;
    std::vector<std::string> candidates = {encoding};
    if (encoding.empty()) {
        candidates = {encoding_of(bytes)};
        candidates.emplace_back("Shift_JIS");
        // Programs of old Macintosh computers ended lines with CR alone.
        if (bytes.find('\r') != std::string::npos && bytes.find('\n') == std::string::npos)
            candidates.emplace_back("macintosh");
        candidates.emplace_back("windows-1252");
    }
    for (const std::string& candidate : candidates) {
        if (encoding.empty() && candidate == "Shift_JIS" && !looks_japanese(bytes)) continue;
        std::string_view text = bytes;
        // A file that is cut may end within a character; its last row shows that it is cut.
        if (candidate.starts_with("UTF-16") && text.size() % 2 == 1) text.remove_suffix(1);
        if (!convert(text, candidate.c_str(), result.text)) continue;
        result.encoding = candidate;
        // Programs of DOS end a text with Ctrl-Z, and files that were not closed end with the zeros
        // of the space that was reserved for them.
        result.text.resize(result.text.find_last_not_of(std::string_view("\x1a\0", 2)) + 1);
        break;
    }
    if (result.encoding.empty() && !encoding.empty())
        throw InputError({path.string()},
                         fmt::format("is not text in the encoding \"{}\" that study.toml or the "
                                     "command line states; correct it or leave it out",
                                     encoding));
    if (result.encoding.empty() || result.text.find('\0') != std::string::npos)
        throw InputError({path.string()}, "is not text; export it as CSV in UTF-8");
    return result;
}

DecodedText decode_file(const std::filesystem::path& path, const std::string& encoding,
                        std::uintmax_t largest) {
    return decode_bytes(read_bytes(path, largest), path, encoding);
}

std::string read_text(const std::filesystem::path& path, std::uintmax_t largest) {
    return decode_file(path, "", largest).text;
}

std::vector<std::string_view> split_lines(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::vector<std::string_view> lines;
    // Searching for one character at a time is several times as fast as for either of two.
    const auto next = [&](char c, std::size_t from) {
        return std::min(text.find(c, from), text.size());
    };
    std::size_t feed = next('\n', 0), carriage = next('\r', 0);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(feed, carriage);
        lines.push_back(text.substr(begin, end - begin));
        begin = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
        if (feed < begin) feed = next('\n', begin);
        if (carriage < begin) carriage = next('\r', begin);
    }
    return lines;
}

std::vector<std::string> read_lines(const std::filesystem::path& path, std::uintmax_t largest) {
    const std::string text = read_text(path, largest);
    const std::vector<std::string_view> lines = split_lines(text);
    return {lines.begin(), lines.end()};
}

namespace {

bool is_harmless(UChar32 c) {
    if (c == '\n' || c == '\t') return true;
    const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
    const bool direction = c == 0x61c || c == 0x200e || c == 0x200f ||
                           (c >= 0x2028 && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
    return !control && !direction;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    const auto length = static_cast<std::int32_t>(text.size());
    for (std::int32_t at = 0; at < length;) {
        const std::int32_t begin = at;
        UChar32 c = 0;
        U8_NEXT(text.data(), at, length, c);
        if (c >= 0 && is_harmless(c)) {
            result +=
                text.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(at - begin));
        } else if (c > 0xff) {
            result += fmt::format("\\u{:04x}", c);
        } else {
            for (std::int32_t k = begin; k < at; ++k)
                result += fmt::format(
                    "\\x{:02x}", static_cast<unsigned char>(text[static_cast<std::size_t>(k)]));
        }
    }
    return result;
}

}  // namespace pendular
