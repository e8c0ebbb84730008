#include "data/files/workbook.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zip.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <regex>
#include <vector>

#include "data/files/csv.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Parts of a workbook, which is a ZIP archive in memory.
class Archive {
  public:
    /// @throws InputError if the bytes are no archive
    Archive(const std::string& bytes, const std::string& file) : file_(file) {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* const source =
            zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
        if (source) archive_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
        if (source && !archive_) zip_source_free(source);
        const std::string reason = zip_error_strerror(&error);
        zip_error_fini(&error);
        if (!archive_) refuse(reason);
    }

    /// Content of a part; empty if there is none.
    /// @throws InputError if the parts read so far unpack to more than `largest_unpacked`
    std::string part(const std::string& name) {
        zip_stat_t status;
        zip_stat_init(&status);
        const zip_int64_t index = zip_name_locate(archive_.get(), name.c_str(), 0);
        if (index < 0 ||
            zip_stat_index(archive_.get(), static_cast<zip_uint64_t>(index), 0, &status) != 0)
            return "";
        // The stated size may be wrong: no more is read than this, and never more than the limit.
        if (status.size > largest_unpacked - unpacked_)
            throw InputError(
                {file_}, fmt::format("unpacks to more than {} MB; save the sheet as CSV, or leave "
                                     "out what is not needed",
                                     largest_unpacked >> 20));
        unpacked_ += status.size;
        const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> entry(
            zip_fopen_index(archive_.get(), static_cast<zip_uint64_t>(index), 0), zip_fclose);
        std::string content(static_cast<std::size_t>(status.size), '\0');
        const zip_int64_t got = entry ? zip_fread(entry.get(), content.data(), content.size()) : -1;
        if (got != static_cast<zip_int64_t>(content.size()))
            refuse(fmt::format("its part {} cannot be unpacked", name));
        return content;
    }

    [[noreturn]] void refuse(const std::string& reason) const {
        throw InputError({file_},
                         fmt::format("is no workbook that can be read ({}); save the sheet "
                                     "as CSV or as .xlsx and name that file",
                                     reason));
    }

  private:
    const std::string& file_;
    std::unique_ptr<zip_t, decltype(&zip_discard)> archive_{nullptr, zip_discard};
    std::uintmax_t unpacked_ = 0;
};

/// Largest number of tags of a part: each takes up to 64 bytes of memory.
constexpr std::ptrdiff_t most_tags = 30'000'000;

/// Parses XML. pugixml resolves no entities that a document declares.
/// @throws InputError if the text is no well-formed XML
void parse(const Archive& archive, const std::string& name, std::string& content,
           pugi::xml_document& document) {
    if (content.empty()) archive.refuse(fmt::format("it has no part {}", name));
    if (std::ranges::count(content, '<') > most_tags)
        archive.refuse(
            fmt::format("{} has more than {} million tags", name, most_tags / 1'000'000));
    const auto result = document.load_buffer_inplace(
        content.data(), content.size(), pugi::parse_default | pugi::parse_embed_pcdata);
    if (!result)
        archive.refuse(
            fmt::format("{} at byte {} of {}", result.description(), result.offset, name));
}

/// Name of an element or attribute without its namespace.
std::string_view local_name(const char* name) {
    const std::string_view whole = name;
    return whole.substr(whole.find(':') + 1);  // npos + 1 is 0
}

pugi::xml_node child(const pugi::xml_node& node, std::string_view name) {
    for (const pugi::xml_node& each : node.children())
        if (local_name(each.name()) == name) return each;
    return {};
}

/// Parts of a workbook that a part names: by identifier, and by the last word of their kinds, such
/// as "officeDocument" or "sharedStrings".
struct Relations {
    std::map<std::string, std::string> by_identifier, by_kind;
};

/// Relations of a part, "" for the archive as a whole. Names of parts have no leading slash.
Relations relations_of(Archive& archive, const std::filesystem::path& part) {
    const std::filesystem::path folder = part.parent_path();
    const std::string name = (folder / "_rels" / (part.filename().string() + ".rels")).string();
    std::string content = archive.part(name);
    Relations relations;
    if (content.empty()) return relations;
    pugi::xml_document document;
    parse(archive, name, content, document);
    for (const pugi::xml_node& each : document.document_element().children()) {
        const std::string target = each.attribute("Target").value(),
                          kind = each.attribute("Type").value();
        const std::filesystem::path whole =
            target.starts_with('/') ? std::filesystem::path(target.substr(1)) : folder / target;
        const std::string named = whole.lexically_normal().string();
        relations.by_identifier[each.attribute("Id").value()] = named;
        relations.by_kind[kind.substr(kind.rfind('/') + 1)] = named;
    }
    return relations;
}

/// Part with the sheet of a name, or with the first sheet, of the workbook in part `book`.
/// @throws InputError if there is none, naming the sheets
std::string part_of_sheet(Archive& archive, const std::string& book, const Relations& relations,
                          const std::string& file, const std::string& wanted) {
    std::string identifier;
    std::vector<std::string> names;
    pugi::xml_document workbook;
    std::string content = archive.part(book);
    parse(archive, book, content, workbook);
    for (const pugi::xml_node& each : child(workbook.document_element(), "sheets").children()) {
        if (local_name(each.name()) != "sheet") continue;
        names.emplace_back(each.attribute("name").value());
        if (!identifier.empty() || (!wanted.empty() && names.back() != wanted)) continue;
        for (const pugi::xml_attribute& attribute : each.attributes())
            if (std::string_view(attribute.name()).ends_with(":id")) identifier = attribute.value();
    }
    if (identifier.empty()) {
        throw InputError({file}, fmt::format("has no sheet \"{}\"; it has \"{}\"", wanted,
                                             fmt::join(names, "\", \"")));
    }
    const auto found = relations.by_identifier.find(identifier);
    if (found == relations.by_identifier.end())
        archive.refuse("it does not say which part holds the sheet");
    return found->second;
}

/// Text of a node `si` or `is`: of its child `t`, or of the runs `r`, without phonetic guides.
std::string text_of_item(const pugi::xml_node& item) {
    std::string text;
    for (const pugi::xml_node& each : item.children()) {
        const std::string_view name = local_name(each.name());
        if (name == "t") text += each.child_value();
        if (name == "r") text += child(each, "t").child_value();
    }
    return text;
}

std::vector<std::string> shared_strings(Archive& archive, const Relations& relations) {
    std::vector<std::string> strings;
    const auto found = relations.by_kind.find("sharedStrings");
    if (found == relations.by_kind.end()) return strings;
    std::string content = archive.part(found->second);
    pugi::xml_document document;
    parse(archive, found->second, content, document);
    for (const pugi::xml_node& item : document.document_element().children())
        if (local_name(item.name()) == "si") strings.push_back(text_of_item(item));
    return strings;
}

/// Column, from 0, of a reference such as "AB12"; `next` if there is none. Long references end
/// before the number overflows, far beyond the columns that are read.
std::size_t column_of(std::string_view reference, std::size_t next) {
    std::size_t column = 0;
    for (const char c : reference) {
        if (c < 'A' || c > 'Z' || column > 100'000) break;
        column = 26 * column + static_cast<std::size_t>(c - 'A') + 1;
    }
    return column == 0 ? next : column - 1;
}

/// Text with the escapes of ASCII characters, such as "_x000D_" for a carriage return, replaced.
std::string unescaped(const std::string& text) {
    static const std::regex escape("_x00([0-7][0-9A-Fa-f])_");
    std::string result;
    auto from = text.begin();
    for (std::sregex_iterator each(text.begin(), text.end(), escape), end; each != end; ++each) {
        result.append(from, text.begin() + each->position());
        result += static_cast<char>(std::stoi((*each)[1].str(), nullptr, 16));
        from = text.begin() + each->position() + each->length();
    }
    return result.append(from, text.end());
}

/// Whether a node is a cell with a value; blank cells may have a style alone.
bool has_value(const pugi::xml_node& node) {
    return local_name(node.name()) == "c" && (child(node, "v") || child(node, "is"));
}

/// Text of a cell, without tabs and line ends.
std::string text_of_cell(const pugi::xml_node& cell, const std::vector<std::string>& shared) {
    const std::string_view type = cell.attribute("t").value();
    std::string text = type == "inlineStr" ? text_of_item(child(cell, "is"))
                                           : std::string(child(cell, "v").child_value());
    if (type == "s") {
        const auto index = parse_number(text);
        const bool known = index && *index >= 0 && *index < static_cast<double>(shared.size());
        text = known ? shared[static_cast<std::size_t>(*index)] : "";
    }
    if (type == "e") text.clear();  // an error such as #DIV/0! is no value
    text = unescaped(text);
    for (char& c : text)
        if (c == '\t' || c == '\n' || c == '\r') c = ' ';
    text = trimmed(text);
    const std::string cell_text = csv_cell(text);  // delimiters and quotes within are none
    return cell_text.starts_with('#') ? '"' + cell_text + '"' : cell_text;  // no comment
}

/// Writes the rows of a sheet as lines.
class SheetWriter {
  public:
    SheetWriter(const std::string& file, const std::vector<std::string>& shared)
        : file_(file), shared_(shared) {}

    std::string text_of(const pugi::xml_node& data) {
        std::size_t width = 0;
        for (const pugi::xml_node& row : data.children())
            width = std::max(width, width_of(row));
        std::size_t cells = 0;
        for (const pugi::xml_node& row : data.children()) {
            if (local_name(row.name()) != "row") continue;
            const std::size_t number = row.attribute("r").as_uint(0);
            if (number > most_rows) refuse_rows(number);
            while (lines_ + 1 < number)
                add_line("");
            if (width_of(row) == 0) {
                add_line("");
                continue;
            }
            check_cell_count(cells += width, file_, static_cast<int>(lines_) + 1);
            add_row(row, width);
        }
        return std::move(text_);
    }

  private:
    static constexpr std::size_t most_rows = 1'048'576;  // 2^20, the limit of the format

    [[noreturn]] void refuse_rows(std::size_t number) const {
        throw InputError({file_},
                         fmt::format("row {}: a sheet has at most {} rows", number, most_rows));
    }

    std::size_t width_of(const pugi::xml_node& row) const {
        std::size_t next = 0, width = 0;
        for (const pugi::xml_node& cell : row.children()) {
            if (local_name(cell.name()) != "c") continue;
            next = column_of(cell.attribute("r").value(), next) + 1;
            if (has_value(cell)) width = next;
        }
        return width;
    }

    void add_line(std::string_view line) {
        text_ += line;
        text_ += '\n';
        ++lines_;
    }

    void add_row(const pugi::xml_node& row, std::size_t width) {
        std::size_t next = 0, written = 0;  // columns
        for (const pugi::xml_node& cell : row.children()) {
            if (local_name(cell.name()) != "c") continue;
            const std::size_t column = column_of(cell.attribute("r").value(), next);
            if (column < next)
                throw InputError({file_, static_cast<int>(lines_) + 1},
                                 "the cells of this row are not in order; save the workbook anew");
            next = column + 1;
            if (!has_value(cell)) continue;
            text_.append(column - written + (written > 0 ? 1 : 0), '\t');
            text_ += text_of_cell(cell, shared_);
            written = next;
        }
        text_.append(width - written, '\t');
        add_line("");
    }

    const std::string& file_;
    const std::vector<std::string>& shared_;
    std::string text_;
    std::size_t lines_ = 0;
};

}  // namespace

bool is_archive(std::string_view bytes) {
    return bytes.starts_with("PK\x03\x04");
}

std::string sheet_text(const std::string& bytes, const std::string& file,
                       const std::string& sheet) {
    Archive archive(bytes, file);
    const auto books = relations_of(archive, "").by_kind;
    const auto book = books.find("officeDocument");
    const std::string name = book == books.end() ? "xl/workbook.xml" : book->second;
    const Relations relations = relations_of(archive, name);
    const std::string part = part_of_sheet(archive, name, relations, file, sheet);
    const std::vector<std::string> shared = shared_strings(archive, relations);
    std::string content = archive.part(part);
    pugi::xml_document document;
    parse(archive, part, content, document);
    return SheetWriter(file, shared).text_of(child(document.document_element(), "sheetData"));
}

}  // namespace pendular
