#include <fmt/format.h>

#include "data/files/formats/layouts.h"
#include "data/files/formats/stacked_rows.h"

namespace pendular {

/// Table of numbers without a header; study.toml states names and units of the columns.
Layout headerless_layout() {
    return {
        "headerless", "rows of numbers without a header",
        [](const SourceLines& source) {
            char delimiter = ',';
            const Row row = headerless_first_row(source, delimiter);
            return row.cells.size() > 1 && all_numbers(row);
        },
        [](const SourceLines& source, const FileFormat& format, BlockFile& file) {
            const Row first = headerless_first_row(source, file.delimiter);
            if (first.cells.empty()) throw InputError({source.file}, "is empty");
            if (format.columns.size() != first.cells.size())
                throw InputError(
                    {source.file, first.line, 1},
                    fmt::format("has {} columns of numbers and no header; state names and units of "
                                "all columns in [[recording]], or of one file by --columns, like "
                                "columns = [\"Time [s]\", "
                                "\"Torque [mN m]\"]{}",
                                first.cells.size(),
                                format.columns.empty()
                                    ? ""
                                    : fmt::format(" ({} are stated)", format.columns.size())));
            read_stacked_rows(source, 0, stated_header(format, first.line), stated_columns(format),
                              file);
        }};
}

}  // namespace pendular
