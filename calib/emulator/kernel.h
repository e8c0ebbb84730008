#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "calib/emulator/basis.h"
#include "calib/emulator/bell_sums.h"

namespace pendular {

/// Number of coordinates of a state of steady shear: x, q, u and v of `Coordinates`.
constexpr int coordinate_count = 4;
/// Index of the coordinate u, the inverse reduced pressure, among the coordinates x, q, u and v.
constexpr int pressure_coordinate = 2;

/// Value of a function of the coordinates x, q, u and v (`Coordinates`) at a place, or its
/// derivative at this place with respect to one coordinate.
struct Functional {
    static constexpr int value = -1;
    Coordinates at;
    /// Coordinate by which the function is differentiated: 0 for x, 1 for q, 2 for u, 3 for v;
    /// `value`: none.
    int derivative = value;
};

/// Kind of an emulated quantity, which determines its behaviour in the dry limit 1/P* -> 0 (P*:
/// reduced pressure).
enum class Domain {
    all_flow,  ///< defined for wet and dry grains, continuous as 1/P* -> 0
    contacts,  ///< defined for wet and dry grains, with a step at 1/P* = 0: in wet flow, bridges
               ///< hold grains without contacts
    /// The quantity is defined for wet grains only and has a finite limit as 1/P* -> 0, since
    /// bridges exist even if their force is negligible.
    bridges,
};

/// Hyperparameters of the Gaussian process of one emulated quantity, all positive. The process is
/// the sum of a dry part g_dry and a wet part g_wet, which `Kernel` defines; x, q, u and v are the
/// `Coordinates`.
struct Hyperparameters {
    /// Standard deviation of the part of the Gaussian process that describes dry flow, in the unit
    /// of the quantity.
    double dry_amplitude = 1;
    /// Correlation lengths [1] of the part of the Gaussian process that describes dry flow: in the
    /// coordinates x of friction (`dry_x`) and q = sqrt(I) (`dry_q`), with the inertial number I.
    double dry_x = 1, dry_q = 0.2;
    /// Standard deviation, in the unit of the quantity, of the part of the Gaussian process that
    /// wet flow adds, before its factor b(u) (see `Kernel`; u: inverse reduced pressure).
    double wet_amplitude = 1;
    /// Correlation lengths [1] of the part of the Gaussian process that wet flow adds, in the
    /// coordinates x of friction, q = sqrt(I), ln(1 + u/0.1) and v of bridge volume, in this order.
    /// I: inertial number; u: inverse reduced pressure.
    double wet_x = 1, wet_q = 0.2, wet_u = 1, wet_v = 1;
    /// Factor on the variances of the noise that the training runs state [1].
    double noise = 1;
    /// Between-run scatter: standard deviation between runs of equal parameters, in addition to the
    /// noise that the runs state, in the unit of the quantity.
    double between_run_scatter = 1e-3;

    /// `count`: number of all hyperparameters. `of_processes`: number of those that describe
    /// amplitudes and lengths, which come first; the last two describe the noise of the runs.
    static constexpr std::size_t count = 10, of_processes = 8;
    /// Column names of the hyperparameters in emulator.csv, in the order of `as_array`.
    static constexpr std::array<std::string_view, count> names = {
        "dry_amplitude", "dry_friction", "dry_inertia", "wet_amplitude", "wet_friction",
        "wet_inertia",   "wet_pressure", "wet_volume",  "noise",         "between"};
    /// Returns the values of all ten hyperparameters, in the order of their declaration.
    std::array<double, count> as_array() const;
    /// Returns hyperparameters with the given values, in the order of `as_array`.
    static Hyperparameters from_array(const std::array<double, count>& values);
};

/// Prior covariance of an emulated quantity f as a function of friction, inertial number I, reduced
/// pressure P* and bridge volume. The function has the limits that physics demands:
///     f = h(z).beta + g_dry(x, q) + b(u) [h_wet(z).gamma + g_wet(x, q, u, v)],
/// with the coordinates z = (x, q, u, v) of `Coordinates`, where q = sqrt(I) and u = 1/P*. h and
/// h_wet are terms of polynomials with coefficients beta and gamma, which have broad priors. g_dry
/// and g_wet are Gaussian processes of squared exponential covariance with a correlation length for
/// each coordinate (for u, in ln(1 + u/0.1)). The factor b(u) depends on the domain: u for
/// `all_flow`; for `contacts`, 0 at u = 0 and 1 elsewhere; 1 for `bridges`, which have no dry part.
/// Dry flow (u = 0) thus does not depend on the bridge volume, and for `all_flow` the capillary
/// part vanishes as 1/P* -> 0. With q = sqrt(I), the quasi-static limit is finite and approached as
/// a power of I between 1/2 and 1.
class Kernel {
  public:
    /// @param domain kind of the quantity
    /// @param unit typical size of the quantity, in its unit; the prior standard deviation of the
    ///        coefficients of the polynomials is five times as large
    Kernel(Domain domain, const Hyperparameters& hyperparameters, double unit);

    /// A value of the emulated quantity, or its derivative, at one place (`Functional`), with the
    /// terms of its covariances that depend on this place alone.
    struct Prepared {
        int derivative = Functional::value;
        double u = 0;
        /// Coordinates [x, q, ln(1 + u/0.1), v] of the place, with x, q, u and v of `Coordinates`.
        std::array<double, coordinate_count> place{};
        /// Derivative of each entry of `place` with respect to its own coordinate: x, q, u or v.
        std::array<double, coordinate_count> stretch{};
        Eigen::RowVectorXd polynomial;  ///< terms of the polynomial h, or their derivatives
    };
    /// Computes the terms that the covariances of a value or derivative at one place need.
    Prepared prepare(const Functional& functional) const;
    /// Computes, for the value of the emulated quantity at each of the places `at`, the terms of
    /// its covariances that depend on this place alone.
    std::vector<Prepared> prepare(const std::vector<Coordinates>& at) const;

    /// Prior covariance of two values or derivatives of the emulated quantity, in the square of its
    /// unit.
    double operator()(const Prepared& a, const Prepared& b) const {
        return coefficient_variance_ * a.polynomial.dot(b.polynomial) + of_processes(a, b);
    }
    /// Part of the prior covariance of two values or derivatives of the emulated quantity that
    /// comes from its Gaussian processes (dry and wet part), without the part from the polynomials.
    double of_processes(const Prepared& a, const Prepared& b) const;
    /// Prior variance of each coefficient of the polynomials, in the square of the quantity's unit;
    /// the coefficients are uncorrelated.
    double coefficient_variance() const { return coefficient_variance_; }
    /// Places with a weight each, stored so that sums over all places are fast. For each Gaussian
    /// process (dry and wet part) it has a Gaussian function (bell) at each place. Its weight is
    /// the weight of the place times the variance of the process and its factor b(u) (see `Kernel`)
    /// at the place.
    using Known = std::vector<BellSums>;
    /// Stores the places of `values`, each with its weight, for fast sums by the function `sums`.
    Known known(const std::vector<Prepared>& values, const Eigen::VectorXd& weights) const;
    /// Returns the sum over the places stored in `known` of (weight of the place) x (prior
    /// covariance of the value at this place with the value at `at`), without the covariance from
    /// the polynomials. The derivatives of this sum with respect to the coordinates x, q, u and v
    /// of `at` follow.
    /// @param with_pressure whether the derivative with respect to u is needed; if false, it may
    ///        lack a part
    std::array<double, 1 + coordinate_count> sums(const Known& known, const Prepared& at,
                                                  bool with_pressure) const;

    /// Prior covariance matrix of values or derivatives of the emulated quantity: a row and a
    /// column for each entry of `of`.
    Eigen::MatrixXd matrix(const std::vector<Prepared>& of) const;
    /// Derivatives of tr(W K)/2 with respect to the logarithms of the first eight hyperparameters,
    /// which are the amplitudes and correlation lengths, in their order. K: prior covariance matrix
    /// of `values` by the Gaussian processes; W: `weights`, a symmetric matrix.
    std::array<double, Hyperparameters::of_processes> half_traces(
        const std::vector<Prepared>& values, const Eigen::MatrixXd& weights) const;

    const Hyperparameters& hyperparameters() const { return hyperparameters_; }

  private:
    /// Form of the factor b(u) by which a Gaussian process is multiplied: 1 (`one`), u (`linear`),
    /// or 0 at u = 0 and 1 elsewhere (`step`). u: inverse reduced pressure.
    enum class Amplitude { one, linear, step };
    /// One of the two Gaussian processes of the kernel, for dry or for wet flow, with the form of
    /// the factor b(u) by which it is multiplied (u: inverse reduced pressure; b = 1 for dry flow).
    struct Part {
        /// Variance of the process before it is multiplied by the factor b(u) (u: inverse reduced
        /// pressure), in the square of the quantity's unit.
        double variance = 0;
        /// Inverse squares of the correlation lengths of the process, one for each coordinate; 0
        /// for a coordinate on which the process does not depend.
        std::array<double, coordinate_count> inverse_squares{};
        Amplitude amplitude = Amplitude::one;
    };
    /// Value [1] at a place of the factor b(u) by which a Gaussian process is multiplied (u:
    /// inverse reduced pressure).
    static double amplitude(const Part& part, const Prepared& at);
    /// Part of the prior covariance of two values or derivatives that comes from one Gaussian
    /// process, including the factor b(u) by which the process is multiplied.
    static double of_part(const Part& part, const Prepared& a, const Prepared& b);

    Hyperparameters hyperparameters_;
    std::vector<Part> parts_;
    std::vector<bool> is_dry_;  ///< for each of `parts_`, whether it is the dry process
    Basis basis_;
    Eigen::Index dry_terms_ = 0;  ///< number of terms of the dry polynomial, the first of `basis_`
    /// Whether the polynomial of wet flow jumps to zero for dry grains, as for `Domain::contacts`.
    bool steps_ = false;
    double coefficient_variance_;
};

}  // namespace pendular
