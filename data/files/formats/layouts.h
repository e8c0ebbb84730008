#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Layout of the files of one instrument or program: arrangement of rows, headers and units.
struct Layout {
    std::string name;     ///< name of the layout in study.toml, such as "rheocompass"
    std::string meaning;  ///< description of the layout in a few words, for the user
    /// Function that returns whether the lines of a file have the layout.
    bool (*recognise)(const SourceLines&);
    /// Function that reads the delimiter, the header and the intervals of a file with the layout
    /// into `file`.
    /// @throws InputError at file:line:column for text that the layout does not allow
    void (*read)(const SourceLines&, const FileFormat&, BlockFile& file);
};

/// Returns all known layouts, in the order in which `read_blocks` tries to recognise them.
const std::vector<Layout>& layouts();

/// Returns the names of all known layouts, which are the values of the key `layout` in study.toml.
std::vector<std::string> layout_names();

/// Returns the names of the roles that an interval (step of constant set points) may have in a
/// test: "filling", "preshear", "unloading", "failure", "reloading", "steady" and "other".
const std::vector<std::string>& interval_roles();

/// Reads a file of measurements in any known layout. Layout, encoding, delimiter and decimal mark
/// are determined from the content of the file unless `format` states them.
/// @throws InputError if the file cannot be read, has no rows or no units, or has text that its
///         layout does not allow
BlockFile read_blocks(const std::filesystem::path& path, const FileFormat& format = {});

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
Layout plain_layout();

}  // namespace pendular
