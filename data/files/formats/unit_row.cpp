#include <fmt/format.h>

#include <algorithm>

#include "data/files/column_names.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/stacked_rows.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Whether a row holds units in brackets and no numbers.
bool is_unit_row(const Row& row) {
    int units = 0;
    for (const Cell& cell : row.cells) {
        if (cell.text.starts_with('[') && cell.text.ends_with(']'))
            ++units;
        else if (!cell.text.empty())
            return false;
    }
    return units > 0;
}

bool is_unit_row_table(const SourceLines& source) {
    const std::size_t header = first_filled_line(source, 0);
    const std::size_t next = first_filled_line(source, header + 1);
    if (next >= source.lines.size()) return false;
    const char delimiter = consistent_delimiter(source, next, source.lines.size());
    const Row names = source.row(header, delimiter);
    return is_unit_row(source.row(next, delimiter)) || counts_points(names.cells[0].text);
}

/// A line such as `Point [1]`, `Time [s]` that a user may paste to state units.
std::string suggested_columns(const std::vector<std::string>& names) {
    std::vector<std::string> cells;
    for (const std::string& name : names) {
        const std::string_view quantity = meaning_of_column(name, "").quantity;
        const char* const unit = quantity == "time"               ? "s"
                                 : quantity == "height"           ? "mm"
                                 : quantity == "normal_force"     ? "N"
                                 : quantity == "torque"           ? "mN m"
                                 : quantity == "rotational_speed" ? "1/min"
                                 : quantity == "angular_velocity" ? "rad/s"
                                 : quantity == "shear_rate"       ? "1/s"
                                 : quantity.ends_with("stress")   ? "Pa"
                                                                  : "1";
        cells.push_back(fmt::format("\"{} [{}]\"", name, unit));
    }
    return fmt::format("columns = [{}]", fmt::join(cells, ", "));
}

void read_unit_row_table(const SourceLines& source, const FileFormat& format, BlockFile& file) {
    const std::size_t first = first_filled_line(source, 0);
    if (first == source.lines.size()) throw InputError({source.file}, "is empty");
    std::size_t next = first_filled_line(source, first + 1);
    file.delimiter = consistent_delimiter(source, next, source.lines.size());
    const Row header = source.row(first, file.delimiter);
    std::vector<std::string> names, units;
    for (const Cell& cell : header.cells)
        names.push_back(cell.text);
    const Row second = source.row(std::min(next, source.lines.size() - 1), file.delimiter);
    if (is_unit_row(second)) {
        ++next;
        for (const Cell& cell : second.cells)
            units.push_back(bare_unit(cell.text));
    }
    if (!format.columns.empty()) {
        if (format.columns.size() != names.size())
            throw InputError(
                {source.file, header.line},
                fmt::format("the header has {} columns, 'columns' states {}; state all",
                            names.size(), format.columns.size()));
        const NamesAndUnits stated = stated_columns(format);
        names = stated.names;
        units = stated.units;
    }
    if (units.empty())
        throw InputError({source.file, header.line},
                         fmt::format("has names but no units; state them in [[recording]], or for "
                                     "one file by --columns, "
                                     "corrected where these guesses are wrong: {}",
                                     suggested_columns(names)));
    read_stacked_rows(source, next, header, {names, units}, file);
}

}  // namespace

/// Table with a row of names and a row of units in brackets, whose intervals are stacked: cells of
/// a RheoCompass table that were copied to a spreadsheet, for example.
Layout unit_row_layout() {
    return {"unit-row", "table with a row of units, intervals stacked", is_unit_row_table,
            read_unit_row_table};
}

}  // namespace pendular
