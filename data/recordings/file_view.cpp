#include "data/recordings/file_view.h"

#include <algorithm>

#include "data/files/columns.h"

namespace pendular {
namespace {

/// Quantities of steady shear that no interval of a file has.
std::vector<std::string> missing_quantities(const std::vector<IntervalSeries>& series) {
    const auto has = [&](const char* name) {
        return std::ranges::any_of(
            series, [&](const IntervalSeries& each) { return !each.column(name).empty(); });
    };
    std::vector<std::string> missing;
    if (!has("time")) missing.emplace_back("time");
    if (!has("torque") && !has("shear_stress")) missing.emplace_back("torque or shear stress");
    if (!has("normal_force") && !has("normal_stress"))
        missing.emplace_back("normal force or normal stress");
    if (!has("height")) missing.emplace_back("gap");
    if (!has("angular_velocity")) missing.emplace_back("speed of the lid");
    return missing;
}

/// Divides a table with a column of intervals into one block per interval.
void split_by_interval(BlockFile& file) {
    if (file.blocks.size() != 1) return;
    const Block whole = std::move(file.blocks.front());
    const Columns columns(whole.table);
    if (!columns.has("interval")) {
        file.blocks.front() = whole;
        return;
    }
    file.blocks.clear();
    double number = 0;
    for (const Row& row : whole.table.rows) {
        const double own = columns.value(row, "interval");
        if (file.blocks.empty() || own != number) {
            count_interval(file, row.line, whole.columns.size());
            Block& block = file.blocks.emplace_back();
            block.number = static_cast<int>(std::clamp(own, 0.0, 1e9));
            block.columns = whole.columns;
            block.table.file = whole.table.file;
            block.table.delimiter = whole.table.delimiter;
            block.table.header = whole.table.header;
        }
        file.blocks.back().table.rows.push_back(row);
        number = own;
    }
}

}  // namespace

FileView view_of_file(const std::filesystem::path& path, const FileFormat& format,
                      const std::optional<AnnularCell>& study_cell) {
    FileView view;
    view.file = read_blocks(path, format);
    split_by_interval(view.file);
    for (const Block& block : view.file.blocks)
        view.series.push_back(series_of(block));
    view.roles = roles_of(view.file, view.series, format);
    view.cell = cell_from_columns(view.series);
    view.findings = check_file(view.file, view.series, view.cell);
    view.stated = stated_cell(view.file);
    if (study_cell) append(view.findings, header_against_study(view.file, *study_cell));
    view.loci = yield_loci(view.file, view.series, view.roles);
    view.missing = missing_quantities(view.series);
    return view;
}

}  // namespace pendular
