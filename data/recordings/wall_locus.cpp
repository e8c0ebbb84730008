#include "data/recordings/wall_locus.h"

#include <algorithm>
#include <cmath>

#include "data/quantities/statistics.h"
#include "data/recordings/straight_line.h"
#include "data/recordings/yield_locus.h"

namespace pendular {
namespace {

/// Sets the lines of a locus. Returns false without two different normal stresses.
bool fit_wall(WallLocus& locus) {
    std::vector<double> normal, shear;
    double xx = 0, xy = 0, about_origin = 0;
    for (const WallPoint& point : locus.points) {
        normal.push_back(point.normal_stress);
        shear.push_back(point.shear_stress);
        xx += point.normal_stress * point.normal_stress;
        xy += point.normal_stress * point.shear_stress;
    }
    const auto line = straight_line(normal, shear);
    if (!line) return false;
    locus.coefficient = xy / xx;
    locus.slope = line->slope;
    locus.adhesion = line->intercept;
    if (!line->covariance) return true;
    for (std::size_t i = 0; i < normal.size(); ++i)
        about_origin += std::pow(shear[i] - locus.coefficient * normal[i], 2);
    const double n = static_cast<double>(normal.size());
    const bool exact = line->covariance->slope == 0 && locus.adhesion == 0;  // all is rounding
    locus.errors = WallErrors{.coefficient = exact ? 0 : std::sqrt(about_origin / (n - 1) / xx),
                              .adhesion = std::sqrt(line->covariance->intercept),
                              .slope = std::sqrt(line->covariance->slope)};
    return true;
}

/// Errors by which the best line of a locus misses the origin with a probability of 2.5 % on either
/// side by chance: Student's t, since few points determine the error itself.
double missing_errors(const WallLocus& locus) {
    return students_t_quantile(0.975, static_cast<double>(locus.points.size()) - 2);
}

}  // namespace

bool WallLocus::adheres() const {
    return errors && adhesion > missing_errors(*this) * errors->adhesion;
}

bool WallLocus::below_origin() const {
    return errors && adhesion < -missing_errors(*this) * errors->adhesion;
}

WallLine WallLocus::line() const {
    const WallErrors known = errors.value_or(WallErrors{});
    return adheres() ? WallLine{adhesion, slope, known.slope}
                     : WallLine{0, coefficient, known.coefficient};
}

std::vector<WallLocus> wall_loci(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                 const std::vector<IntervalRole>& roles) {
    std::vector<WallLocus> loci;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (roles[i].role != "wall" || series[i].shear_stress.empty() ||
            series[i].normal_stress.empty())
            continue;
        const PreshearPoint end = preshear_point(series[i]);
        if (!std::isfinite(end.shear_stress) || !std::isfinite(end.normal_stress)) continue;
        const std::string& test = file.blocks[i].test;
        auto locus = std::ranges::find(loci, test, &WallLocus::test);
        if (locus == loci.end()) locus = loci.insert(loci.end(), WallLocus{.test = test});
        locus->points.push_back({series[i].line.back(), end.normal_stress, end.shear_stress});
    }
    std::erase_if(loci, [](WallLocus& locus) { return !fit_wall(locus); });
    return loci;
}

}  // namespace pendular
