#include "calib/emulator/known_range.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "calib/emulator/emulated_observables.h"

namespace pendular {
namespace {

using RunPoint = Eigen::Vector4d;
using RunPoints = Eigen::Matrix<double, 4, Eigen::Dynamic>;

/// Scale of 1/P* [1]: below it the response is linear in 1/P*, above it in ln(1/P*), as in
/// `Kernel`.
constexpr double pressure_scale = 0.1;
/// Bridge volume V0/a^3 at which the coordinate v is 0 [1], as `volume_scale` in basis.cpp.
constexpr double typical_volume = 2e-3;

/// Coordinates of a state before they are scaled by the range of the runs.
RunPoint run_coordinates(const FlowState& state) {
    const Coordinates at = emulated::place_of(state);
    return {at.x, at.q, std::log1p(at.u / pressure_scale), at.v};
}

/// Nonnegative weights w of the columns that minimise |columns w - target|, by the active-set
/// method of Lawson and Hanson, Solving Least Squares Problems (1974), chapter 23.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& columns,
                                          const Eigen::VectorXd& target) {
    constexpr double tolerance = 1e-11;  // of rounding, at scaled coordinates of order 1
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(columns.cols());
    std::vector<Eigen::Index> active;
    for (int turn = 0; turn < 200; ++turn) {
        Eigen::VectorXd pull = columns.transpose() * (target - columns * weights);
        for (const Eigen::Index k : active) {
            pull(k) = 0;
        }
        Eigen::Index next = 0;
        if (pull.maxCoeff(&next) <= tolerance * target.squaredNorm()) {
            break;
        }
        active.push_back(next);
        while (!active.empty()) {
            const Eigen::VectorXd wanted =
                columns(Eigen::all, active).colPivHouseholderQr().solve(target);
            // Step as far towards the unconstrained solution as keeps all weights nonnegative.
            double part = 1;
            for (std::size_t k = 0; k < active.size(); ++k) {
                const double now = weights(active[k]), then = wanted(static_cast<Eigen::Index>(k));
                if (then <= 0) {
                    part = std::min(part, now / (now - then));
                }
            }
            const Eigen::VectorXd before = weights(active);
            weights(active) = before + part * (wanted - before);
            if (part == 1) {
                break;
            }
            std::erase_if(active, [&](Eigen::Index k) {
                const bool gone = weights(k) <= tolerance;
                weights(k) = gone ? 0 : weights(k);
                return gone;
            });
        }
    }
    return weights;
}

}  // namespace

KnownRange::KnownRange(const Emulator& emulator) : emulator_(emulator) {
    std::vector<Point> dry, wet;
    for (const dem::RunResult& run : emulator.runs()) {
        const FlowState state = emulated::flow_state_of(run.parameters);
        if (state.effects.empty()) {
            (state.dry() ? dry : wet).push_back(run_coordinates(state));
        }
    }
    std::vector<Point> all = dry;
    all.insert(all.end(), wet.begin(), wet.end());
    least_ = Point::Constant(INFINITY);
    Point greatest = Point::Constant(-INFINITY);
    const auto widen = [&](const std::vector<Point>& points, Eigen::Index coordinates) {
        for (const Point& point : points) {
            least_.head(coordinates) = least_.head(coordinates).cwiseMin(point.head(coordinates));
            greatest.head(coordinates) =
                greatest.head(coordinates).cwiseMax(point.head(coordinates));
        }
    };
    widen(dry, 3);  // dry runs have no bridge volume
    widen(wet, 4);
    if (wet.empty()) {
        least_(3) = greatest(3) = 0;
    }
    least_(1) = 0;  // the quasi-static limit
    // Runs may share one value of a coordinate, whose range [its unit] then must not be 0.
    constexpr double point_like = 1e-3;
    range_ = (greatest - least_).cwiseMax(point_like);

    const auto scaled = [&](const std::vector<Point>& points) {
        RunPoints columns(4, static_cast<Eigen::Index>(points.size()));
        for (std::size_t k = 0; k < points.size(); ++k) {
            columns.col(static_cast<Eigen::Index>(k)) = (points[k] - least_).cwiseQuotient(range_);
        }
        return columns;
    };
    const auto with_limit = [](const RunPoints& runs) {
        RunPoints corners(4, 2 * runs.cols());
        corners << runs, runs;
        corners.rightCols(runs.cols()).row(1).setZero();
        return corners;
    };
    RunPoints dry_runs = scaled(dry);
    dry_runs.row(3).setZero();
    dry_ = {with_limit(dry_runs), dry_runs.cols()};
    // At 1/P* = 0 the bridge volume has no influence: dry runs support every volume.
    RunPoints dry_as_wet(4, wet.empty() ? 0 : 2 * dry_runs.cols());
    if (!wet.empty()) {
        dry_as_wet << dry_runs, dry_runs;
        dry_as_wet.rightCols(dry_runs.cols()).row(3).setOnes();
    }
    const RunPoints wet_runs = scaled(wet);
    RunPoints of_wet(4, wet_runs.cols() + dry_as_wet.cols());
    of_wet << wet_runs, dry_as_wet;
    wet_ = {with_limit(of_wet), wet_runs.cols()};
}

KnownRange::Point KnownRange::place(const FlowState& state) const {
    Point at = (run_coordinates(state) - least_).cwiseQuotient(range_);
    if (state.dry()) {
        at(3) = 0;
    }
    return at;
}

FlowState KnownRange::state_at(const Point& place) const {
    const Point at = least_ + place.cwiseProduct(range_);
    using namespace emulated;
    FlowState state;
    state.friction =
        std::max(0.0, (friction_centre + friction_scale) * std::exp(at(0)) - friction_scale);
    constexpr double rounding = 1e-9;  // below it, q counts as the quasi-static limit
    state.inertial_number = at(1) < rounding ? 0 : at(1) * at(1);
    state.inverse_pressure = std::max(0.0, pressure_scale * std::expm1(at(2)));
    state.bridge_volume = typical_volume * std::exp(at(3));
    return state;
}

KnownRange::Point KnownRange::nearest_in_hull(const Point& place, const Cloud& cloud) const {
    // min |sum w_k p_k - place|^2 + stiff^2 (sum w_k - 1)^2 over w >= 0: a place inside the hull is
    // found exactly; for a place outside, the nearest point of the hull is found up to 1/stiff^2.
    constexpr double stiff = 100;
    Eigen::MatrixXd columns(5, cloud.corners.cols());
    columns << cloud.corners, Eigen::RowVectorXd::Constant(cloud.corners.cols(), stiff);
    Eigen::VectorXd target(5);
    target << place, stiff;
    const Eigen::VectorXd weights = nonnegative_least_squares(columns, target);
    return cloud.corners * weights / weights.sum();
}

namespace {

/// Why predictions of stress ratio and solid fraction are too uncertain or unphysical; empty if
/// they are not.
std::string why_unsure_of(const Eigen::Vector2d& value, const Eigen::Vector2d& error) {
    if (!(value(0) > 0)) {
        return fmt::format("the predicted stress ratio {:.2g} is not above 0", value(0));
    }
    if (!(value(1) >= KnownRange::lowest_fraction && value(1) <= KnownRange::highest_fraction)) {
        return fmt::format("the predicted solid fraction {:.3g} is not between {} and {}", value(1),
                           KnownRange::lowest_fraction, KnownRange::highest_fraction);
    }
    const double largest[] = {KnownRange::largest_ratio_error, KnownRange::largest_fraction_error};
    for (const Eigen::Index k : {0, 1}) {
        if (!(error(k) <= largest[k] * value(k))) {
            return fmt::format(
                "the standard error of the predicted {} is {:.2g} %, more than {:g} %",
                k == 0 ? "stress ratio" : "solid fraction", 100 * error(k) / value(k),
                100 * largest[k]);
        }
    }
    return {};
}

}  // namespace

std::vector<std::string> KnownRange::why_unsure(const std::vector<FlowState>& states) const {
    const auto pairs = emulated::pairs_at(states);
    const Eigen::VectorXd value = emulator_.mean(pairs);
    const Eigen::VectorXd error = emulator_.covariance(pairs).diagonal().cwiseSqrt();
    std::vector<std::string> why;
    for (Eigen::Index k = 0; k < std::ssize(states); ++k)
        why.push_back(why_unsure_of(value.segment<2>(2 * k), error.segment<2>(2 * k)));
    return why;
}

std::string KnownRange::why_outside(const FlowState& state) const {
    const Cloud& cloud = cloud_for(state);
    if (cloud.runs == 0) {
        return state.dry() ? "no simulation is dry" : "no simulation has liquid bridges";
    }
    const Point at = place(state);
    if ((at - nearest_in_hull(at, cloud)).norm() <= margin) return {};
    const std::string outside = emulator_.beyond(state);
    return outside.empty() ? "the state lies outside the convex hull of the simulations" : outside;
}

std::string KnownRange::why_unsupported(const FlowState& state) const {
    return why_unsupported(std::vector{state}).front();
}

std::vector<std::string> KnownRange::why_unsupported(const std::vector<FlowState>& states) const {
    std::vector<std::string> why;
    std::vector<FlowState> inside;
    for (const FlowState& state : states) {
        why.push_back(why_outside(state));
        if (why.back().empty()) inside.push_back(state);
    }
    if (inside.empty()) return why;
    const std::vector<std::string> unsure = why_unsure(inside);
    auto next = unsure.begin();
    for (std::string& each : why)
        if (each.empty()) each = *next++;
    return why;
}

FlowState KnownRange::nearest_supported(const FlowState& state) const {
    const Cloud& cloud = cloud_for(state);
    if (cloud.runs == 0) {
        throw std::invalid_argument("no simulation is near this state");
    }
    const Point at = place(state), edge = nearest_in_hull(at, cloud);
    const auto found = [&](const Point& point) {
        FlowState result = state_at(point);
        if (state.dry()) {
            result.inverse_pressure = result.bridge_volume = 0;
        }
        return result;
    };
    Eigen::Index nearest = 0;
    (cloud.corners.leftCols(cloud.runs).colwise() - edge).colwise().norm().minCoeff(&nearest);
    const Point run = cloud.corners.col(nearest);
    double unsure = 0, sure = 1;  // parts of the way from the edge to the run
    if (why_unsure(found(edge)).empty()) {
        return found(edge);
    }
    while (sure - unsure > 0.01) {  // near enough for an advice
        const double middle = (sure + unsure) / 2;
        (why_unsure(found(edge + middle * (run - edge))).empty() ? sure : unsure) = middle;
    }
    return found(edge + sure * (run - edge));
}

}  // namespace pendular
