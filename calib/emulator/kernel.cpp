#include "calib/emulator/kernel.h"

#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

/// Prior standard deviation of the polynomial's coefficients, in units of the quantity's typical
/// size [1]. Chosen wide, so that the runs determine the coefficients and not the prior.
constexpr double coefficient_scale = 5;

/// Scale of 1/P* [1]: below it the response to capillarity is linear in 1/P*, above it in ln(1/P*),
/// since weak capillarity already closes contacts that hardly touched.
constexpr double weak_capillarity = 0.1;

double inverse_square(double value) {
    return 1 / (value * value);
}

BellSums::Place bell_place(const std::array<double, coordinate_count>& coordinates) {
    BellSums::Place place{};
    std::ranges::copy(coordinates, place.begin());
    return place;
}

}  // namespace

std::array<double, Hyperparameters::count> Hyperparameters::as_array() const {
    return {dry_amplitude, dry_x, dry_q, wet_amplitude, wet_x,
            wet_q,         wet_u, wet_v, noise,         between_run_scatter};
}

Hyperparameters Hyperparameters::from_array(const std::array<double, count>& a) {
    return {a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8], a[9]};
}

Kernel::Kernel(Domain domain, const Hyperparameters& s, double unit)
    : hyperparameters_(s),
      steps_(domain == Domain::contacts),
      coefficient_variance_(std::pow(coefficient_scale * unit, 2)) {
    if (domain != Domain::bridges) {
        parts_.push_back({.variance = s.dry_amplitude * s.dry_amplitude,
                          .inverse_squares = {inverse_square(s.dry_x), inverse_square(s.dry_q)}});
        is_dry_.push_back(true);
        for (const Basis::Powers& term :
             {Basis::Powers{}, {.x = 1}, {.x = 2}, {.q = 1}, {.x = 1, .q = 1}, {.q = 2}}) {
            basis_.add(term);
        }
        dry_terms_ = basis_.size();
    }
    parts_.push_back({.variance = s.wet_amplitude * s.wet_amplitude,
                      .inverse_squares = {inverse_square(s.wet_x), inverse_square(s.wet_q),
                                          inverse_square(s.wet_u), inverse_square(s.wet_v)},
                      .amplitude = domain == Domain::all_flow   ? Amplitude::linear
                                   : domain == Domain::contacts ? Amplitude::step
                                                                : Amplitude::one});
    is_dry_.push_back(false);
    const int u = domain == Domain::all_flow ? 1 : 0;
    for (const Basis::Powers& term : {Basis::Powers{.u = u},
                                      {.x = 1, .u = u},
                                      {.q = 1, .u = u},
                                      {.u = u + 1},
                                      {.u = u, .v = 1}}) {
        basis_.add(term);
    }
}

Kernel::Prepared Kernel::prepare(const Functional& f) const {
    const Coordinates& at = f.at;
    Prepared prepared{.derivative = f.derivative,
                      .u = at.u,
                      .place = {at.x, at.q, std::log1p(at.u / weak_capillarity), at.v},
                      .stretch = {1, 1, 1 / (weak_capillarity + at.u), 1},
                      .polynomial = basis_.slopes(at, f.derivative)};
    if (steps_ && at.u == 0) {
        prepared.polynomial.tail(basis_.size() - dry_terms_).setZero();
    }
    return prepared;
}

double Kernel::amplitude(const Part& part, const Prepared& at) {
    switch (part.amplitude) {
        case Amplitude::linear:
            return at.u;
        case Amplitude::step:
            return at.u > 0;
        default:
            return 1;
    }
}

std::vector<Kernel::Prepared> Kernel::prepare(const std::vector<Coordinates>& at) const {
    std::vector<Prepared> prepared;
    for (const Coordinates& one : at) {
        prepared.push_back(prepare(Functional{one}));
    }
    return prepared;
}

double Kernel::of_part(const Part& part, const Prepared& a, const Prepared& b) {
    std::array<double, coordinate_count> pull;  // slope of exponent/2 along each coordinate
    double exponent = 0;
    for (std::size_t k = 0; k < coordinate_count; ++k) {
        pull[k] = (a.place[k] - b.place[k]) * part.inverse_squares[k];
        exponent += (a.place[k] - b.place[k]) * pull[k];
    }
    const double amplitude_a = amplitude(part, a), amplitude_b = amplitude(part, b);
    const double whole = part.variance * std::exp(-exponent / 2);
    const int da = a.derivative, db = b.derivative;
    if (da == Functional::value && db == Functional::value) {
        return whole * amplitude_a * amplitude_b;
    }
    // Derivative of the product amplitude(a) amplitude(b) exp(-exponent/2).
    const bool linear = part.amplitude == Amplitude::linear;
    const double growth_a = linear && da == pressure_coordinate,
                 growth_b = linear && db == pressure_coordinate;
    const auto ka = static_cast<std::size_t>(std::max(da, 0)),
               kb = static_cast<std::size_t>(std::max(db, 0));
    const double slope_a = -a.stretch[ka] * pull[ka], slope_b = b.stretch[kb] * pull[kb];
    if (db == Functional::value) {
        return whole * amplitude_b * (growth_a + amplitude_a * slope_a);
    }
    if (da == Functional::value) {
        return whole * amplitude_a * (growth_b + amplitude_b * slope_b);
    }
    const double curvature =
        (da == db ? a.stretch[ka] * b.stretch[kb] * part.inverse_squares[ka] : 0.0) +
        slope_a * slope_b;
    return whole * (growth_a * growth_b + growth_a * amplitude_b * slope_b +
                    amplitude_a * growth_b * slope_a + amplitude_a * amplitude_b * curvature);
}

double Kernel::of_processes(const Prepared& a, const Prepared& b) const {
    double sum = 0;
    for (const Part& part : parts_) {
        sum += of_part(part, a, b);
    }
    return sum;
}

Kernel::Known Kernel::known(const std::vector<Prepared>& values,
                            const Eigen::VectorXd& weights) const {
    Known known;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        BellSums& sums = known.emplace_back(is_dry_[p] ? 2 : coordinate_count,
                                            bell_place(parts_[p].inverse_squares));
        for (std::size_t i = 0; i < values.size(); ++i) {
            sums.add(bell_place(values[i].place), weights(static_cast<Eigen::Index>(i)) *
                                                      parts_[p].variance *
                                                      amplitude(parts_[p], values[i]));
        }
    }
    return known;
}

std::array<double, 1 + coordinate_count> Kernel::sums(const Known& known, const Prepared& at,
                                                      bool with_pressure) const {
    std::array<double, 1 + coordinate_count> result{};
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const Part& part = parts_[p];
        const double amplitude_there = amplitude(part, at);
        const bool linear = part.amplitude == Amplitude::linear;
        if (amplitude_there == 0 && !(linear && with_pressure)) {
            continue;
        }
        const auto sums = known[p].at(bell_place(at.place));
        result[0] += amplitude_there * sums[0];
        result[1 + pressure_coordinate] += linear ? sums[0] : 0;
        for (std::size_t k = 0; k < coordinate_count; ++k) {
            result[1 + k] +=
                amplitude_there * at.stretch[k] * part.inverse_squares[k] * sums[1 + k];
        }
    }
    return result;
}

Eigen::MatrixXd Kernel::matrix(const std::vector<Prepared>& of) const {
    const auto n = static_cast<Eigen::Index>(of.size());
    Eigen::MatrixXd result(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index i = j; i < n; ++i) {
            result(i, j) = result(j, i) =
                (*this)(of[static_cast<std::size_t>(i)], of[static_cast<std::size_t>(j)]);
        }
    }
    return result;
}

std::array<double, Hyperparameters::of_processes> Kernel::half_traces(
    const std::vector<Prepared>& values, const Eigen::MatrixXd& weights) const {
    // Derivatives of a part K: dK/d(ln amplitude) = 2 K, dK/d(ln length) = K (difference/length)^2.
    std::array<double, Hyperparameters::of_processes> traces{};
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        double* const own = traces.data() + (is_dry_[p] ? 0 : 3);
        const std::size_t lengths = is_dry_[p] ? 2 : coordinate_count;
        for (std::size_t j = 0; j < values.size(); ++j) {
            for (std::size_t i = j; i < values.size(); ++i) {
                const double both = i == j ? 0.5 : 1.0;  // the two triangles, halved
                const double term =
                    both * weights(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) *
                    of_part(parts_[p], values[i], values[j]);
                own[0] += 2 * term;
                for (std::size_t k = 0; k < lengths; ++k) {
                    const double apart = values[i].place[k] - values[j].place[k];
                    own[1 + k] += term * apart * apart * parts_[p].inverse_squares[k];
                }
            }
        }
    }
    return traces;
}

}  // namespace pendular
