#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Arrangement of rows, headers and units in the files of an instrument or program.
struct Layout {
    std::string name;     ///< name that study.toml states: "rheocompass"
    std::string meaning;  ///< description in a few words
    bool (*recognise)(const SourceLines&);
    /// Reads delimiter, facts and blocks into `file`.
    /// @throws InputError at file:line:column for what the layout does not allow
    void (*read)(const SourceLines&, const FileFormat&, BlockFile& file);
};

/// All layouts, in the order in which `read_blocks` tries to recognise them.
const std::vector<Layout>& layouts();

/// Names of all layouts, for the key `layout` of study.toml.
std::vector<std::string> layout_names();

/// Names of the roles that an interval of a test may have.
const std::vector<std::string>& interval_roles();

/// Reads a file of measurements in any known layout. Layout, encoding, delimiter and decimal mark
/// are recognised by the content unless `format` states them.
/// @throws InputError if the file cannot be read, has no rows or no units, or as the layout throws
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
