#include "data/recordings/point_checks.h"

#include <algorithm>
#include <string>

#include "data/recordings/point_roles.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Whether points come in pairs of a load and a lower one, with each higher load in two pairs in
/// succession at least, before different lower ones.
bool in_pairs(const std::vector<FailurePoint>& points) {
    if (points.size() < 4 || points.size() % 2 != 0) return false;
    const auto load = [&](std::size_t i) { return points[i].normal_stress; };
    for (std::size_t i = 0; i < points.size(); i += 2) {
        const bool as_before = i > 0 && is_same_load(load(i), load(i - 2));
        const bool as_after = i + 2 < points.size() && is_same_load(load(i), load(i + 2));
        if (!is_lower_load(load(i + 1), load(i)) || (!as_before && !as_after) ||
            (as_before && is_same_load(load(i + 1), load(i - 1))))
            return false;
    }
    return true;
}

/// Finds the points of a locus without preshears that stand at a load that returns, each before one
/// at a lower load.
std::vector<Remark> returning_load(const BlockFile& file, const YieldLocus& locus) {
    if (locus.preshear || !in_pairs(locus.points)) return {};
    Remark found{.kind = Kind::returning_load,
                 .files = {file.file},
                 .count = locus.points.size() / 2,
                 .of = locus.points.size()};
    for (std::size_t i = 0; i < locus.points.size(); i += 2)
        add_line(found.lines, locus.points[i].line);
    return {found};
}

Remark falling_line(const BlockFile& file, const std::string& test) {
    return {.kind = Kind::falling_line, .files = {file.file}, .names = {test}};
}

}  // namespace

std::vector<Remark> check_points(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                 const std::vector<YieldLocus>& loci,
                                 const std::vector<WallLocus>& walls) {
    std::vector<Remark> found;
    Remark sign{.kind = Kind::impossible_points, .files = {file.file}, .of = series.size()};
    const std::vector<bool> other = impossible_points(file, series);
    for (std::size_t i = 0; i < series.size(); ++i)
        if (other[i]) add_line(sign.lines, series[i].line.front());
    sign.count = static_cast<std::size_t>(std::ranges::count(other, true));
    if (sign.count > 0) found.push_back(std::move(sign));
    for (const YieldLocus& locus : loci) {
        append(found, returning_load(file, locus));
        if (locus.line && locus.line->slope_angle < 0)
            found.push_back(falling_line(file, locus.test));
    }
    for (const WallLocus& wall : walls)
        if (wall.slope < 0) found.push_back(falling_line(file, wall.test));
    return found;
}

}  // namespace pendular
