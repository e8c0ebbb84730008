#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "data/files/formats/layouts.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

/// Line `key: value unit` of a report.
struct ReportLine {
    std::string key, number, unit;
    int line = 0;      ///< line of the file, from 1
    std::string text;  ///< everything behind the colon
};

/// Line with a decimal point; empty key for a line without a colon.
ReportLine report_line(std::string_view whole, int number) {
    ReportLine result{.line = number};
    const std::size_t colon = whole.find(':');
    if (colon == std::string_view::npos) return result;
    result.key = trimmed(whole.substr(0, colon));
    result.text = trimmed(whole.substr(colon + 1));
    const std::size_t blank = result.text.find(' ');
    result.number = result.text.substr(0, blank);
    std::ranges::replace(result.number, ',', '.');
    if (blank != std::string::npos) {
        const std::string rest{trimmed(std::string_view(result.text).substr(blank))};
        result.unit = rest.substr(0, rest.find(' '));
    }
    return result;
}

/// Numbers of a list such as "4;8;12".
std::vector<int> numbers_of(const std::string& text) {
    std::vector<int> numbers;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(';', from), text.size());
        numbers.push_back(count_of(text.substr(from, end - from)));
        from = end + 1;
    }
    return numbers;
}

/// Reads a report into a block for each preshear and for each point of failure, with one row each.
class ReportReader {
  public:
    ReportReader(const SourceLines& source, BlockFile& file) : source_(source), file_(file) {}

    void read() {
        for (std::size_t i = 0; i < source_.lines.size(); ++i) {
            const int line = static_cast<int>(i) + 1;
            if (trimmed(source_.lines[i]).starts_with("Preshear level")) {
                finish_level();
                in_level_ = true;
            }
            take(report_line(source_.lines[i], line));
        }
        finish_level();
        if (file_.blocks.empty())
            throw InputError({source_.file, 1},
                             "is a report on a yield locus without any level of preshear; export "
                             "the interval data of the same test and name that file");
    }

  private:
    void take(const ReportLine& line) {
        const auto is = [&](const char* begin) { return line.key.starts_with(begin); };
        if (is("Input data")) test_ = line.text.substr(0, line.text.find(", <"));
        if (is("Found preshear")) preshears_ = numbers_of(line.text);
        if (is("Found shear-to-failure")) failures_ = numbers_of(line.text);
        if (!in_level_) return;
        if (is("Preshear normal stress")) normal_ = line;
        if (is("Preshear stress")) shear_ = line;
        if (is("Shear-to-failure normal stress")) points_.push_back({line, {}});
        if (is("Yield shear stress") && !points_.empty()) points_.back().second = line;
        if (is("Sample height for bulk")) height_ = line;
        if (is("Bulk solid density")) density_ = line;
    }

    void finish_level() {
        if (in_level_ && !normal_.key.empty() && !shear_.key.empty()) {
            Block block = block_of(normal_, shear_, "preshear", preshears_);
            try {
                if (!density_.key.empty())
                    block.bulk_density =
                        quantity_in_si(density_.number + " " + density_.unit, Unit("kg/m^3"));
            } catch (const std::invalid_argument& error) {
                throw InputError({source_.file, density_.line}, error.what());
            }
            file_.blocks.push_back(std::move(block));
        }
        for (const auto& [normal, shear] : points_) {
            if (!shear.key.empty())
                file_.blocks.push_back(block_of(normal, shear, "failure", failures_));
            ++point_;
        }
        in_level_ = false;
        normal_ = shear_ = height_ = density_ = {};
        points_.clear();
    }

    /// Block with one row, of the level's preshear or of the point of failure `point_`.
    Block block_of(const ReportLine& normal, const ReportLine& shear, const char* role,
                   const std::vector<int>& numbers) {
        Block block;
        block.test = test_;
        block.stated_role = role;
        block.number = point_ < numbers.size() ? numbers[point_] : 0;
        block.table.file = source_.file;
        std::vector<std::string> names = {"Normal stress", "Shear stress"},
                                 units = {normal.unit, shear.unit};
        Row header{normal.line, {}}, row{normal.line, {{normal.number, 1}, {shear.number, 1}}};
        if (!height_.key.empty()) {
            names.emplace_back("Gap");
            units.push_back(height_.unit);
            row.cells.push_back({height_.number, 1});
        }
        for (const std::string& name : names)
            header.cells.push_back({name, 1});
        set_columns(file_, block, header, names, units);
        add_row(file_, block, std::move(row));
        return block;
    }

    const SourceLines& source_;
    BlockFile& file_;
    std::string test_;
    std::vector<int> preshears_, failures_;  ///< numbers of the intervals, one for each point
    std::size_t point_ = 0;                  ///< number of points of the levels before
    bool in_level_ = false;
    ReportLine normal_, shear_, height_, density_;
    std::vector<std::pair<ReportLine, ReportLine>> points_;  ///< normal stress, shear stress
};

}  // namespace

/// Report of RheoCompass on a yield locus: for each level of preshear its stresses, the points of
/// failure, the height of the sample and its bulk density. It holds results, not recorded rows.
Layout yield_locus_report_layout() {
    return {"yield-locus-report", "RheoCompass report on a yield locus",
            [](const SourceLines& source) {
                for (std::size_t i = 0; i < source.lines.size() && i < 5; ++i)
                    if (source.lines[i].starts_with("Yield locus function")) return true;
                return false;
            },
            [](const SourceLines& source, const FileFormat&, BlockFile& file) {
                ReportReader(source, file).read();
            }};
}

}  // namespace pendular
