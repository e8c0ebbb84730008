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
/// Index of the coordinate u, the inverse reduced pressure.
constexpr int pressure_coordinate = 2;

/// Value of a function of the coordinates x, q, u and v (`Coordinates`) at a place, or its
/// derivative there with respect to one coordinate.
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
    bridges,   ///< defined for wet grains only, with a finite limit as 1/P* -> 0: bridges exist
               ///< where their force no longer matters
};

/// Hyperparameters of the Gaussian process of one emulated quantity, all positive. The process is
/// the sum of a dry part g_dry and a wet part g_wet, which `Kernel` defines; x, q, u and v are the
/// `Coordinates`.
struct Hyperparameters {
    /// Standard deviation of the dry part g_dry, in the unit of the quantity.
    double dry_amplitude = 1;
    /// Correlation lengths of the dry part g_dry in the coordinates x and q [1].
    double dry_x = 1, dry_q = 0.2;
    /// Standard deviation of the wet part g_wet, before its factor b(u), in the unit of the
    /// quantity.
    double wet_amplitude = 1;
    /// Correlation lengths of g_wet in x, q, ln(1 + u/0.1) and v, in this order [1].
    double wet_x = 1, wet_q = 0.2, wet_u = 1, wet_v = 1;
    /// Factor on the variances of the noise that the training runs state [1].
    double noise = 1;
    /// Between-run scatter: standard deviation between runs of equal parameters, in addition to the
    /// noise that the runs state, in the unit of the quantity.
    double between_run_scatter = 1e-3;

    /// Number of all hyperparameters, and of those that describe g_dry and g_wet, which come first;
    /// the last two describe the noise of the runs.
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

    /// A value or derivative at a place (`Functional`), with the terms that all its covariances
    /// need.
    struct Prepared {
        int derivative = Functional::value;
        double u = 0;
        /// Coordinates of the place, [x, q, ln(1 + u/0.1), v].
        std::array<double, coordinate_count> place{};
        /// Derivatives of the entries of `place` with respect to x, q, u and v.
        std::array<double, coordinate_count> stretch{};
        Eigen::RowVectorXd polynomial;  ///< terms of the polynomial h, or their derivatives
    };
    /// Computes the terms that the covariances of a value or derivative need.
    Prepared prepare(const Functional& functional) const;
    /// Computes in advance, for each of several points of the input space, the part of a covariance
    /// of the emulated quantity that depends on this point alone.
    std::vector<Prepared> prepare(const std::vector<Coordinates>& at) const;

    /// Prior covariance of two values or derivatives of f, in the square of the unit of f.
    double operator()(const Prepared& a, const Prepared& b) const {
        return coefficient_variance_ * a.polynomial.dot(b.polynomial) + of_processes(a, b);
    }
    /// Part of the prior covariance of two values or derivatives of f that comes from the Gaussian
    /// processes g_dry and g_wet, without that from the polynomials.
    double of_processes(const Prepared& a, const Prepared& b) const;
    /// Prior variance of each coefficient of the polynomials, in the square of the quantity's unit;
    /// the coefficients are uncorrelated.
    double coefficient_variance() const { return coefficient_variance_; }
    /// Weighted places, stored for fast sums over them: for each Gaussian process, bells of the
    /// weight w x variance of the process x factor b(u) of the place.
    using Known = std::vector<BellSums>;
    /// Stores the places of `values`, with a weight for each, for the function `sums`.
    Known known(const std::vector<Prepared>& values, const Eigen::VectorXd& weights) const;
    /// Returns the sum, over the stored places `known`, of weight x prior covariance with the value
    /// at `at` by the Gaussian processes; then the derivatives of this sum with respect to the
    /// coordinates x, q, u and v of `at`.
    /// @param with_pressure whether the derivative with respect to u is needed; if false, it may
    ///        lack a part
    std::array<double, 1 + coordinate_count> sums(const Known& known, const Prepared& at,
                                                  bool with_pressure) const;

    /// Prior covariance matrix of values or derivatives of f, a row and a column for each of `of`.
    Eigen::MatrixXd matrix(const std::vector<Prepared>& of) const;
    /// Derivatives of tr(W K)/2 with respect to the logarithms of the first eight hyperparameters,
    /// those of g_dry and g_wet, in their order. K: prior covariance matrix of `values` by the
    /// Gaussian processes; W: `weights`, a symmetric matrix.
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
        /// Inverse squares of the correlation lengths of the process, one for each coordinate; 0
        /// where the process does not depend on the coordinate.
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
    /// Whether the polynomial h_wet is absent at u = 0, as for the domain `contacts`.
    bool steps_ = false;
    double coefficient_variance_;
};

}  // namespace pendular
