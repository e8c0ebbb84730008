#include "data/files/formats/named_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "data/files/column_names.h"
#include "data/files/header_cell.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

std::string with_unit_of_file(const BlockColumn& column) {
    return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

/// Mark of errors, such as "_sd", in the header of a column; only tables of one's own have any.
ErrorMark mark_of(const Block& block, std::size_t index) {
    return parse_header_cell(block.table.header.cells[index].text).mark;
}

/// Index of the column that a text means: with its unit or, if the text has the right one where the
/// file has none or a wrong one, by its name. Columns of errors are meant by their marks alone.
std::optional<std::size_t> column_meant(const Block& block, const std::string& text) {
    const HeaderCell wanted = parse_header_cell(text);
    std::optional<std::size_t> by_name;
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        const BlockColumn& column = block.columns[i];
        const ErrorMark mark = mark_of(block, i);
        if ((column.name != wanted.name || mark != wanted.mark) &&
            (column.name != text || mark != ErrorMark::none))
            continue;
        if (wanted.unit.empty() || column.unit == wanted.unit) return i;
        if (!by_name) by_name = i;
    }
    return by_name;
}

/// Header cell of a quantity with a mark such as "_sd".
std::string header_of(const std::string& quantity, std::string_view mark, const std::string& unit) {
    return unit.empty() ? fmt::format("{}{}", quantity, mark)
                        : fmt::format("{}{} [{}]", quantity, mark, unit);
}

void stop_using(Block& block, std::size_t index) {
    BlockColumn& column = block.columns[index];
    column.quantity.clear();
    block.table.header.cells[index].text = fmt::format("{}, column {}", column.name, index + 1);
}

/// Columns of a block that have to do with a quantity that another column is to be, by index.
struct Relatives {
    std::vector<std::size_t> values;      ///< that are the quantity so far
    std::vector<std::size_t> errors;      ///< of these, and numbers of values
    std::vector<std::size_t> own_errors;  ///< of the column that is to be the quantity
    std::vector<std::size_t> own_counts;  ///< numbers of values of that column
};

Relatives relatives_of(const Block& block, const std::string& quantity, std::size_t index) {
    Relatives found;
    const std::string& name = block.columns[index].name;
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        if (i == index) continue;
        const BlockColumn& column = block.columns[i];
        const bool marked = mark_of(block, i) != ErrorMark::none;
        if (marked && column.name == name)
            found.own_errors.push_back(i);
        else if (column.quantity == quantity)
            (marked ? found.errors : found.values).push_back(i);
        else if (column.quantity.empty() && column.name == name + "_n")
            found.own_counts.push_back(i);
        else if (column.quantity.empty() && column.name == quantity + "_n")
            found.errors.push_back(i);
    }
    return found;
}

/// @throws InputError if 'columns' states another unit than the file, so that the numbers would
///         change by a factor; a unit of the file that is none, or of another kind, is corrected
void refuse_other_unit(const Block& block, const BlockColumn& column, const std::string& stated) {
    if (column.unit == stated || !is_unit(column.unit) || !is_unit(stated)) return;
    const Unit own(column.unit), other(stated);
    // Units come from tables of floating-point factors.
    constexpr double equal = 1e-9;
    const double factor = (own.to_si(1) - own.to_si(0)) / (other.to_si(1) - other.to_si(0));
    if (!own.same_dimension(other) || std::abs(factor - 1) < equal) return;
    throw InputError(
        {block.table.file, block.table.header.line},
        fmt::format("column '{}' is in '{}' by the file, but in '{}' by 'columns', which differ by "
                    "a factor of {:.4g}: state the unit of the file there, or none; if that of the "
                    "file is wrong, state all columns as a list, columns = [\"name [unit]\", ...]",
                    column.name, column.unit, stated, std::max(factor, 1 / factor)));
}

/// Makes a column the quantity, in place of any other; its errors go with it. Errors that stand
/// without a value so far ("shear_stress_se") become its own where it has none.
void name_column(Block& block, const std::string& quantity, std::size_t index,
                 const std::string& text) {
    const HeaderCell wanted = parse_header_cell(text);
    const Relatives relatives = relatives_of(block, quantity, index);
    for (const std::size_t i : relatives.values)
        stop_using(block, i);
    if (!relatives.values.empty() || !relatives.own_errors.empty())
        for (const std::size_t i : relatives.errors)
            stop_using(block, i);
    for (const std::size_t i : relatives.own_errors) {
        BlockColumn& column = block.columns[i];
        column.quantity = quantity;
        block.table.header.cells[i].text =
            header_of(quantity, suffix_of(mark_of(block, i)), column.unit);
    }
    for (const std::size_t i : relatives.own_counts)
        block.table.header.cells[i].text = quantity + "_n";
    BlockColumn& column = block.columns[index];
    column.quantity = quantity;
    if (!wanted.unit.empty() && wanted.name == column.name) {
        refuse_other_unit(block, column, wanted.unit);
        column.unit = wanted.unit;
    }
    block.table.header.cells[index].text = header_of(quantity, "", column.unit);
}

/// Refuses units that are none, of columns whose names are those of quantities. A plain table may
/// have them: its header may be any text, and `Columns` refuses those that it reads.
/// @throws InputError at the header of the first
void refuse_unknown_units(const BlockFile& file) {
    if (file.layout == "plain") return;
    for (const Block& block : file.blocks)
        for (std::size_t i = 0; i < block.columns.size(); ++i) {
            const BlockColumn& column = block.columns[i];
            if (!column.quantity.empty() || column.unit.empty()) continue;
            const std::string_view quantity = meaning_of_column(column.name, "").quantity;
            if (quantity.empty()) continue;
            try {
                const Unit known(column.unit);
            } catch (const std::invalid_argument& error) {
                throw InputError(
                    {file.file, block.table.header.line, block.table.header.cells[i].column},
                    fmt::format("the unit of column '{}': {}; or state it in [[recording]], or for "
                                "one file by --columns, as in {}",
                                column.name, error.what(),
                                line_to_name(quantity, column.name, usual_unit(quantity))));
            }
        }
}

}  // namespace

void use_named_columns(BlockFile& file, const FileFormat& format) {
    for (const auto& [quantity, text] : format.named_columns) {
        bool found = false;
        for (Block& block : file.blocks) {
            const auto index = column_meant(block, text);
            if (!index) continue;
            name_column(block, quantity, *index, text);
            found = true;
        }
        if (found || file.blocks.empty()) continue;
        std::vector<std::string> names;
        for (const BlockColumn& column : file.blocks.front().columns)
            if (!column.name.empty()) names.push_back(with_unit_of_file(column));
        throw InputError({file.file, file.blocks.front().table.header.line},
                         fmt::format("no column is called '{}', as 'columns' states for '{}'; the "
                                     "columns are '{}'",
                                     text, quantity, fmt::join(names, "', '")));
    }
    refuse_unknown_units(file);
}

std::string line_to_name(std::string_view quantity, std::string_view name, std::string_view unit) {
    return fmt::format("columns = {{ {} = \"{} [{}]\" }}", quantity, name, unit);
}

}  // namespace pendular
