#include "data/recordings/yield_locus.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "data/recordings/straight_line.h"

namespace pendular {
namespace {

double mean_of(const std::vector<double>& values, std::size_t begin, std::size_t end) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
        if (!std::isfinite(values[i])) continue;
        sum += values[i];
        ++count;
    }
    return count == 0 ? std::nan("") : sum / static_cast<double>(count);
}

/// Index of the row with the largest magnitude of shear stress, of those with both stresses; empty
/// if no row has both.
std::optional<std::size_t> row_of_peak(const IntervalSeries& series) {
    std::optional<std::size_t> peak;
    if (series.shear_stress.empty() || series.normal_stress.empty()) return peak;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (!std::isfinite(series.shear_stress[i]) || !std::isfinite(series.normal_stress[i]))
            continue;
        if (!peak || std::abs(series.shear_stress[i]) > std::abs(series.shear_stress[*peak]))
            peak = i;
    }
    return peak;
}

const char* flow_class_of(double flowability) {
    if (flowability < 1) return "not flowing";
    if (flowability < 2) return "very cohesive";
    if (flowability < 4) return "cohesive";
    return flowability < 10 ? "easy-flowing" : "free-flowing";
}

/// Sets what follows from the Mohr circle of the preshear.
void add_preshear(LinearYieldLocus& locus, const PreshearPoint& preshear) {
    const double s = preshear.normal_stress, t = std::abs(preshear.shear_stress);
    const double sine = std::sin(locus.slope_angle);
    const double shift = locus.cohesion * std::cos(locus.slope_angle);
    const double a = 1 - sine * sine;
    const double half_b = s + sine * shift;
    const double c = s * s + t * t - shift * shift;
    // If the preshear is above the line, no circle through it is tangent; the circle that touches
    // the line at the normal stress of the preshear is used, as the instrument does.
    const double root = std::max(half_b * half_b - a * c, 0.0);
    const double centre = (half_b - std::sqrt(root)) / a;
    const double radius = centre * sine + shift;
    locus.preshear_centre = centre;
    locus.major_principal_stress = centre + radius;
    locus.effective_angle = std::asin(std::min(radius / centre, 1.0));
    locus.flowability = locus.unconfined_strength > 0
                            ? *locus.major_principal_stress / locus.unconfined_strength
                            : INFINITY;
    locus.flow_class = flow_class_of(*locus.flowability);
}

/// Preshear of a point of failure, and the interval in which it is.
struct OwnPreshear {
    PreshearPoint point;
    std::size_t interval;
    bool in_row = false;  ///< whether a row that is a point of failure states it
};

/// Preshear of the same test before an interval, or else the one that the file states; empty if
/// there is none.
std::optional<OwnPreshear> preshear_before(const BlockFile& file,
                                           const std::vector<IntervalSeries>& series,
                                           const std::vector<IntervalRole>& roles, std::size_t i) {
    const std::size_t own = i;
    while (i-- > 0 && file.blocks[i].test == file.blocks[i + 1].test)
        if (roles[i].role == "preshear" && !series[i].shear_stress.empty() &&
            !series[i].normal_stress.empty()) {
            PreshearPoint point = preshear_point(series[i]);
            point.bulk_density = file.blocks[i].bulk_density;
            return OwnPreshear{point, i};
        }
    if (const auto normal = file.blocks[own].preshear_normal_stress)
        return OwnPreshear{{.normal_stress = *normal,
                            .shear_stress = std::abs(
                                file.blocks[own].preshear_shear_stress.value_or(std::nan(""))),
                            .bulk_density = file.blocks[own].bulk_density},
                           own,
                           series[own].size() == 1};
    return std::nullopt;
}

/// Takes the mean of a value over preshears that have it.
void set_mean(std::optional<double>& mean, const std::vector<OwnPreshear>& all,
              std::optional<double> PreshearPoint::*value) {
    double sum = 0;
    std::size_t count = 0;
    for (const OwnPreshear& each : all)
        if (each.point.*value) sum += *(each.point.*value), ++count;
    if (count > 0) mean = sum / static_cast<double>(count);
}

/// Sets the preshear of a locus from those of its points, which are in their order, and what each
/// point would be multiplied by.
/// @param average whether the preshear becomes their mean
void compare_preshears(YieldLocus& locus, const std::vector<OwnPreshear>& of_points, bool average) {
    std::vector<OwnPreshear> all;  // several points may follow one preshear
    for (const OwnPreshear& each : of_points)
        if (all.empty() || all.back().interval != each.interval) all.push_back(each);
    std::vector<double> normals, shears;  // a row may state the normal stress alone
    for (const OwnPreshear& each : all) {
        normals.push_back(each.point.normal_stress);
        if (std::isfinite(each.point.shear_stress)) shears.push_back(each.point.shear_stress);
    }
    const double normal = mean_of(normals, 0, normals.size()),
                 shear = mean_of(shears, 0, shears.size()), n = static_cast<double>(shears.size());
    double squares = 0;
    for (const double each : shears)
        squares += std::pow(each - shear, 2);
    if (average) {
        locus.preshear->normal_stress = normal;
        locus.preshear->shear_stress = shear;
        set_mean(locus.preshear->bulk_density, all, &PreshearPoint::bulk_density);
        set_mean(locus.preshear->height, all, &PreshearPoint::height);
    }
    // A table that repeats one value in each row tells of one preshear.
    if (shears.size() < 2 || !(squares > 0) || !(shear > 0)) return;
    const double deviation = std::sqrt(squares / (n - 1));
    locus.preshear->shear_stress_error = average ? deviation / std::sqrt(n) : deviation;
    for (std::size_t i = 0; i < of_points.size(); ++i)
        if (of_points[i].point.shear_stress > 0)
            locus.points[i].prorating = shear / of_points[i].point.shear_stress;
}

void prorate_points(YieldLocus& locus) {
    for (FailurePoint& point : locus.points) {
        if (!point.prorating) continue;
        point.shear_stress *= *point.prorating;
        point.smoothed_shear_stress *= *point.prorating;
        locus.prorated = true;
    }
}

/// Locus with the test and preshear of a point; a new locus if there is none.
YieldLocus& locus_for(std::vector<YieldLocus>& loci, const std::string& test,
                      const std::optional<PreshearPoint>& preshear) {
    for (YieldLocus& locus : loci) {
        const bool both = locus.preshear && preshear;
        const bool same =
            both ? std::abs(locus.preshear->normal_stress / preshear->normal_stress - 1) < 0.05
                 : !locus.preshear && !preshear;
        if (locus.test == test && same) return locus;
    }
    loci.push_back({.test = test, .preshear = preshear});
    return loci.back();
}

std::optional<LinearYieldLocus> fitted(const YieldLocus& locus, double FailurePoint::*normal,
                                       double FailurePoint::*shear) {
    std::vector<double> x, y;
    for (const FailurePoint& point : locus.points) {
        x.push_back(point.*normal);
        y.push_back(point.*shear);
    }
    try {
        return linear_yield_locus(x, y, locus.preshear);
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

}  // namespace

namespace {

/// Results of a line of given intercept [Pa] and slope [1].
LinearYieldLocus locus_of_line(double intercept, double slope,
                               const std::optional<PreshearPoint>& preshear) {
    LinearYieldLocus locus;
    locus.intercept = intercept;
    locus.cohesion = std::max(locus.intercept, 0.0);
    locus.slope_angle = std::atan(slope);
    if (locus.cohesion > 0)  // a line that does not rise meets the axis nowhere on this side
        locus.tensile_strength = slope > 0 ? -locus.cohesion / slope : -INFINITY;
    locus.unconfined_strength =
        2 * locus.cohesion * std::cos(locus.slope_angle) / (1 - std::sin(locus.slope_angle));
    if (preshear && std::isfinite(preshear->shear_stress)) add_preshear(locus, *preshear);
    return locus;
}

/// Standard errors by central differences over a thousandth of the errors of the line.
LocusErrors propagated_errors(const LinearYieldLocus& locus, double slope,
                              const std::optional<PreshearPoint>& preshear,
                              const LineCovariance& line) {
    constexpr double part = 1e-3;
    const double sheared = preshear ? preshear->shear_stress_error.value_or(0) : 0;
    const double da = part * std::sqrt(line.intercept), db = part * std::sqrt(line.slope),
                 dt = part * sheared;
    const auto at = [&](double a, double b, double t) {
        std::optional<PreshearPoint> moved = preshear;
        if (moved) moved->shear_stress += t;
        return locus_of_line(locus.intercept + a, slope + b, moved);
    };
    const LinearYieldLocus more = at(da, 0, 0), less = at(-da, 0, 0), steeper = at(0, db, 0),
                           flatter = at(0, -db, 0), above = at(0, 0, dt), below = at(0, 0, -dt);
    const auto error = [&](const auto& value) {
        if (!(da > 0) || !(db > 0)) return 0.0;
        const double by_a = (value(more) - value(less)) / (2 * da),
                     by_b = (value(steeper) - value(flatter)) / (2 * db),
                     by_t = dt > 0 ? (value(above) - value(below)) / (2 * part) : 0;
        return std::sqrt(std::max(0.0, by_a * by_a * line.intercept + by_b * by_b * line.slope +
                                           2 * by_a * by_b * line.both + by_t * by_t));
    };
    using Locus = const LinearYieldLocus&;
    return {.cohesion = std::sqrt(line.intercept),
            .slope_angle = error([](Locus l) { return l.slope_angle; }),
            .tensile_strength = error([](Locus l) { return l.tensile_strength; }),
            .unconfined_strength = error([](Locus l) { return l.unconfined_strength; }),
            .major_principal_stress =
                error([](Locus l) { return l.major_principal_stress.value_or(0); }),
            .effective_angle = error([](Locus l) { return l.effective_angle.value_or(0); }),
            .flowability = error([](Locus l) { return l.flowability.value_or(0); })};
}

}  // namespace

LinearYieldLocus linear_yield_locus(const std::vector<double>& normal_stress,
                                    const std::vector<double>& shear_stress,
                                    const std::optional<PreshearPoint>& preshear) {
    const auto line = straight_line(normal_stress, shear_stress);
    if (!line) throw std::invalid_argument("a line needs two different normal stresses");
    LinearYieldLocus locus = locus_of_line(line->intercept, line->slope, preshear);
    if (line->covariance)
        locus.errors = propagated_errors(locus, line->slope, preshear, *line->covariance);
    return locus;
}

PreshearPoint preshear_point(const IntervalSeries& series) {
    const std::size_t rows = std::max<std::size_t>(series.size() / 10, 1);
    const std::size_t begin = series.size() - rows;
    PreshearPoint point{mean_of(series.normal_stress, begin, series.size()),
                        mean_of(series.shear_stress, begin, series.size())};
    double squares = 0;
    for (std::size_t i = begin; i < series.size(); ++i)
        if (std::isfinite(series.shear_stress[i]))
            squares += std::pow(series.shear_stress[i] - point.shear_stress, 2);
    point.shear_stress_deviation = std::sqrt(squares / static_cast<double>(rows));
    point.shear_stress = std::abs(point.shear_stress);
    point.begin = begin;
    if (const double gap =
            series.height.empty() ? NAN : mean_of(series.height, begin, series.size());
        std::isfinite(gap))
        point.height = gap;
    const double before =
        std::abs(mean_of(series.shear_stress, begin - std::min(rows, begin), begin));
    constexpr double steady = 0.02;  // relative, as for `are_replicates`
    // A single row is a result, whose course is not known.
    point.plateau = series.size() == 1 || (begin > 0 && std::abs(before - point.shear_stress) <=
                                                            steady * point.shear_stress);
    return point;
}

FailurePoint failure_point(const Block& block, const IntervalSeries& series) {
    const std::size_t peak = row_of_peak(series).value(), rows = series.size();
    FailurePoint point;
    point.interval = block.number;
    point.line = series.line[peak];
    point.normal_stress = series.normal_stress[peak];
    point.shear_stress = std::abs(series.shear_stress[peak]);
    point.liquid_content = block.liquid_content;
    point.at_end = rows > 1 && peak + 1 + rows / 20 >= rows;
    if (!series.height.empty() && std::isfinite(series.height[peak]))
        point.height = series.height[peak];
    const std::size_t window = std::min(std::max<std::size_t>(rows / 30, 5), rows);
    for (std::size_t begin = 0; begin + window <= rows; ++begin) {
        const double mean = std::abs(mean_of(series.shear_stress, begin, begin + window));
        if (!(mean > point.smoothed_shear_stress)) continue;
        point.smoothed_shear_stress = mean;
        point.smoothed_normal_stress = mean_of(series.normal_stress, begin, begin + window);
        point.smoothed_begin = begin;
        point.smoothed_end = begin + window;
    }
    return point;
}

std::vector<YieldLocus> yield_loci(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const std::vector<IntervalRole>& roles, bool prorate) {
    std::vector<YieldLocus> loci;
    std::vector<std::vector<OwnPreshear>> preshears;  // of the points of each locus
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (roles[i].role != "failure" || !row_of_peak(series[i])) continue;
        const auto own = preshear_before(file, series, roles, i);
        YieldLocus& locus =
            locus_for(loci, file.blocks[i].test, own ? std::optional(own->point) : std::nullopt);
        locus.points.push_back(failure_point(file.blocks[i], series[i]));
        preshears.resize(loci.size());
        if (own) preshears[static_cast<std::size_t>(&locus - loci.data())].push_back(*own);
    }
    for (std::size_t k = 0; k < loci.size(); ++k) {
        YieldLocus& locus = loci[k];
        // Rows of preshears stand for one state as much as the cells of two columns do.
        const bool table =
            file.table_of_points || std::ranges::all_of(preshears[k], &OwnPreshear::in_row);
        if (locus.preshear) compare_preshears(locus, preshears[k], prorate || table);
        if (prorate) prorate_points(locus);
        locus.line = fitted(locus, &FailurePoint::normal_stress, &FailurePoint::shear_stress);
        locus.smoothed = fitted(locus, &FailurePoint::smoothed_normal_stress,
                                &FailurePoint::smoothed_shear_stress);
    }
    return loci;
}

}  // namespace pendular
