#include "data/files/text_file.h"

#include <unicode/ucnv.h>

#include <algorithm>
#include <string_view>

#include "data/input_error.h"

namespace pendular {
namespace {

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

std::string decoded(const std::string& bytes, const std::filesystem::path& path) {
    if (bytes.starts_with("PK\x03\x04") || bytes.starts_with("\xD0\xCF\x11\xE0"))
        throw InputError({path.string()},
                         "is a spreadsheet, not text; save it as CSV and name that file");
    std::string text;
    const bool well_formed =
        convert(bytes, encoding_of(bytes), text) || convert(bytes, "windows-1252", text);
    if (!well_formed || text.find('\0') != std::string::npos)
        throw InputError({path.string()}, "is not text; export it as CSV in UTF-8");
    return text;
}

}  // namespace

std::string read_text(const std::filesystem::path& path, std::uintmax_t largest) {
    return decoded(read_bytes(path, largest), path);
}

std::vector<std::string> read_lines(const std::filesystem::path& path, std::uintmax_t largest) {
    const std::string text = read_text(path, largest);
    std::vector<std::string> lines;
    for (std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        const bool both = text.compare(end, 2, "\r\n") == 0;
        begin = end + (both ? 2 : 1);
    }
    return lines;
}

}  // namespace pendular
