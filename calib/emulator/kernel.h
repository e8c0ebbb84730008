#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "calib/emulator/basis.h"
#include "calib/emulator/bell_sums.h"

namespace pendular {

/// Number of coordinates of a flow state: x, q, u and v of `Coordinates`.
constexpr int coordinate_count = 4;
/// Index of u, the inverse reduced pressure, among the coordinates.
constexpr int pressure_coordinate = 2;

/// Value of a function of the coordinates at a place, or its derivative there by one coordinate.
struct Functional {
    static constexpr int value = -1;
    Coordinates at;
    int derivative = value;  ///< coordinate: 0 for x, 1 for q, 2 for u, 3 for v; `value`: none
};

/// Kind of an emulated quantity, which decides how the quantity behaves in the dry limit 1/P* -> 0.
enum class Domain {
    all_flow,  ///< defined for wet and dry grains, continuous as 1/P* -> 0
    contacts,  ///< defined for wet and dry grains, with a step at 1/P* = 0: in wet flow, bridges
               ///< hold grains without contacts
    bridges,   ///< defined for wet grains only, with a finite limit as 1/P* -> 0: bridges exist
               ///< where their force no longer matters
};

/// Hyperparameters of the Gaussian process of one emulated quantity, all positive; `Kernel` defines
/// the dry process g_dry and the wet process g_wet.
struct Hyperparameters {
    /// Standard deviation of the dry process g_dry, in the unit of the quantity.
    double dry_amplitude = 1;
    double dry_x = 1, dry_q = 0.2;  ///< correlation lengths of g_dry in x and q [1]
    /// Standard deviation of the wet process g_wet before the factor b(u), in the unit of the
    /// quantity.
    double wet_amplitude = 1;
    /// Correlation lengths of the wet process in x, q, ln(1 + u/0.1) and v, in this order [1].
    double wet_x = 1, wet_q = 0.2, wet_u = 1, wet_v = 1;
    double noise = 1;  ///< factor on the variances of the noise that the runs state [1]
    /// Standard deviation between runs in addition to the noise that they state, in the unit of the
    /// quantity.
    double between_run_scatter = 1e-3;

    /// Number of all hyperparameters, and of those that describe g_dry and g_wet, which come first;
    /// the last two describe the noise of the runs.
    static constexpr std::size_t count = 10, of_processes = 8;
    /// Column names of the hyperparameters in emulator.csv, in the order of `as_array`.
    static constexpr std::array<std::string_view, count> names = {
        "dry_amplitude", "dry_friction", "dry_inertia", "wet_amplitude", "wet_friction",
        "wet_inertia",   "wet_pressure", "wet_volume",  "noise",         "between"};
    /// All hyperparameters, in the order of their declaration.
    std::array<double, count> as_array() const;
    /// Returns hyperparameters with the given values, in the order of `as_array`.
    static Hyperparameters from_array(const std::array<double, count>& values);
};

/// Prior covariance of a random function f of friction, inertial number, reduced pressure and
/// bridge volume, with the limits that physics demands:
///     f = h(z).beta + g_dry(x, q) + b(u) [h_wet(z).gamma + g_wet(x, q, u, v)],
/// with the coordinates z = (x, q, u, v) of `Coordinates`. h and h_wet are polynomials whose
/// coefficients have broad priors. g_dry and g_wet are Gaussian processes of squared exponential
/// covariance with a length for every coordinate (for u, in ln(1 + u/0.1)). The factor b(u) depends
/// on the domain: u for `all_flow`; a step for `contacts`, 0 at u = 0 and else 1; 1 for `bridges`,
/// which have no dry part. Thus dry flow (u = 0) does not depend on the bridge volume, and for
/// `all_flow` the capillary part vanishes as 1/P* -> 0. q = sqrt(I) makes the quasi-static limit
/// finite, approached as a power of I between 1/2 and 1.
class Kernel {
  public:
    /// @param unit typical size of the quantity, in its unit; the prior standard deviation of the
    ///         polynomials' coefficients is five times as large
    Kernel(Domain domain, const Hyperparameters& hyperparameters, double unit);

    /// A `Functional` (value or derivative at a place) with the terms that all its covariances
    /// need, computed once.
    struct Prepared {
        int derivative = Functional::value;
        double u = 0;
        std::array<double, coordinate_count> place{};  ///< [x, q, ln(1 + u/0.1), v]
        /// Derivatives of the entries of `place` by x, q, u and v.
        std::array<double, coordinate_count> stretch{};
        Eigen::RowVectorXd polynomial;  ///< terms of the polynomial h, or their derivatives
    };
    /// Computes the terms that all covariances of a value or derivative need.
    Prepared prepare(const Functional& functional) const;
    /// Computes the terms that all covariances need, for the value of the function at each of
    /// several places.
    std::vector<Prepared> prepare(const std::vector<Coordinates>& at) const;

    /// Prior covariance of two values or derivatives of f, from polynomials and Gaussian processes.
    double operator()(const Prepared& a, const Prepared& b) const {
        return coefficient_variance_ * a.polynomial.dot(b.polynomial) + of_processes(a, b);
    }
    /// Prior covariance of two values or derivatives of the emulated function f from its Gaussian
    /// processes alone, without that from its polynomials.
    double of_processes(const Prepared& a, const Prepared& b) const;
    /// Prior variance of each coefficient of the polynomials, in the square of the quantity's unit;
    /// the coefficients are uncorrelated.
    double coefficient_variance() const { return coefficient_variance_; }
    /// Places of observations, stored for fast sums over them: for each process the places with
    /// weight x variance of the process x its factor b(u) there.
    using Known = std::vector<BellSums>;
    /// Prepares `sums` over the places of `values` with one weight for each.
    Known known(const std::vector<Prepared>& values, const Eigen::VectorXd& weights) const;
    /// Returns the sum over the places `known` of weight x prior covariance by the Gaussian
    /// processes with the value at `at`, then the derivatives of this sum by the coordinates x, q,
    /// u and v of `at`. Without `with_pressure`, the derivative by u may lack the part of a process
    /// that vanishes at `at`.
    std::array<double, 1 + coordinate_count> sums(const Known& known, const Prepared& at,
                                                  bool with_pressure) const;

    /// Prior covariance matrix of these values or derivatives of f.
    Eigen::MatrixXd matrix(const std::vector<Prepared>& of) const;
    /// Derivatives of tr(W K)/2 by the logarithms of the hyperparameters of the processes, in their
    /// order, where K is the prior covariance matrix of `values` by the Gaussian processes and W is
    /// `weights`, a symmetric matrix.
    std::array<double, Hyperparameters::of_processes> half_traces(
        const std::vector<Prepared>& values, const Eigen::MatrixXd& weights) const;

    const Hyperparameters& hyperparameters() const { return hyperparameters_; }

  private:
    /// Form of the factor b(u) of a process: 1, u, or a step at u = 0.
    enum class Amplitude { one, linear, step };
    /// One Gaussian process, g_dry or g_wet, with its factor b(u) (1 for g_dry).
    struct Part {
        /// Variance of the process before the factor b(u), in the square of the quantity's unit.
        double variance = 0;
        /// Inverse squares of the correlation lengths; 0 where the process does not depend on the
        /// coordinate.
        std::array<double, coordinate_count> inverse_squares{};
        Amplitude amplitude = Amplitude::one;
    };
    /// Value of the factor b(u) of a process at a place.
    static double amplitude(const Part& part, const Prepared& at);
    /// Prior covariance of two values or derivatives from one process with its factor b(u).
    static double of_part(const Part& part, const Prepared& a, const Prepared& b);

    Hyperparameters hyperparameters_;
    std::vector<Part> parts_;
    std::vector<bool> is_dry_;  ///< for each of `parts_`, whether it is the dry process
    Basis basis_;
    Eigen::Index dry_terms_ = 0;  ///< number of terms of the dry polynomial, the first of `basis_`
    bool steps_ = false;          ///< whether h_wet is absent at u = 0 (`contacts`)
    double coefficient_variance_;
};

}  // namespace pendular
