#include "data/recordings/repair.h"

#include <fmt/format.h>

#include <cmath>

#include "data/recordings/file_checks.h"

namespace pendular {
namespace {

constexpr double repair_tolerance = 0.05;

/// Power of ten by which a torque differs from the torque of the stress; 0 if they agree, empty if
/// they differ otherwise or if one of them is zero or unknown.
std::optional<int> lost_power(double torque, double torque_of_stress) {
    const double factor = std::abs(torque / torque_of_stress);
    if (!(factor > 0) || std::isinf(factor)) return std::nullopt;
    const double power = std::round(std::log10(factor));
    if (std::abs(factor / std::pow(10, power) - 1) > repair_tolerance) return std::nullopt;
    return static_cast<int>(power);
}

}  // namespace

void repair_torques(Recording& recording, const AnnularCell& cell, Measurements& result) {
    if (recording.shear_stress.size() != recording.size()) return;
    std::vector<std::pair<std::size_t, double>> damaged;
    std::size_t agreeing = 0;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const double of_stress = torque(recording.shear_stress[i], cell);
        const auto power = lost_power(recording.torque[i], of_stress);
        if (power == 0) ++agreeing;
        if (power && *power != 0)
            damaged.emplace_back(i, std::copysign(of_stress, recording.torque[i]));
    }
    if (damaged.empty() || agreeing == 0) return;
    std::vector<std::pair<int, int>> lines;
    for (const auto& [row, value] : damaged) {
        recording.torque[row] = value;
        add_line(lines, recording.line[row]);
    }
    Doubt doubt;
    doubt.what = fmt::format(
        "{}: in {} of {} rows the torque differs from the shear stress by a power of ten; repaired "
        "from the shear stress, as repair = true asks for: lines {}.",
        recording.file, damaged.size(), recording.size(), text_of_lines(lines, 20));
    doubt.quantity = "shear_stress";
    doubt.origins.push_back({recording.file, lines.front().first, 0});
    doubt.set_aside = false;
    result.doubts.push_back(std::move(doubt));
}

}  // namespace pendular
