#include "data/files/folded_name.h"

#include <unicode/uchar.h>
#include <unicode/unorm2.h>
#include <unicode/ustring.h>
#include <unicode/utf16.h>
#include <unicode/utf8.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace pendular {
namespace {

/// Characters of a text, with letters and accents apart; empty if it is no UTF-8.
std::u16string decomposed(std::string_view text) {
    UErrorCode error = U_ZERO_ERROR;
    std::u16string wide(text.size() + 1, u'\0');
    int32_t length = 0;
    u_strFromUTF8(wide.data(), static_cast<int32_t>(wide.size()), &length, text.data(),
                  static_cast<int32_t>(text.size()), &error);
    std::u16string result(4 * wide.size(), u'\0');  // no character becomes more than four
    const UNormalizer2* const normalizer = unorm2_getNFDInstance(&error);
    if (U_FAILURE(error)) return {};
    const int32_t size = unorm2_normalize(normalizer, wide.data(), length, result.data(),
                                          static_cast<int32_t>(result.size()), &error);
    if (U_FAILURE(error)) return {};
    result.resize(static_cast<std::size_t>(size));
    return result;
}

void append_utf8(std::string& text, UChar32 c) {
    std::array<char, U8_MAX_LENGTH> bytes = {};
    int32_t size = 0;
    U8_APPEND_UNSAFE(bytes.data(), size, c);
    text.append(bytes.data(), static_cast<std::size_t>(size));
}

/// Letters without an accent that are written so where a keyboard lacks a letter that has no
/// decomposition; empty for all others.
std::string_view in_latin(UChar32 small) {
    switch (small) {
        case 0xDF:  // ß
            return "ss";
        case 0xE6:  // æ
            return "a";
        case 0xF8:  // ø
            return "o";
        case 0x131:  // ı
            return "i";
        case 0x142:  // ł
            return "l";
        default:
            return "";
    }
}

/// Text with the German ways to write ä, ö and ü without dots as these letters without dots.
std::string without_dots(std::string text) {
    for (const char vowel : {'a', 'o', 'u'}) {
        const std::string pair = {vowel, 'e'};
        for (std::size_t at = text.find(pair); at != std::string::npos;
             at = text.find(pair, at + 1))
            text.erase(at + 1, 1);
    }
    return text;
}

}  // namespace

std::string folded_name(std::string_view name) {
    const std::u16string wide = decomposed(name);
    std::string result;
    bool after_latin = false;
    for (std::size_t i = 0; i < wide.size();) {
        UChar32 c = 0;
        U16_NEXT(wide.data(), i, wide.size(), c);
        if (after_latin && u_charType(c) == U_NON_SPACING_MARK) continue;
        after_latin = c < 0x80 && std::isalpha(static_cast<int>(c));
        if (u_charType(c) == U_FORMAT_CHAR) continue;  // without width
        if (u_isUWhiteSpace(c) || c == '_' || c == '-' || c == '.') continue;
        const UChar32 small = u_foldCase(c, U_FOLD_CASE_DEFAULT);
        if (const std::string_view latin = in_latin(small); !latin.empty())
            result += latin;
        else
            append_utf8(result, small);
    }
    return without_dots(std::move(result));
}

std::string lower_case(std::string_view text) {
    const std::u16string apart = decomposed(text);
    std::u16string together(apart.size() + 1, u'\0');
    UErrorCode error = U_ZERO_ERROR;
    const UNormalizer2* const normalizer = unorm2_getNFCInstance(&error);
    if (U_FAILURE(error)) return std::string(text);
    const int32_t size =
        unorm2_normalize(normalizer, apart.data(), static_cast<int32_t>(apart.size()),
                         together.data(), static_cast<int32_t>(together.size()), &error);
    if (U_FAILURE(error)) return std::string(text);
    together.resize(static_cast<std::size_t>(size));
    std::string result;
    for (std::size_t i = 0; i < together.size();) {
        UChar32 c = 0;
        U16_NEXT(together.data(), i, together.size(), c);
        append_utf8(result, u_tolower(c));
    }
    return result;
}

}  // namespace pendular
