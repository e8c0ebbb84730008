#include "data/study/study_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "data/files/text_file.h"
#include "data/files/toml_text.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"

namespace pendular {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t";

/// Replacement of the bytes [begin, end) of a text.
struct Edit {
    std::size_t begin, end;
    std::string text;
};

/// Bytes [begin, end) of an element of the list of effects, quotes included.
struct Element {
    std::size_t begin, end;
    std::optional<std::size_t> comma;  ///< position of the comma after the element, if there is one
};

/// List of effects in the text of study.toml, as positions of bytes.
struct List {
    std::size_t open, close;  ///< positions of the brackets
    std::vector<Element> elements;
};

[[noreturn]] void refuse_layout(const Position& where, const std::string& names) {
    throw InputError(where, fmt::format("the list of effects cannot be edited as it is laid out "
                                        "here; write effects = [{}] in [model] by hand",
                                        names));
}

/// Text of a study's file, as bytes and parsed as TOML.
class StudyText {
  public:
    StudyText(std::string text, std::string file) : text_(std::move(text)), file_(std::move(file)) {
        split();
        root_ = parse_toml(file_, parsed_);
    }

    const std::string& text() const { return text_; }
    const std::string& file() const { return file_; }
    const toml::table& root() const { return root_; }

    /// Line end that the file uses; "\n" if it has one line.
    std::string line_break() const {
        const std::size_t at = text_.find_first_of("\r\n");
        if (at == std::string::npos) return "\n";
        return text_.compare(at, 2, "\r\n") == 0 ? "\r\n" : text_.substr(at, 1);
    }
    /// Index of the byte at a position that the parser reports.
    std::size_t offset(const toml::source_position& where) const {
        std::size_t at = line_starts_.at(where.line - 1);
        for (auto left = where.column - 1; left > 0 && at < text_.size(); --left)
            at = next_character(at);
        return at;
    }
    std::size_t line_begin(std::size_t at) const {
        return *std::prev(std::ranges::upper_bound(line_starts_, at));
    }
    /// Index of the byte after the text of the line that has this byte, before its line end.
    std::size_t line_end(std::size_t at) const {
        return std::min(text_.find_first_of("\r\n", at), text_.size());
    }
    /// Index of the first byte of the next line; the size of the text in the last line.
    std::size_t next_line(std::size_t at) const {
        const auto next = std::ranges::upper_bound(line_starts_, at);
        return next == line_starts_.end() ? text_.size() : *next;
    }
    bool blank(std::size_t begin, std::size_t end) const { return after_blanks(begin) >= end; }
    std::size_t after_blanks(std::size_t at) const {
        return std::min(text_.find_first_not_of(blanks, at), text_.size());
    }
    std::size_t before_blanks(std::size_t at) const {
        while (at > 0 && blanks.find(text_[at - 1]) != std::string_view::npos)
            --at;
        return at;
    }
    std::string indent(std::size_t at) const {
        const std::size_t begin = line_begin(at);
        return text_.substr(begin, after_blanks(begin) - begin);
    }

    /// Text after all edits; edits that begin at the same byte are applied in the given order.
    std::string edited(std::vector<Edit> edits) const {
        std::ranges::stable_sort(edits, {}, &Edit::begin);
        std::string result;
        std::size_t done = 0;
        for (const Edit& edit : edits) {
            result += text_.substr(done, edit.begin - done) + edit.text;
            done = edit.end;
        }
        return result + text_.substr(done);
    }

  private:
    std::size_t next_character(std::size_t at) const {
        do {
            ++at;  // over the bytes of one character of UTF-8
        } while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0) == 0x80);
        return at;
    }
    /// Splits the text into lines as `read_lines` does, so that positions agree with those in error
    /// messages of `read_study`.
    void split() {
        std::size_t begin = text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
        line_starts_ = {begin};
        while (begin < text_.size()) {
            const std::size_t end = line_end(begin);
            parsed_ += text_.substr(begin, end - begin) + "\n";
            if (end == text_.size()) break;
            begin = end + (text_.compare(end, 2, "\r\n") == 0 ? 2 : 1);
            line_starts_.push_back(begin);
        }
    }

    std::string text_, file_, parsed_;
    std::vector<std::size_t> line_starts_;
    toml::table root_;
};

/// List `effects` of [model] as parsed; null if there is none.
/// @throws InputError if [model] is no table or `effects` is no list of strings
const toml::array* list_node(const StudyText& study) {
    const toml::node* const model = study.root().get("model");
    if (!model) return nullptr;
    if (!model->is_table())
        throw InputError(position_in(study.file(), model->source().begin),
                         "'model': must be a table; write [model]");
    const toml::node* const effects = model->as_table()->get("effects");
    if (!effects) return nullptr;
    const toml::array* const list = effects->as_array();
    if (!list || !std::all_of(list->begin(), list->end(),
                              [](const toml::node& element) { return element.is_string(); }))
        throw InputError(position_in(study.file(), effects->source().begin),
                         "'effects': must be a list of names; write effects = [\"...\"]");
    return list;
}

std::vector<std::string> names_in(const toml::array* list) {
    std::vector<std::string> names;
    if (list)
        for (const toml::node& element : *list)
            names.push_back(*element.value<std::string>());
    return names;
}

/// Elements of a TOML list with these names: "a", "b".
std::string quoted_names(const std::vector<std::string>& names) {
    std::string result;
    for (const std::string& name : names)
        result += (result.empty() ? "" : ", ") + toml_string(name);
    return result;
}

/// Index of the byte after the string that begins at `begin`; empty for a string in triple quotes.
std::optional<std::size_t> string_end(const std::string& text, std::size_t begin) {
    const char quote = text[begin];
    if (text.compare(begin, 3, std::string(3, quote)) == 0) return std::nullopt;
    std::size_t at = begin + 1;
    while (at < text.size() && text[at] != quote)
        at += quote == '"' && text[at] == '\\' ? 2 : 1;
    return at + 1;
}

/// Finds the elements of a well-formed list whose opening bracket is at `open`; empty if the list
/// has a string in triple quotes.
std::optional<List> scan_list(const StudyText& study, std::size_t open) {
    const std::string& text = study.text();
    List list{open, open, {}};
    for (std::size_t at = open + 1; at < text.size();) {
        const char c = text[at];
        if (c == ']') {
            list.close = at;
            return list;
        }
        if (c == '#') {
            at = study.line_end(at);
        } else if (c == '"' || c == '\'') {
            const auto end = string_end(text, at);
            if (!end) return std::nullopt;
            list.elements.push_back({at, *end, {}});
            at = *end;
        } else {
            if (c == ',') list.elements.back().comma = at;
            ++at;
        }
    }
    return std::nullopt;
}

List read_list(const StudyText& study, const toml::array& node) {
    const auto list = scan_list(study, study.offset(node.source().begin));
    if (!list || list->elements.size() != node.size())
        refuse_layout(position_in(study.file(), node.source().begin),
                      quoted_names(names_in(&node)) + ", ...");
    return *list;
}

std::vector<Edit> add_to_empty(const StudyText& study, const List& list, const std::string& name) {
    const std::string element = fmt::format("\"{}\"", name);
    if (study.line_end(list.open) > list.close) {
        const bool tight = list.open + 1 == list.close;
        return {{list.open + 1, list.open + 1, (tight ? "" : " ") + element}};
    }
    const std::size_t last_line = study.line_begin(list.close);
    return {{last_line, last_line,
             study.indent(list.close) + "  " + element + "," + study.line_break()}};
}

/// Edits that add an element after the last element of a list, with the same quotes; on a line of
/// its own if the last element has a line of its own.
std::vector<Edit> add_to_list(const StudyText& study, const List& list, const std::string& name) {
    if (list.elements.empty()) return add_to_empty(study, list, name);
    const Element& last = list.elements.back();
    const char quote = study.text()[last.begin];
    const std::string element = fmt::format("{0}{1}{0}", quote, name);
    const std::size_t end = study.line_end(last.end);
    const bool own_line = study.blank(study.line_begin(last.begin), last.begin) && end < list.close;
    if (!own_line || last.comma > end) return {{last.end, last.end, ", " + element}};
    const std::string line = study.line_break() + study.indent(last.begin) + element;
    if (last.comma) return {{end, end, line + ","}};
    return {{last.end, last.end, ","}, {end, end, line}};
}

/// Edit that removes the whole line of an element; empty if the line has other elements or a
/// comment.
std::optional<Edit> line_of(const StudyText& study, const Element& element) {
    const std::size_t begin = study.line_begin(element.begin), end = study.line_end(element.end);
    if (element.comma && *element.comma > end) return std::nullopt;
    const std::size_t behind = element.comma ? *element.comma + 1 : element.end;
    if (!study.blank(begin, element.begin) || !study.blank(behind, end)) return std::nullopt;
    return Edit{begin, study.next_line(begin), ""};
}

/// Edits that remove an element with its comma from a list and keep all comments.
std::vector<Edit> remove_from_list(const StudyText& study, const List& list, std::size_t index) {
    const Element& element = list.elements[index];
    if (const auto line = line_of(study, element)) {
        const bool last = index > 0 && index + 1 == list.elements.size();
        if (!last || element.comma) return {*line};
        // A list that ended without a comma still does after the edit.
        const std::size_t comma = *list.elements[index - 1].comma;
        return {{comma, comma + 1, ""}, *line};
    }
    if (list.elements.size() == 1 && !element.comma) {
        // One blank before the element is removed too, since `add_to_empty` writes one.
        const bool blank_before = study.before_blanks(element.begin) < element.begin;
        return {{element.begin - (blank_before ? 1 : 0), element.end, ""}};
    }
    if (element.comma && !study.blank(element.end, *element.comma))
        return {{element.begin, element.end, ""}, {*element.comma, *element.comma + 1, ""}};
    if (element.comma) {
        const std::size_t end = study.after_blanks(*element.comma + 1);
        const bool last = end == list.close;
        return {{last ? study.before_blanks(element.begin) : element.begin, end, ""}};
    }
    if (index > 0 && study.blank(*list.elements[index - 1].comma + 1, element.begin))
        return {{*list.elements[index - 1].comma, element.end, ""}};
    return {{element.begin, study.after_blanks(element.end), ""}};
}

/// Value of a table that comes last in the text; null if the table is empty.
const toml::node* last_value(const toml::table& table) {
    const toml::node* last = nullptr;
    for (const auto& [key, value] : table)
        if (!last || value.source().begin > last->source().begin) last = &value;
    return last;
}

/// Edit that adds the key `effects` with one name to a table [model] without this key.
Edit new_key(const StudyText& study, const toml::table& model, const std::string& name) {
    const std::size_t begin = study.offset(model.source().begin);
    const toml::node* const last = last_value(model);
    const std::string list = fmt::format("effects = [\"{}\"]", name);
    if (model.is_inline()) {
        const std::size_t at = last ? study.offset(last->source().end) : begin + 1;
        const bool tight = study.text()[at] == '}' && !last;
        return {at, at, fmt::format("{} {}{}", last ? "," : "", list, tight ? " " : "")};
    }
    const bool dotted = study.text()[begin] != '[';  // model.base = ...
    const std::size_t line = last ? study.offset(last->source().end) : begin;
    const std::size_t at = study.line_end(line);
    return {at, at,
            study.line_break() + study.indent(last ? study.offset(last->source().begin) : begin) +
                (dotted ? "model." : "") + list};
}

/// Edit that adds a table [model] with one effect to the text of a study without this table.
Edit new_table(const StudyText& study, const std::string& name) {
    const std::string end = study.line_break();
    const std::string& text = study.text();
    const bool complete = text.empty() || text.ends_with('\n') || text.ends_with('\r');
    return {text.size(), text.size(),
            fmt::format("{0}{1}[model]{1}effects = [\"{2}\"]{1}", complete ? "" : end, end, name)};
}

/// Returns the edited text.
/// @throws InputError if its parsed content is not the study with exactly these names in the list
std::string checked(const StudyText& study, const std::vector<Edit>& edits,
                    const std::vector<std::string>& names) {
    toml::array list;
    for (const std::string& name : names)
        list.push_back(name);
    toml::table expected = study.root();
    if (!expected.contains("model")) expected.insert("model", toml::table());
    expected["model"].as_table()->insert_or_assign("effects", list);
    std::string text = study.edited(edits);
    try {
        if (StudyText(text, study.file()).root() == expected) return text;
    } catch (const InputError&) {  // the edit does not suit this layout
    }
    const toml::node* const model = study.root().get("model");
    refuse_layout(
        position_in(study.file(), model ? model->source().begin : toml::source_position{}),
        quoted_names(names));
}

}  // namespace

std::string with_effect(const std::string& text, const std::string& file, std::string_view name) {
    const StudyText study(text, file);
    const toml::array* const node = list_node(study);
    std::vector<std::string> names = names_in(node);
    if (std::ranges::find(names, name) != names.end())
        throw InputError(position_in(file, node->source().begin),
                         fmt::format("'effects' lists \"{}\" already", name));
    names.emplace_back(name);
    if (node)
        return checked(study, add_to_list(study, read_list(study, *node), names.back()), names);
    const toml::table* const model = study.root()["model"].as_table();
    return checked(study,
                   {model ? new_key(study, *model, names.back()) : new_table(study, names.back())},
                   names);
}

std::string without_effect(const std::string& text, const std::string& file,
                           std::string_view name) {
    const StudyText study(text, file);
    const toml::array* const node = list_node(study);
    std::vector<std::string> names = names_in(node);
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
        const Position where = node ? position_in(file, node->source().begin) : Position{file};
        throw InputError(where, names.empty()
                                    ? fmt::format("the study lists no effects, so \"{}\" cannot be "
                                                  "dropped",
                                                  name)
                                    : fmt::format("the study does not list the effect \"{}\"; {}",
                                                  name, did_you_mean(name, names)));
    }
    const auto index = static_cast<std::size_t>(found - names.begin());
    names.erase(found);
    return checked(study, remove_from_list(study, read_list(study, *node), index), names);
}

std::string toml_string(const std::string& text) {
    std::ostringstream written;
    written << toml::toml_formatter(toml::value(text), toml::format_flags::allow_unicode_strings);
    return written.str();
}

void replace_study(const std::filesystem::path& file, const std::string& text) {
    write_whole(file, text);
}

}  // namespace pendular
