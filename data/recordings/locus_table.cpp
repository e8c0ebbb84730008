#include "data/recordings/locus_table.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include "data/files/csv.h"

namespace pendular {
namespace {

constexpr double degree = 180 / std::numbers::pi;

std::string cell_or_none(const std::optional<double>& value, double scale = 1) {
    return value && std::isfinite(*value) ? fmt::format("{:.6g}", scale * *value) : "";
}

/// Value and standard error of a result, which 0 leaves out.
void add_result(std::string& row, const std::optional<double>& value, double error,
                double scale = 1) {
    row += "," + cell_or_none(value, scale) + "," +
           (error > 0 && value ? cell_or_none(error, scale) : "");
}

std::string begin_of_row(const FileView& view, const std::string& test, const char* kind,
                         std::size_t points) {
    return fmt::format("{},{},{},{}",
                       csv_text_cell(std::filesystem::path(view.file.file).filename().string()),
                       csv_text_cell(test), kind, points);
}

std::string row_of_locus(const FileView& view, const YieldLocus& locus) {
    const LinearYieldLocus& line = *locus.line;
    const LocusErrors errors = line.errors.value_or(LocusErrors{});
    std::string row =
        begin_of_row(view, locus.test, locus.prorated ? "yield locus, prorated" : "yield locus",
                     locus.points.size());
    const auto of_preshear = [&](auto&& value) {
        return locus.preshear ? std::optional<double>(value(*locus.preshear)) : std::nullopt;
    };
    row += "," + cell_or_none(of_preshear([](const auto& p) { return p.normal_stress; }));
    add_result(row, of_preshear([](const auto& p) { return p.shear_stress; }),
               locus.preshear ? locus.preshear->shear_stress_error.value_or(0) : 0);
    row += "," + (locus.preshear ? cell_or_none(locus.preshear->bulk_density) : "");
    add_result(row, line.cohesion, errors.cohesion);
    add_result(row, line.slope_angle, errors.slope_angle, degree);
    add_result(row, line.tensile_strength, errors.tensile_strength);
    add_result(row, line.unconfined_strength, errors.unconfined_strength);
    add_result(row, line.major_principal_stress, errors.major_principal_stress);
    add_result(row, line.effective_angle, errors.effective_angle, degree);
    add_result(row, line.flowability, errors.flowability);
    return row + fmt::format(",{},,,,", line.flow_class) + "\n";
}

std::string row_of_wall(const FileView& view, const WallLocus& wall) {
    const WallErrors errors = wall.errors.value_or(WallErrors{});
    const WallLine line = wall.line();
    std::string row = begin_of_row(view, wall.test, "wall yield locus", wall.points.size());
    row += std::string(19, ',');  // what grains along grains have
    const double spread = 1 + line.slope * line.slope;
    add_result(row, std::atan(line.slope), line.slope_error / spread, degree);
    add_result(row, wall.adhesion, errors.adhesion);
    return row + "\n";
}

}  // namespace

std::string locus_table(const std::vector<FileView>& views) {
    std::string text =
        std::string(locus_table_begin) +
        ",preshear_stress [Pa],preshear_shear_stress [Pa],preshear_shear_stress_se [Pa],"
        "preshear_bulk_density [kg/m^3],cohesion [Pa],cohesion_se [Pa],slope_angle [deg],"
        "slope_angle_se [deg],tensile_strength [Pa],tensile_strength_se [Pa],"
        "unconfined_strength [Pa],unconfined_strength_se [Pa],major_principal_stress [Pa],"
        "major_principal_stress_se [Pa],effective_angle [deg],effective_angle_se [deg],"
        "flowability [1],flowability_se [1],flow_class,wall_angle [deg],wall_angle_se [deg],"
        "adhesion [Pa],adhesion_se [Pa]\n";
    for (const FileView& view : views) {
        for (const YieldLocus& locus : view.loci)
            if (locus.line) text += row_of_locus(view, locus);
        for (const WallLocus& wall : view.walls)
            text += row_of_wall(view, wall);
    }
    return text;
}

}  // namespace pendular
