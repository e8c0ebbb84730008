#include "data/recordings/measurements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "data/files/csv.h"
#include "data/files/write_whole.h"
#include "data/quantities/quantity.h"
#include "data/remarks/wording.h"

namespace pendular {
namespace {

/// Shortest text that reads back as the same number; empty for 0, which marks unknown values.
std::string known(double value) {
    return value == 0 ? "" : fmt::format("{}", value);
}

std::string header(std::string_view name, std::string_view suffix = "") {
    return fmt::format("{}{} [{}]", name, suffix, quantity(name).unit);
}

std::string file_from(const std::filesystem::path& written, const std::string& file) {
    const std::filesystem::path folder = written.has_parent_path() ? written.parent_path() : ".";
    return csv_text_cell(std::filesystem::proximate(file, folder).string());
}

/// Numbers of the fillings whose readings share an error, from 1, by `SharedError::source`: 2 k and
/// 2 k + 1 are of one filling.
class Fillings {
  public:
    explicit Fillings(const std::vector<Reading>& readings) {
        for (const Reading& reading : readings)
            for (const SharedError& error : reading.shared)
                if (!error.of_rounding) numbers_.try_emplace(error.source / 2, numbers_.size() + 1);
    }
    bool any() const { return !numbers_.empty(); }
    std::vector<std::string> cells_of(const Reading& reading) const {
        const Eigen::Vector2d variance = reading.filling_variance();
        const auto of_filling = std::ranges::find(reading.shared, false, &SharedError::of_rounding);
        return {of_filling == reading.shared.end()
                    ? ""
                    : fmt::format("{}", numbers_.at(of_filling->source / 2)),
                known(std::sqrt(variance(0))), known(std::sqrt(variance(1)))};
    }

  private:
    std::map<std::size_t, std::size_t> numbers_;
};

std::string reading_row(const Reading& reading, const std::filesystem::path& path,
                        const Fillings& fillings, bool with_failure, bool with_creep) {
    const double stress_error = std::sqrt(reading.covariance(0, 0));
    const double fraction_error = std::sqrt(reading.covariance(1, 1));
    const double errors = stress_error * fraction_error;
    std::vector<std::string> cells = {fmt::format("{}", reading.condition.normal_stress),
                                      fmt::format("{}", reading.value(0)),
                                      known(stress_error),
                                      fmt::format("{}", reading.value(1)),
                                      known(fraction_error),
                                      known(errors > 0 ? reading.covariance(0, 1) / errors : 0),
                                      known(reading.shear_rate),
                                      fmt::format("{}", reading.condition.inertial_number),
                                      fmt::format("{}", reading.condition.liquid_content),
                                      known(reading.condition.height.value_or(0)),
                                      known(reading.sampled_seconds),
                                      fmt::format("{}", reading.replicates),
                                      fmt::format("{}", reading.error_assumed ? 1 : 0),
                                      file_from(path, reading.origin.file),
                                      fmt::format("{}", reading.origin.line),
                                      known(reading.step),
                                      known(reading.condition.time),
                                      known(reading.condition.bead_volume.value_or(0))};
    if (fillings.any()) {
        for (std::string& cell : fillings.cells_of(reading))
            cells.push_back(std::move(cell));
    }
    if (with_failure) {
        cells.emplace_back(reading.condition.at_failure ? "1" : "0");
        cells.push_back(known(reading.condition.preshear_stress.value_or(0)));
    }
    if (with_creep) cells.push_back(known(reading.condition.gap_creep));
    return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace

void write_readings(const std::filesystem::path& path, const Measurements& measurements) {
    std::vector<std::string> headers = {header("normal_stress"),
                                        header("shear_stress"),
                                        header("shear_stress", "_sd"),
                                        header("solid_fraction"),
                                        header("solid_fraction", "_sd"),
                                        header("error_correlation"),
                                        header("shear_rate"),
                                        header("inertial_number"),
                                        header("liquid_content"),
                                        header("height"),
                                        header("sampled_seconds"),
                                        header("replicates"),
                                        header("error_assumed"),
                                        "file",
                                        header("line"),
                                        header("interval"),
                                        header("time"),
                                        header("bead_volume")};
    const Fillings fillings(measurements.readings);
    if (fillings.any()) {
        for (const char* name : {"filling", "shear_stress_of_filling", "solid_fraction_of_filling"})
            headers.push_back(header(name));
    }
    const bool with_failure = std::ranges::any_of(
        measurements.readings, [](const Reading& reading) { return reading.condition.at_failure; });
    if (with_failure) {
        headers.push_back(header("failure"));
        headers.push_back(header("preshear_stress"));
    }
    const bool with_creep = std::ranges::any_of(measurements.readings, &Reading::fraction_unknown);
    if (with_creep) headers.push_back(header("gap_creep"));
    std::string text = fmt::format("{}\n", fmt::join(headers, ","));
    for (const Reading& reading : measurements.readings)
        text += reading_row(reading, path, fillings, with_failure, with_creep);
    write_whole(path, text);
}

void write_excluded(const std::filesystem::path& path, const Measurements& measurements) {
    std::string text = "file,first_line,last_line,reason\n";
    for (const Remark& each : measurements.left_out())
        text += fmt::format("{},{},{},{}\n", file_from(path, each.file()), each.first_line(),
                            each.last_line(), csv_text_cell(text_of(each)));
    write_whole(path, text);
}

}  // namespace pendular
