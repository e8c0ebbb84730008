#include "data/files/formats/layouts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "data/files/formats/clock_times.h"
#include "data/files/formats/cut_row.h"
#include "data/files/formats/labview.h"
#include "data/files/formats/missing_values.h"
#include "data/files/formats/named_columns.h"
#include "data/files/formats/preamble.h"
#include "data/files/formats/rejected_rows.h"
#include "data/files/formats/several_tables.h"
#include "data/files/formats/sheets.h"
#include "data/files/formats/text_marks.h"
#include "data/files/formats/text_shape.h"
#include "data/files/header_cell.h"
#include "data/files/markup.h"
#include "data/files/sheet_path.h"
#include "data/files/text_file.h"
#include "data/files/workbook.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

const Layout& layout_of(const SourceLines& source, const FileFormat& format) {
    const auto& all = layouts();
    const auto found = std::ranges::find_if(all, [&](const Layout& layout) {
        return format.layout.empty() ? layout.recognise(source) : layout.name == format.layout;
    });
    return found == all.end() ? all.back() : *found;
}

/// @throws InputError if the user states all columns of a layout that has names and units itself
void refuse_columns(const Layout& layout, const FileFormat& format, const std::string& file) {
    const bool takes =
        is_own_table(layout.name) || layout.name == "headerless" || layout.name == "transposed";
    if (format.columns.empty() || takes) return;
    throw InputError({file},
                     fmt::format("the layout \"{}\" has names and units of its own, so that "
                                 "'columns' cannot state all; name single ones as in {}, or "
                                 "leave 'columns' out",
                                 layout.name, line_to_name("torque", "M", "mN m")));
}

/// Calls a function with each cell of a sheet whose number is a text: that of a stored number has
/// no comma, and no zeros at its end.
template <typename Function>
void for_each_text(BlockFile& file, Function function) {
    for (Block& block : file.blocks)
        for (Row& row : block.table.rows)
            for (std::size_t i = 0; i < row.cells.size(); ++i)
                if (const std::string& text = row.cells[i].text;
                    text.find(',') != text.npos ||
                    (text.ends_with('0') && text.find('.') != text.npos &&
                     text.find_first_of("eE") == text.npos))
                    function(block.table, row, i);
}

/// Rewrites the texts of a sheet that are numbers with a decimal comma or thousands separators.
/// Numbers that the workbook stores as numbers say nothing of those in texts.
void unify_texts(BlockFile& file, const FileFormat& format) {
    NumberStyleFinder finder;
    bool any = false;
    for_each_text(file, [&](const Table& table, const Row& row, std::size_t cell) {
        finder.look_at(table, row, cell);
        any = true;
    });
    if (!any) return;
    const NumberStyle style = finder.style(format.decimal);
    for_each_text(file, [&](const Table&, Row& row, std::size_t cell) {
        row.cells[cell].text = rewritten(row.cells[cell].text, style);
    });
    file.numbers = {style.decimal, true};
}

/// Rewrites all numbers of a file with a decimal point.
void unify_numbers(BlockFile& file, const FileFormat& format) {
    if (as_sheet(file.file)) {
        unify_texts(file, format);
        return;
    }
    NumberStyleFinder finder(file.delimiter == ',');  // which is no decimal mark then
    for (const Block& block : file.blocks)
        finder.look_at(block.table);
    file.numbers = finder.style(format.decimal);
    for (Block& block : file.blocks)
        rewrite_numbers(block.table, file.numbers);
}

/// Numbers the intervals of a column that has names of them, such as "Preshear" and "Failure", by
/// their changes; the names become facts of the file. Returns whether the column has such names.
bool number_intervals(BlockFile& file, Block& block, std::size_t column) {
    constexpr std::size_t fewest_rows = 3;  // of an interval on average; else texts name the rows
    std::size_t changes = 1;
    const auto& rows = block.table.rows;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const std::string& text = rows[k].cells[column].text;
        if (text.empty() || parse_number(text)) return false;
        changes += k > 0 && text != rows[k - 1].cells[column].text;
    }
    if (rows.empty() || changes * fewest_rows > rows.size()) return false;
    std::string before;
    int number = 0;
    for (Row& row : block.table.rows) {
        std::string& text = row.cells[column].text;
        if (number == 0 || text != before)
            file.add_fact({interval_name_key(++number), text, row.line});
        before = text;
        text = std::to_string(number);
    }
    return true;
}

bool has_number(const Table& table, std::size_t column) {
    return std::ranges::any_of(table.rows, [&](const Row& row) {
        return parse_number(row.cells[column].text).has_value();
    });
}

/// Whether a column has no text but whole numbers.
bool has_whole_numbers(const Table& table, std::size_t column) {
    return std::ranges::all_of(table.rows, [&](const Row& row) {
        const std::string& text = row.cells[column].text;
        const auto number = parse_number(text);
        return text.empty() || (number && *number == std::floor(*number));
    });
}

/// Whether most numbers of a column are no whole ones, as "1.1, 1.2" for points of a step. In a
/// few rows they are faults.
bool has_mostly_fractions(const Table& table, std::size_t column) {
    const auto fractions = std::ranges::count_if(table.rows, [&](const Row& row) {
        const auto number = parse_number(row.cells[column].text);
        return number && *number != std::floor(*number);
    });
    constexpr std::ptrdiff_t few = 10;
    return std::ssize(table.rows) > few && 2 * fractions > std::ssize(table.rows);
}

/// Does not read columns called "Abschnitt" or the like as numbers of intervals if they hold other
/// texts: people use these words for names and lengths too.
void drop_other_intervals(BlockFile& file) {
    for (Block& block : file.blocks)
        for (std::size_t i = 0; i < block.columns.size(); ++i) {
            BlockColumn& column = block.columns[i];
            if (column.quantity != "interval" || number_intervals(file, block, i) ||
                (find_quantity(column.name) && has_number(block.table, i) &&
                 !has_mostly_fractions(block.table, i)) ||
                has_whole_numbers(block.table, i))
                continue;
            column.quantity.clear();
            block.table.header.cells[i].text = fmt::format("{}, column {}", column.name, i + 1);
        }
}

/// Text of a file.
struct FileText {
    DecodedText decoded;
    std::vector<Lines> hidden;
    std::vector<WideNumber> wide;
    std::vector<CellPlace> percents;  ///< as `SheetText::percents`
};

/// @throws InputError at a number in a cell that is merged over a column that is read
void refuse_wide_numbers(const BlockFile& file, const std::vector<WideNumber>& wide) {
    if (wide.empty()) return;
    const auto is_read = [&](const Block& block, const Row& row, const WideNumber& number) {
        for (std::size_t i = 0; i < block.columns.size() && i < row.cells.size(); ++i) {
            const int column = row.cells[i].column;
            if (!block.columns[i].quantity.empty() && column >= number.first_column &&
                column <= number.last_column)
                return true;
        }
        return false;
    };
    for (const Block& block : file.blocks)
        for (const Row& row : block.table.rows) {
            const auto first = std::ranges::lower_bound(wide, row.line, {}, &WideNumber::line);
            for (auto number = first; number != wide.end() && number->line == row.line; ++number)
                if (is_read(block, row, *number))
                    throw InputError({file.file, row.line, number->first_column},
                                     fmt::format("the number {} is merged over several columns; "
                                                 "divide the cell and write the number where it "
                                                 "belongs",
                                                 number->text));
        }
}

/// Whether the numbers of a column are per cent: by its own unit or, of errors without one, that of
/// their values.
bool is_in_percent(const Block& block, const BlockColumn& column) {
    const auto value = std::ranges::find_if(block.columns, [&](const BlockColumn& each) {
        return !each.of_errors && each.quantity == column.quantity;
    });
    const bool of_value = column.of_errors && column.unit.empty() && value != block.columns.end();
    const std::string& unit = of_value ? value->unit : column.unit;
    if (unit.empty() || !is_unit(unit)) return false;
    const Unit stated(unit);
    return stated.same_dimension(Unit("%")) && stated.to_si(1) == Unit("%").to_si(1);
}

/// Writes the numbers that cells of a workbook show as per cent, "30 %", as such into columns in
/// per cent. The workbook stores 0.3, which is right in columns without a unit.
void show_percents(BlockFile& file, const std::vector<CellPlace>& percents) {
    if (percents.empty()) return;
    const auto shows = [&](const Row& row, std::size_t i) {
        const CellPlace place{static_cast<std::size_t>(row.line) - 1,
                              static_cast<std::size_t>(row.cells[i].column) - 1};
        return std::ranges::binary_search(percents, place);
    };
    for (Block& block : file.blocks)
        for (std::size_t i = 0; i < block.columns.size(); ++i) {
            if (!is_in_percent(block, block.columns[i])) continue;
            for (Row& row : block.table.rows)
                if (const auto number = parse_number(row.cells[i].text); number && shows(row, i))
                    row.cells[i].text = fmt::format("{:.15g}", 100 * *number);
        }
}

/// @throws InputError for a table that Pendular wrote and that holds no measurement
void refuse_lists(const std::filesystem::path& path, std::string_view text) {
    const char* const from_file = "; name the file that it was made from";
    struct List {
        std::string_view begin;
        const char *what, *advice;
    };
    const List lists[] = {
        {"file,first_line,last_line,reason", "a list of rows that were left out", from_file},
        {"panel,curve,x,y", "the table of a figure", from_file},
        {"file,test,kind,points,preshear_stress", "a table of the results of yield loci",
         from_file},
        {"quantity,value,standard error,unit", "a table of the results of a study", from_file},
        {"friction,inertial_number,reduced_pressure,bridge_volume", "a table of predictions", ""},
        {"physics_version,friction", "a table of simulations",
         ": 'pendular runs import' reads it"}};
    for (const auto& [begin, what, advice] : lists)
        if (text.starts_with(begin))
            throw InputError(
                {path.string()},
                fmt::format("is {}, as Pendular writes it, and no measurement{}", what, advice));
}

FileText text_of_file(const std::filesystem::path& path, const FileFormat& format) {
    if (const auto part = as_sheet(path)) {
        const std::string bytes = read_bytes(part->book, largest_table);
        SheetText sheet = sheet_text(bytes, part->book.string(), part->sheet);
        FileText result{{std::move(sheet.text), "UTF-8, of a sheet of a workbook"},
                        {},
                        std::move(sheet.wide),
                        std::move(sheet.percents)};
        for (const auto& [first, last] : sheet.hidden)
            result.hidden.push_back({first, last});
        return result;
    }
    const std::string bytes = read_bytes(path, largest_table);
    DecodedText decoded = decode_bytes(bytes, path, format.encoding);
    refuse_markup(path, decoded.text);
    return {std::move(decoded), {}, {}, {}};
}

/// Reads a text with one table, or an export of an instrument.
void read_source(SourceLines source, const FileFormat& format, BlockFile& file) {
    if (is_own_table(layout_of(source, format).name)) take_preamble(source, file);
    const Layout& layout = layout_of(source, format);
    file.layout = layout.name;
    refuse_columns(layout, format, source.file);
    layout.read(source, format, file);
}

/// Reads one of several tables of a text, as a test of its own.
void read_part(const TablePart& part, const FileFormat& format, BlockFile& file) {
    BlockFile piece;
    piece.file = file.file;
    piece.counts = file.counts;
    read_source(part.source, format, piece);
    file.counts = piece.counts;
    file.layout = piece.layout;
    file.delimiter = piece.delimiter;
    for (Fact& fact : piece.facts)
        file.add_fact(std::move(fact));
    for (Block& block : piece.blocks) {
        block.test = part.title;
        file.blocks.push_back(std::move(block));
    }
    std::ranges::move(piece.skipped, std::back_inserter(file.skipped));
}

/// Rewrites a text of a form that the layouts do not read, unless it is of an instrument's layout.
TextShape shape(std::string& text, const std::filesystem::path& path, const FileFormat& format) {
    if (!format.layout.empty() && !is_own_table(format.layout)) return TextShape::delimited;
    join_quoted_lines(text);
    const auto recognised = [&]() -> std::string {
        try {
            return layout_of({path.string(), split_lines(text)}, format).name;
        } catch (const InputError&) {  // quotes between blanks
            return "plain";
        }
    };
    const std::string layout = recognised();
    return is_own_table(layout) || layout == "headerless" ? shape_text(text) : TextShape::delimited;
}

/// Reads the tables of a text into a file.
void read_tables(const SourceLines& source, const FileFormat& format, BlockFile& file) {
    SeveralTables tables;
    if (is_own_table(layout_of(source, format).name))
        tables = is_labview(source) ? labview_segments(source, file) : tables_in(source);
    if (tables.parts.empty()) {
        read_source(source, format, file);
        return;
    }
    for (const TablePart& part : tables.parts)
        read_part(part, format, file);
}

}  // namespace

bool is_own_table(std::string_view layout) {
    return layout == "plain" || layout == "unit-row";
}

const std::vector<Layout>& layouts() {
    static const std::vector<Layout> all = {tidy_layout(),
                                            rheocompass_layout(),
                                            rheoplus_layout(),
                                            trios_layout(),
                                            rspace_layout(),
                                            rheowin_layout(),
                                            yield_locus_report_layout(),
                                            transposed_layout(),
                                            unit_row_layout(),
                                            headerless_layout(),
                                            plain_layout()};
    return all;
}

std::vector<std::string> layout_names() {
    std::vector<std::string> names;
    for (const Layout& layout : layouts())
        names.push_back(layout.name);
    return names;
}

const std::vector<std::string>& interval_roles() {
    static const std::vector<std::string> roles = {"filling",   "preshear", "unloading", "failure",
                                                   "reloading", "steady",   "wall",      "other"};
    return roles;
}

BlockFile read_blocks(const std::filesystem::path& file_or_book, const FileFormat& format,
                      std::vector<ClearedCell>* cleared) {
    const std::filesystem::path path = as_sheet(file_or_book)
                                           ? file_or_book
                                           : chosen_sheets(file_or_book, format.sheet).read.front();
    FileText text = text_of_file(path, format);
    refuse_lists(path, text.decoded.text);
    const bool of_sheet = as_sheet(path).has_value();
    // A file that is cut may end within a number.
    const bool open_end =
        !of_sheet && !text.decoded.text.ends_with('\n') && !text.decoded.text.ends_with('\r');
    const TextShape shape_of_text =
        of_sheet ? TextShape::delimited : shape(text.decoded.text, path, format);
    BlockFile file;
    file.file = path.string();
    file.encoding = text.decoded.encoding;
    file.hidden = text.hidden;
    const std::vector<std::string_view> lines = split_lines(text.decoded.text);
    read_tables({file.file, lines, of_sheet}, format, file);
    if (shape_of_text == TextShape::blanks) file.delimiter = ' ';
    if (shape_of_text == TextShape::bars) file.delimiter = '|';
    use_named_columns(file, format);
    if (open_end) leave_out_cut_row(file, static_cast<int>(lines.size()));
    if (std::ranges::all_of(file.blocks, [](const Block& b) { return b.table.rows.empty(); }))
        throw InputError({file.file},
                         "no rows of numbers were found; is this the export of the raw data?");
    refuse_wide_numbers(file, text.wide);
    show_percents(file, text.percents);
    unify_numbers(file, format);
    read_clock_times(file);
    if (is_own_table(file.layout)) leave_out_rejected_rows(file);
    clear_missing_values(file, format, cleared);
    drop_other_intervals(file);
    return file;
}

std::string interval_name_key(int number) {
    return "name of interval " + std::to_string(number);
}

std::string stated_role(const Block& block, const FileFormat& format) {
    for (const auto& [role, intervals] : format.roles)
        for (const std::string& interval : intervals)
            if (interval == std::to_string(block.number) || interval == block.name ||
                interval == block.test)
                return role;
    return "";
}

}  // namespace pendular
