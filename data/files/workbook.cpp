#include "data/files/workbook.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <utility>

#include "data/files/compound_file.h"
#include "data/files/sheet_path.h"
#include "data/files/xml_nodes.h"
#include "data/input_error.h"

namespace pendular {

void refuse_workbook(const std::string& file, const std::string& reason) {
    throw InputError({file}, fmt::format("is no workbook that can be read ({}); save the sheet as "
                                         "CSV or as .xlsx and name that file",
                                         reason));
}

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
        // The list of the parts stands at the end of an archive.
        const bool cut = zip_error_code_zip(&error) == ZIP_ER_NOZIP && bytes.starts_with("PK");
        const std::string reason = cut ? "its end is missing, as where a copy was interrupted"
                                       : zip_error_strerror(&error);
        zip_error_fini(&error);
        if (!archive_) refuse(reason);
    }

    /// Stated size of a part, unpacked [bytes]; 0 if there is none.
    std::uintmax_t size_of(const std::string& name) const {
        zip_stat_t status;
        zip_stat_init(&status);
        return zip_stat(archive_.get(), name.c_str(), 0, &status) == 0 ? status.size : 0;
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
        // libzip compares the checksum where it is asked for more than the part has.
        char further = 0;
        if (zip_fread(entry.get(), &further, 1) != 0)
            refuse(fmt::format("its part {} is damaged: its checksum is wrong", name));
        return content;
    }

    [[noreturn]] void refuse(const std::string& reason) const { refuse_workbook(file_, reason); }

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

/// Sheets of a workbook, in its order, with the identifiers of their parts; and whether dates count
/// from 1904.
struct Contents {
    struct Sheet {
        SheetName name;
        std::string identifier;
    };
    std::vector<Sheet> sheets;
    bool from_1904 = false;
};

Contents contents_of(Archive& archive, const std::string& book) {
    Contents contents;
    pugi::xml_document workbook;
    std::string content = archive.part(book);
    parse(archive, book, content, workbook);
    const pugi::xml_node root = workbook.document_element();
    for (const pugi::xml_node& each : child_named(root, "sheets").children()) {
        if (local_name(each.name()) != "sheet") continue;
        std::string identifier;
        for (const pugi::xml_attribute& attribute : each.attributes())
            if (std::string_view(attribute.name()).ends_with(":id")) identifier = attribute.value();
        const std::string_view state = each.attribute("state").value();
        contents.sheets.push_back(
            {{each.attribute("name").value(), state == "hidden" || state == "veryHidden"},
             identifier});
    }
    contents.from_1904 = child_named(root, "workbookPr").attribute("date1904").as_bool();
    return contents;
}

/// Name of the part with the workbook itself.
std::string part_of_book(Archive& archive) {
    const auto books = relations_of(archive, "").by_kind;
    const auto book = books.find("officeDocument");
    return book == books.end() ? "xl/workbook.xml" : book->second;
}

/// Returns the texts and the formats of cells that all sheets use.
SharedParts shared_parts(Archive& archive, const Relations& relations, bool from_1904) {
    SharedParts shared;
    const auto with_part = [&](const char* kind, const auto& take) {
        const auto found = relations.by_kind.find(kind);
        if (found == relations.by_kind.end()) return;
        std::string content = archive.part(found->second);
        pugi::xml_document document;
        parse(archive, found->second, content, document);
        take(document.document_element());
    };
    with_part("sharedStrings", [&](const pugi::xml_node& root) {
        for (const pugi::xml_node& item : root.children())
            if (local_name(item.name()) == "si") shared.strings.push_back(text_of_item(item));
    });
    with_part("styles",
              [&](const pugi::xml_node& root) { shared.formats = CellFormats(root, from_1904); });
    return shared;
}

}  // namespace

bool begins_workbook(std::string_view bytes) {
    return bytes.starts_with("PK\x03\x04") || is_compound_file(bytes);
}

namespace {

/// @throws InputError for a name of a sheet that `as_sheet` would not give back
void check_sheet_name(const std::string& name, const std::string& file) {
    if (!is_sheet_name(name))
        throw InputError({file}, fmt::format("has a sheet \"{}\", a name that spreadsheets do not "
                                             "allow; rename the sheet",
                                             name));
}

/// @param shared size of the texts that all sheets need [bytes]
/// @throws InputError for more sheets than can be read one by one
void check_sheet_work(const std::string& file, std::size_t sheets, std::uintmax_t shared) {
    constexpr std::size_t most_sheets = 1000;
    constexpr std::uintmax_t most_work = std::uintmax_t(1) << 30;  // some seconds
    if (sheets > most_sheets || sheets * shared > most_work)
        refuse_workbook(file, fmt::format("it has {} sheets with {} MB of texts, too many", sheets,
                                          shared >> 20));
}

/// Refuses archives of other programs by what they hold.
std::string refuse_other_archive(Archive& archive, const std::string& file, std::string book) {
    const auto refuse = [&](const char* kind, const char* advice) {
        throw InputError({file}, fmt::format("is {}, not a workbook (.xlsx); {}", kind, advice));
    };
    constexpr const char* save = "save it as .xlsx or CSV and name that file";
    constexpr std::size_t longest_name = 100;  // of a type; a long part is not unpacked for it
    if (archive.size_of("mimetype") < longest_name &&
        archive.part("mimetype").starts_with("application/vnd.oasis.opendocument"))
        refuse("an OpenDocument file (.ods)", save);
    if (book.ends_with(".bin")) refuse("a binary workbook (.xlsb)", save);
    if (book.starts_with("word/")) refuse("a Word document", "export the measurement as CSV");
    if (archive.size_of("Index/Document.iwa") > 0) refuse("a document of Numbers", save);
    if (archive.size_of(book) == 0) refuse("a ZIP archive", "unpack it and name the file within");
    return book;
}

/// An open workbook (.xlsx).
struct Book {
    Book(const std::string& bytes, const std::string& path)
        : file(path),
          archive(bytes, file),
          name(refuse_other_archive(archive, file, part_of_book(archive))),
          relations(relations_of(archive, name)),
          contents(contents_of(archive, name)) {}

    /// @throws InputError if there is no sheet, or for names as `check_sheet_name`
    void check_names() const {
        if (contents.sheets.empty()) archive.refuse("it has no sheet");
        for (const auto& [sheet, identifier] : contents.sheets)
            check_sheet_name(sheet.name, file);
    }

    void check_work(std::size_t sheets) const {
        const auto strings = relations.by_kind.find("sharedStrings");
        check_sheet_work(file, sheets,
                         strings == relations.by_kind.end() ? 0 : archive.size_of(strings->second));
    }

    SharedParts shared() { return shared_parts(archive, relations, contents.from_1904); }

    SheetText rows(const std::string& sheet, const std::string& identifier,
                   const SharedParts& shared) {
        const auto part = relations.by_identifier.find(identifier);
        if (part == relations.by_identifier.end())
            archive.refuse("it does not say which part holds the sheet");
        std::string content = archive.part(part->second);
        pugi::xml_document document;
        parse(archive, part->second, content, document);
        return rows_of_sheet(document.document_element(), path_of_sheet(file, sheet).string(),
                             shared);
    }

    const std::string& file;
    Archive archive;
    std::string name;  ///< of the part with the workbook itself
    Relations relations;
    Contents contents;
};

}  // namespace

std::vector<SheetName> sheet_names(const std::string& bytes, const std::string& file) {
    std::vector<SheetName> names;
    if (is_compound_file(bytes)) {
        names = OldWorkbook(bytes, file).sheets();
        for (const SheetName& sheet : names)
            check_sheet_name(sheet.name, file);
        return names;
    }
    const Book book(bytes, file);
    book.check_names();
    for (const auto& [name, identifier] : book.contents.sheets)
        names.push_back(name);
    return names;
}

void check_sheet_count(const std::string& bytes, const std::string& file, std::size_t sheets) {
    if (is_compound_file(bytes))
        check_sheet_work(file, sheets, OldWorkbook(bytes, file).work_of_sheet());
    else
        Book(bytes, file).check_work(sheets);
}

namespace {

std::size_t shown_among(const std::vector<SheetName>& sheets) {
    return static_cast<std::size_t>(std::ranges::count(sheets, false, &SheetName::hidden));
}

using TakeSheet = std::function<void(const std::string& name, const SheetText&)>;

void for_each_old_sheet(OldWorkbook&& book, const std::string& file, const TakeSheet& take) {
    const std::vector<SheetName>& sheets = book.sheets();
    check_sheet_work(file, shown_among(sheets), book.work_of_sheet());
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        check_sheet_name(sheets[k].name, file);
        if (!sheets[k].hidden) take(sheets[k].name, book.rows(k));
    }
}

}  // namespace

void for_each_shown_sheet(const std::string& bytes, const std::string& file,
                          const TakeSheet& take) {
    if (is_compound_file(bytes)) return for_each_old_sheet({bytes, file}, file, take);
    Book book(bytes, file);
    book.check_names();
    book.check_work(static_cast<std::size_t>(std::ranges::count_if(
        book.contents.sheets, [](const Contents::Sheet& each) { return !each.name.hidden; })));
    const SharedParts shared = book.shared();
    for (const auto& [name, identifier] : book.contents.sheets)
        if (!name.hidden) take(name.name, book.rows(name.name, identifier, shared));
}

SheetText sheet_text(const std::string& bytes, const std::string& file, const std::string& sheet) {
    const auto refuse = [&] { refuse_workbook(file, fmt::format("it has no sheet {}", sheet)); };
    if (is_compound_file(bytes)) {
        OldWorkbook book(bytes, file);
        const auto found = std::ranges::find(book.sheets(), sheet, &SheetName::name);
        if (found == book.sheets().end()) refuse();
        return book.rows(static_cast<std::size_t>(found - book.sheets().begin()));
    }
    Book book(bytes, file);
    const auto& sheets = book.contents.sheets;
    const auto found = std::ranges::find(
        sheets, sheet, [](const Contents::Sheet& each) { return each.name.name; });
    if (found == sheets.end()) refuse();
    return book.rows(sheet, found->identifier, book.shared());
}

}  // namespace pendular
