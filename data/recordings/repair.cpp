#include "data/recordings/checks.h"

#include <cmath>

#include "data/quantities/units.h"

namespace pendular {
namespace {

/// Relative difference up to which a torque is a power of ten times that of the stress [1]. Chosen:
/// wider than the rounding of both columns, and so narrow that other faults are left alone.
constexpr double repair_tolerance = 0.05;

}  // namespace

std::vector<Remark> torques_without_mark(const Recording& recording, const AnnularCell& cell,
                                         std::vector<bool>& rows) {
    rows.assign(recording.size(), false);
    if (recording.shear_stress.size() != recording.size()) return {};
    Remark found{.kind = Remark::Kind::repaired_torques,
                 .quantity = "shear_stress",
                 .count = 0,
                 .of = recording.size(),
                 .because = std::vector<Remark>(1)};
    std::size_t agreeing = 0;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const double expected = torque(recording.shear_stress[i], cell);
        const auto power = power_of_ten(recording.torque[i] / expected, repair_tolerance);
        if (power == 0) ++agreeing;
        if (!power || *power == 0) continue;
        rows[i] = true;
        if (found.count++ == 0) found.add({recording.file, recording.line[i], 0});
        add_line(found.because.front().lines, recording.line[i]);
    }
    if (found.count > 0 && agreeing > 0) return {found};
    rows.assign(recording.size(), false);
    return {};
}

void repair_torques(Recording& recording, const AnnularCell& cell, const std::vector<bool>& rows) {
    for (std::size_t i = 0; i < recording.size(); ++i)
        if (rows[i])
            recording.torque[i] =
                std::copysign(torque(recording.shear_stress[i], cell), recording.torque[i]);
}

}  // namespace pendular
