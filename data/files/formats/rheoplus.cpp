#include <algorithm>

#include "data/files/column_names.h"
#include "data/files/formats/layouts.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Text of a line before its first tab or semicolon, without blanks and colon.
std::string key_of_line(std::string_view line) {
    std::string_view key = trimmed(line.substr(0, line.find_first_of("\t;")));
    if (key.ends_with(':')) key.remove_suffix(1);
    return std::string(key);
}

bool begins_series(std::string_view line) {
    return line.starts_with("Data Series Information") || line.starts_with("Messreihen-Info") ||
           line.starts_with("Information sur la s");
}

/// Reads a Rheoplus export from its first to its last line.
class RheoplusReader {
  public:
    RheoplusReader(const SourceLines& source, BlockFile& file) : source_(source), file_(file) {}

    void read() {
        file_.delimiter = delimiter();
        for (line_ = 0; line_ < source_.lines.size();) {
            const std::string_view line = source_.lines[line_];
            if (begins_series(line)) {
                name_.clear();
                interval_ = 0;
                declared_.reset();
            }
            counts_points(key_of_line(line)) ? read_block() : read_fact();
        }
    }

  private:
    char delimiter() const {
        for (std::size_t i = 0; i < source_.lines.size(); ++i)
            if (counts_points(key_of_line(source_.lines[i])))
                return consistent_delimiter(source_, i, source_.lines.size());
        return '\t';
    }

    void read_fact() {
        std::string key = key_of_line(source_.lines[line_]), value;
        for (const Cell& cell : source_.row(line_, file_.delimiter).cells)
            if (value.empty() && key_of_line(cell.text) != key) value = cell.text;
        ++line_;
        if (key.empty() || value.empty()) return;
        if (key == "Name") name_ = value;
        if (key == "Interval" || key == "Abschnitt" || key == "Intervalle")
            interval_ = count_of(value);
        if (key == "Number of Data Points" || key == "Anzahl Messpunkte" ||
            key == "Nombre de points de mesure")
            if (const int rows = count_of(value)) declared_ = static_cast<std::size_t>(rows);
        file_.add_fact({key, value, static_cast<int>(line_)});
    }

    void read_block() {
        Block block;
        block.test = name_;
        block.number = interval_;
        block.declared_rows = declared_;
        block.table.file = source_.file;
        block.table.delimiter = file_.delimiter;
        const Row header = source_.row(line_++, file_.delimiter);
        std::vector<std::string> names, units;
        for (const Cell& cell : header.cells)
            names.push_back(cell.text);
        if (line_ < source_.lines.size())
            for (const Cell& cell : source_.row(line_++, file_.delimiter).cells)
                units.push_back(bare_unit(cell.text));
        set_columns(file_, block, header, names, units);
        for (; line_ < source_.lines.size(); ++line_) {
            const Row row = source_.row(line_, file_.delimiter);
            if (is_blank(row)) break;
            add_row(file_, block, row);
        }
        file_.blocks.push_back(std::move(block));
    }

    const SourceLines& source_;
    BlockFile& file_;
    std::size_t line_ = 0;
    std::string name_;
    int interval_ = 0;
    std::optional<std::size_t> declared_;
};

}  // namespace

/// Export of Anton Paar's Rheoplus: series of keys and values, each followed by a table whose first
/// column counts the points, with a row of units.
Layout rheoplus_layout() {
    return {
        "rheoplus", "Anton Paar Rheoplus export",
        [](const SourceLines& source) { return std::ranges::any_of(source.lines, begins_series); },
        [](const SourceLines& source, const FileFormat&, BlockFile& file) {
            RheoplusReader(source, file).read();
        }};
}

}  // namespace pendular
