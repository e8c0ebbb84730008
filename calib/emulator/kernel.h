#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "calib/emulator/basis.h"

namespace pendular {

/// Number of coordinates of a flow state: x, q, u and v of `Coordinates`.
constexpr int coordinate_count = 4;

/// Value of a function at a place, or its derivative by one coordinate.
struct Functional {
    static constexpr int value = -1;
    Coordinates at;
    int derivative = value;  ///< coordinate: 0 for x, 1 for q, 2 for u, 3 for v; `value`: none
};

/// Kind of an emulated quantity, which decides how it behaves in the dry limit 1/P* -> 0.
enum class Domain {
    all_flow,  ///< defined for wet and dry grains, continuous as 1/P* -> 0
    contacts,  ///< defined for wet and dry grains, with a step at 1/P* = 0: in wet flow, bridges
               ///< hold grains without contacts
    bridges,   ///< defined for wet grains only, with a finite limit as 1/P* -> 0: bridges exist
               ///< where their force no longer matters
};

/// Hyperparameters of a Gaussian process, all positive; for the processes see `Kernel`.
struct Hyperparameters {
    /// Standard deviation of the dry process g_dry, in the unit of the quantity.
    double dry_amplitude = 1;
    double dry_x = 1, dry_q = 0.2;  ///< correlation lengths of the dry process in x and q
    /// Standard deviation of the wet process g_wet, in the unit of the quantity, before it is
    /// multiplied by b(u).
    double wet_amplitude = 1;
    /// Correlation lengths of the wet process in x, q, ln(1 + u/0.1) and v.
    double wet_x = 1, wet_q = 0.2, wet_u = 1, wet_v = 1;
    double noise = 1;  ///< factor on the variances that the runs state [1]
    /// Standard deviation between runs in excess of these variances, in the unit of the quantity.
    double between_run_scatter = 1e-3;

    /// Number of hyperparameters, and of those that describe the processes; the last two describe
    /// the noise.
    static constexpr std::size_t count = 10, of_processes = 8;
    /// Column names of the hyperparameters in emulator.csv, in the order of `as_array`.
    static constexpr std::array<std::string_view, count> names = {
        "dry_amplitude", "dry_friction", "dry_inertia", "wet_amplitude", "wet_friction",
        "wet_inertia",   "wet_pressure", "wet_volume",  "noise",         "between"};
    /// All hyperparameters, in the order of their declaration.
    std::array<double, count> as_array() const;
    /// Hyperparameters from values in the order of `as_array`.
    static Hyperparameters from_array(const std::array<double, count>& values);
};

/// Prior covariance of a random function f of friction, inertial number, reduced pressure and
/// bridge volume, with the limits that physics demands:
///     f = h(z).beta + g_dry(x, q) + b(u) [h_wet(z).gamma + g_wet(x, q, u, v)],
/// h are polynomials whose coefficients have broad priors. g are Gaussian processes of squared
/// exponential covariance with a length for every coordinate (for u, in ln(1 + u/0.1)). The factor
/// b(u) depends on the domain: u for `all_flow`; a step for `contacts`, 0 at u = 0 and else 1; 1
/// for `bridges`, which have no dry part. Thus dry flow (u = 0) does not depend on the bridge
/// volume, and for `all_flow` the capillary part vanishes as 1/P* -> 0. q = sqrt(I) makes the
/// quasi-static limit finite, approached as a power of I between 1/2 and 1.
class Kernel {
  public:
    /// @param unit typical size of the quantity; the prior of the polynomial's coefficients is
    ///        several times as wide
    Kernel(Domain domain, const Hyperparameters& hyperparameters, double unit);

    /// Functional with the terms that all its covariances need, computed once.
    struct Prepared {
        int derivative = Functional::value;
        double u = 0;
        std::array<double, coordinate_count> place{};  ///< [x, q, ln(1 + u/0.1), v]
        /// Derivatives of the entries of `place` by x, q, u and v.
        std::array<double, coordinate_count> stretch{};
        Eigen::RowVectorXd polynomial;  ///< terms of the polynomial h, or their derivatives
    };
    /// Computes the terms that all covariances of a functional need.
    Prepared prepare(const Functional& functional) const;
    /// Computes these terms for the values of the function at several places.
    std::vector<Prepared> prepare(const std::vector<Coordinates>& at) const;

    /// Prior covariance of two functionals.
    double operator()(const Prepared& a, const Prepared& b) const {
        return coefficient_variance_ * a.polynomial.dot(b.polynomial) + of_processes(a, b);
    }
    /// Prior covariance of two functionals from the Gaussian processes alone, without the
    /// polynomial.
    double of_processes(const Prepared& a, const Prepared& b) const;
    /// Prior variance of each coefficient of the polynomial; the coefficients are uncorrelated.
    double coefficient_variance() const { return coefficient_variance_; }
    /// Observed places and their weights, stored as arrays for fast sums over the places.
    struct Known {
        std::array<Eigen::ArrayXd, coordinate_count> place;  ///< an array for each coordinate
        /// Weight x variance x b(u) at each place, a column for each process.
        Eigen::ArrayXXd weights;
    };
    /// Prepares sums over the places of `values` with `weights`.
    Known known(const std::vector<Prepared>& values, const Eigen::VectorXd& weights) const;
    /// Returns the sum of weight x of_processes(known, at), then its derivatives by the coordinates
    /// of `at`, which are meaningless without `with_derivatives`.
    std::array<double, 1 + coordinate_count> sums(const Known& known, const Prepared& at,
                                                  bool with_derivatives) const;

    /// Prior covariance matrix of functionals.
    Eigen::MatrixXd matrix(const std::vector<Prepared>& of) const;
    /// Derivatives of tr(W K)/2 by the logarithms of the hyperparameters of the processes, where K
    /// is the covariance matrix of `values` and W is `weights`, a symmetric matrix.
    std::array<double, Hyperparameters::of_processes> half_traces(
        const std::vector<Prepared>& values, const Eigen::MatrixXd& weights) const;

    const Hyperparameters& hyperparameters() const { return hyperparameters_; }

  private:
    /// Form of the factor b(u): 1, u, or a step at u = 0.
    enum class Amplitude { one, linear, step };
    /// One process g with its factor b(u).
    struct Part {
        double variance = 0;
        /// Inverse squares of the lengths; 0 where the process does not depend on the coordinate.
        std::array<double, coordinate_count> inverse_squares{};
        Amplitude amplitude = Amplitude::one;
    };
    /// Value of b(u) of a process at a place.
    static double amplitude(const Part& part, const Prepared& at);
    /// Prior covariance of two functionals from one process.
    static double of_part(const Part& part, const Prepared& a, const Prepared& b);

    Hyperparameters hyperparameters_;
    std::vector<Part> parts_;
    std::vector<bool> is_dry_;  ///< for each of `parts_`, whether it is the dry process
    Basis basis_;
    Eigen::Index dry_terms_ = 0;  ///< number of terms of the dry polynomial, the first of `basis_`
    bool steps_ = false;          ///< whether the wet polynomial is absent at u = 0 (`contacts`)
    double coefficient_variance_;
};

}  // namespace pendular
