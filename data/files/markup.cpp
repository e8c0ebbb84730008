#include "data/files/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "data/input_error.h"

namespace pendular {
namespace {

/// Beginning of a text in lower case, without byte-order mark and blanks in front. The first
/// elements of a document are within a few hundred bytes.
std::string beginning_of(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    std::string result(text.substr(0, 4096));
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

bool is_html(const std::string& begin) {
    constexpr std::array<std::string_view, 6> elements = {"<!doctype html", "<html",  "<head",
                                                          "<body",          "<table", "<meta"};
    // Other XML may have elements of these names too, such as the <Table> of spreadsheets.
    if (begin.starts_with("<?xml"))
        return begin.find("<html") != std::string::npos ||
               begin.find("<!doctype html") != std::string::npos;
    return begin.starts_with('<') && std::ranges::any_of(elements, [&](std::string_view element) {
               const std::size_t at = begin.find(element);
               if (at == std::string::npos) return false;
               // <header> is no <head>.
               const std::size_t next = at + element.size();
               return next >= begin.size() ||
                      !std::isalnum(static_cast<unsigned char>(begin[next]));
           });
}

/// Whether a text begins with an element, and closes one: a header such as "<a>;<b>" does not.
bool is_xml(const std::string& begin, std::string_view text) {
    if (begin.starts_with("<?xml") || begin.starts_with("<!--")) return true;
    return begin.size() > 1 && begin[0] == '<' &&
           std::isalpha(static_cast<unsigned char>(begin[1])) &&
           text.substr(0, 1 << 20).find("</") != std::string_view::npos;
}

/// Whether a text begins with an object, or with an array of objects, arrays or strings. A line
/// "[step]" or "[s]" begins no array.
bool is_json(const std::string& begin) {
    if (begin.empty() || (begin[0] != '{' && begin[0] != '[')) return false;
    const std::size_t next = begin.find_first_not_of(" \t\r\n", 1);
    if (next == std::string::npos) return false;
    return begin[0] == '{' ? begin[next] == '"' || begin[next] == '}'
                           : begin[next] == '{' || begin[next] == '[' || begin[next] == '"';
}

}  // namespace

void refuse_markup(const std::filesystem::path& path, std::string_view text) {
    const std::string begin = beginning_of(text);
    if (is_html(begin))
        throw InputError({path.string()},
                         "is HTML, not a table: export as CSV or text, or open it in a "
                         "spreadsheet and save it as .xlsx");
    // What Excel calls an XML spreadsheet, often with the ending .xls.
    if (begin.find("urn:schemas-microsoft-com:office:spreadsheet") != std::string::npos)
        throw InputError({path.string()},
                         "is a spreadsheet in XML, not a table: open it in a spreadsheet and save "
                         "it as .xlsx");
    const char* const kind = is_xml(begin, text) ? "XML"
                             : is_json(begin)    ? "JSON"
                             : begin.starts_with("\\begin{") || begin.starts_with("\\documentclass")
                                 ? "LaTeX"
                                 : nullptr;
    if (kind)
        throw InputError({path.string()},
                         fmt::format("is {}, not a table: export as CSV or text (TRIOS: Export to "
                                     "LIMS)",
                                     kind));
}

}  // namespace pendular
