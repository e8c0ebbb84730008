#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Layout of the files of one instrument or program: arrangement of rows, headers and units.
struct Layout {
    std::string name;     ///< in study.toml, such as "rheocompass"
    std::string meaning;  ///< description in a few words, for the user
    bool (*recognise)(const SourceLines&);
    /// Reads delimiter, facts and intervals into `file`.
    /// @throws InputError for text that the layout does not allow
    void (*read)(const SourceLines&, const FileFormat&, BlockFile& file);
};

/// Returns all layouts, in the order in which `read_blocks` tries to recognise them. The last,
/// plain, recognises every file.
const std::vector<Layout>& layouts();

/// Whether a layout is that of a table that people write, with one line of names, and not that of
/// an instrument.
bool is_own_table(std::string_view layout);

/// Returns the names of all layouts: values of the key `layout` in study.toml.
std::vector<std::string> layout_names();

/// Returns the roles that an interval may have in a test: "filling", "preshear", "unloading",
/// "failure", "reloading", "steady", "wall" and "other".
const std::vector<std::string>& interval_roles();

/// Reads a file of measurements in any known layout. Layout, encoding, delimiter and decimal mark
/// are determined from the content of the file unless `format` states them. Of a workbook, the
/// first sheet of `chosen_sheets` is read.
/// @param path of a file, or of a sheet of a workbook (`SheetPath`)
/// @param cleared list to which the cells that `clear_missing_values` clears are added; null: none
/// @throws InputError if the file cannot be read, has no rows or no units, or has text that its
///         layout does not allow
BlockFile read_blocks(const std::filesystem::path& path, const FileFormat& format = {},
                      std::vector<ClearedCell>* cleared = nullptr);

// The layouts, one file each.
Layout rheocompass_layout();
Layout rheoplus_layout();
Layout trios_layout();
Layout rspace_layout();
Layout rheowin_layout();
Layout yield_locus_report_layout();
Layout unit_row_layout();
Layout transposed_layout();
Layout headerless_layout();
Layout tidy_layout();
Layout plain_layout();

/// First characters of a table that `import --tidy` wrote. By them it is recognised when it is
/// read, and before a new one replaces it.
constexpr const char* tidy_table_begin = "test,interval,role,line";

/// Key of the fact with the name of an interval that a column of a table names.
std::string interval_name_key(int number);

/// Returns the role that the user states for an interval by its number, its name or the name of its
/// test; empty if there is none.
std::string stated_role(const Block& block, const FileFormat& format);

}  // namespace pendular
