#include "data/recordings/wall_locus.h"

#include <algorithm>
#include <cmath>

#include "data/recordings/yield_locus.h"

namespace pendular {
namespace {

/// Sets the lines of a locus. Returns false without two different normal stresses.
bool fit_wall(WallLocus& locus) {
    const double n = static_cast<double>(locus.points.size());
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const WallPoint& point : locus.points) {
        x += point.normal_stress / n;
        y += point.shear_stress / n;
        xx += point.normal_stress * point.normal_stress;
        xy += point.normal_stress * point.shear_stress;
    }
    const double squares = xx - n * x * x;
    if (!(squares > 1e-12 * xx)) return false;  // all normal stresses are equal
    locus.coefficient = xy / xx;
    locus.slope = (xy - n * x * y) / squares;
    locus.adhesion = y - locus.slope * x;
    constexpr std::size_t fewest = 4;
    if (locus.points.size() < fewest) return true;
    double about_origin = 0, about_line = 0;
    for (const WallPoint& point : locus.points) {
        about_origin += std::pow(point.shear_stress - locus.coefficient * point.normal_stress, 2);
        about_line +=
            std::pow(point.shear_stress - locus.adhesion - locus.slope * point.normal_stress, 2);
    }
    const double variance = about_line / (n - 2);
    locus.errors = WallErrors{.coefficient = std::sqrt(about_origin / (n - 1) / xx),
                              .adhesion = std::sqrt(variance * (1 / n + x * x / squares)),
                              .slope = std::sqrt(variance / squares)};
    return true;
}

}  // namespace

bool WallLocus::adheres() const {
    return errors && std::abs(adhesion) > 2 * errors->adhesion;
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
