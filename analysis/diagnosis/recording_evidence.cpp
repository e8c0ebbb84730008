#include "analysis/diagnosis/recording_evidence.h"

#include <algorithm>
#include <functional>

#include "analysis/diagnosis/score_statistic.h"

namespace pendular {
namespace {

/// Quantile of chi2 with one degree of freedom at p = 0.01 [1].
constexpr double significant_reduction = 6.63;

bool concerns(const Remark& finding, const Reading& reading) {
    return std::ranges::find(finding.files, reading.origin.file) != finding.files.end() &&
           (finding.step == 0 || finding.step == reading.step);
}

/// Reduction of chi2 by a common factor on the shear stresses (or, for the gap, solid fractions) of
/// the readings that a finding concerns; 0 if no reading is concerned.
double reduction_by(const Remark& finding, const std::vector<Reading>& readings,
                    const WeightedResiduals& residuals) {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(residuals.size());
    const Eigen::Index observable = finding.quantity == "height" ? 1 : 0;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const Eigen::Index entry = 2 * static_cast<Eigen::Index>(k) + observable;
        if (concerns(finding, readings[k])) change(entry) = residuals.measured()(entry);
    }
    return score_columns(residuals, change).reduction(0);
}

}  // namespace

std::vector<RecordingEvidence> recording_evidence(const std::vector<Remark>& findings,
                                                  const std::vector<Reading>& readings,
                                                  const WeightedResiduals& residuals, double excess,
                                                  double by_effects) {
    std::vector<RecordingEvidence> result;
    const double best_effect = std::max(significant_reduction, by_effects);
    for (const Remark& finding : findings) {
        const double reduction = reduction_by(finding, readings, residuals);
        const bool always =
            finding.kind == Remark::Kind::saturation || finding.kind == Remark::Kind::level_change;
        if (!always && reduction < significant_reduction) continue;
        const double share = reduction > 0 && excess > 0 ? std::min(1.0, reduction / excess) : -1;
        result.push_back({finding, share, reduction > best_effect});
    }
    std::ranges::stable_sort(result, std::greater{}, &RecordingEvidence::explains);
    return result;
}

}  // namespace pendular
