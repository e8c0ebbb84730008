#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "calib/emulator/basis.h"
#include "calib/emulator/bell_sums.h"

namespace pendular {

/// Number of coordinates of a state of steady shear: x of the friction coefficient, q of the
/// inertial number, u of the reduced pressure and v of the bridge volume (`Coordinates`).
constexpr int coordinate_count = 4;
/// Index of the coordinate u, the inverse reduced pressure, in the list x, q, u, v of the
/// coordinates of a state of steady shear.
constexpr int pressure_coordinate = 2;

/// Value of a function of the coordinates x, q, u and v (`Coordinates`) at one place, or derivative
/// of the function at the place with respect to one coordinate.
struct Functional {
    static constexpr int value = -1;
    Coordinates at;
    /// Coordinate with respect to which the function is differentiated: 0 for x, 1 for q, 2 for u,
    /// 3 for v. With the constant `value`, the function is not differentiated.
    int derivative = value;
};

/// Kind of an emulated quantity. The kind determines the behaviour of the quantity in the dry limit
/// 1/P* -> 0, with the reduced pressure P*.
enum class Domain {
    /// Quantity that is defined for wet and dry grains and is continuous as 1/P* -> 0.
    all_flow,
    /// Quantity that is defined for wet and dry grains and has a step at 1/P* = 0, such as the
    /// number of contacts per grain. The step arises since bridges, however small their force, hold
    /// grains that have no contacts in dry flow.
    contacts,
    /// Quantity that is defined for wet grains only and has a finite limit as 1/P* -> 0, since
    /// bridges exist even if the bridge force is negligible.
    bridges,
};

/// Hyperparameters of the Gaussian process of one emulated quantity, all positive. The Gaussian
/// process is the sum of a dry part g_dry and a wet part g_wet, which `Kernel` defines as functions
/// of the coordinates x, q, u and v (`Coordinates`).
struct Hyperparameters {
    /// Standard deviation of the part of the Gaussian process that describes dry flow, in the unit
    /// of the quantity.
    double dry_amplitude = 1;
    /// Correlation lengths [1] of the part of the Gaussian process that describes dry flow. `dry_x`
    /// is the length along the coordinate x of the friction coefficient, and `dry_q` the length
    /// along the coordinate q = sqrt(I), with the inertial number I.
    double dry_x = 1, dry_q = 0.2;
    /// Standard deviation, in the unit of the quantity, of the part of the Gaussian process that
    /// wet flow adds. The standard deviation applies before the part is multiplied by the factor
    /// b(u) of `Kernel`, with the inverse reduced pressure u.
    double wet_amplitude = 1;
    /// Correlation lengths [1] of the part of the Gaussian process that wet flow adds, along four
    /// coordinates in turn: x of the friction coefficient, q = sqrt(I) with the inertial number I,
    /// ln(1 + u/0.1) with the inverse reduced pressure u, and v of the bridge volume.
    double wet_x = 1, wet_q = 0.2, wet_u = 1, wet_v = 1;
    /// Factor [1] by which the squared standard errors of the training runs are multiplied, since
    /// the runs state their standard errors only approximately.
    double noise = 1;
    /// Between-run scatter, in the unit of the quantity: standard deviation between runs of equal
    /// parameters and different seeds, in addition to the stated standard errors of the runs.
    double between_run_scatter = 1e-3;

    /// Number of all hyperparameters (`count`), and number of the amplitudes and correlation
    /// lengths among the hyperparameters (`of_processes`). The amplitudes and correlation lengths
    /// come first; the last two hyperparameters describe the noise of the runs.
    static constexpr std::size_t count = 10, of_processes = 8;
    /// Column names of the hyperparameters in the file emulator.csv (`hyperparameters_name`), in
    /// the order of `as_array`.
    static constexpr std::array<std::string_view, count> names = {
        "dry_amplitude", "dry_friction", "dry_inertia", "wet_amplitude", "wet_friction",
        "wet_inertia",   "wet_pressure", "wet_volume",  "noise",         "between"};
    /// Returns the values of all ten hyperparameters, in the order in which the hyperparameters are
    /// declared.
    std::array<double, count> as_array() const;
    /// Returns hyperparameters with the values `values`, which are in the order of `as_array`.
    static Hyperparameters from_array(const std::array<double, count>& values);
};

/// Prior covariance of an emulated quantity f, a function of friction coefficient, inertial number
/// I, reduced pressure P* and bridge volume,
///     f = h(z).beta + g_dry(x, q) + b(u) [h_wet(z).gamma + g_wet(x, q, u, v)],
/// with the coordinates z = (x, q, u, v) of `Coordinates`, where q = sqrt(I) and u = 1/P*. The
/// vectors h and h_wet contain terms of polynomials. Their coefficients beta and gamma have broad
/// priors. The functions g_dry and g_wet are Gaussian processes of squared exponential covariance
/// with a correlation length for each coordinate. The correlation length for u applies to ln(1 +
/// u/0.1).
///
/// The kind of the quantity (`Domain`) determines b(u) and thus the dry limit u -> 0. For
/// `all_flow`, b = u. For `contacts`, b = 0 at u = 0 and b = 1 elsewhere. For `bridges`, b = 1 and
/// the dry terms h and g_dry are absent. The quasi-static limit I -> 0 of f is finite.
class Kernel {
  public:
    /// Makes the prior covariance of one emulated quantity.
    /// @param domain kind of the quantity
    /// @param unit typical size of the quantity, in the unit of the quantity; the prior standard
    ///        deviation of the coefficients of the polynomials is five times the typical size
    Kernel(Domain domain, const Hyperparameters& hyperparameters, double unit);

    /// Value of the emulated quantity at one place, or derivative of the quantity at the place
    /// (`Functional`), with the terms of the prior covariances that depend on the place alone.
    struct Prepared {
        int derivative = Functional::value;
        double u = 0;
        /// Coordinates [x, q, ln(1 + u/0.1), v] of the place, with x, q, u and v of `Coordinates`.
        std::array<double, coordinate_count> place{};
        /// Derivative of each entry of `place` with respect to the coordinate x, q, u or v on which
        /// the entry depends.
        std::array<double, coordinate_count> stretch{};
        /// Terms of the polynomial at the place, or derivatives of the terms.
        Eigen::RowVectorXd polynomial;
    };
    /// Computes the terms of the prior covariances that depend on the place of `functional` alone.
    /// `functional` is a value or a derivative of the emulated quantity.
    Prepared prepare(const Functional& functional) const;
    /// Computes, for the value of the emulated quantity at each of the places `at`, the terms of
    /// the prior covariances that depend on the place alone.
    std::vector<Prepared> prepare(const std::vector<Coordinates>& at) const;

    /// Returns the prior covariance between two values or derivatives of the emulated quantity, in
    /// the square of the unit of the quantity.
    double operator()(const Prepared& a, const Prepared& b) const {
        return coefficient_variance_ * a.polynomial.dot(b.polynomial) + of_processes(a, b);
    }
    /// Returns the contribution of the dry and the wet Gaussian process to the prior covariance
    /// between two values or derivatives of the emulated quantity. The contribution of the
    /// polynomials is left out.
    double of_processes(const Prepared& a, const Prepared& b) const;
    /// Returns the prior variance of each coefficient of the polynomials, in the square of the unit
    /// of the quantity. The coefficients are uncorrelated.
    double coefficient_variance() const { return coefficient_variance_; }
    /// Weighted sums of Gaussian functions (bells), one sum for each Gaussian process (dry and wet
    /// part). A sum has a bell at each place of a list of places. The weight of a bell is the
    /// product of the weight of the place, the variance of the process and the factor b(u), with
    /// the inverse reduced pressure u, by which `Kernel` multiplies the process at the place.
    using Known = std::vector<BellSums>;
    /// Returns the places of `values` with the weight of each place, in the form from which the
    /// function `sums` computes sums over the places.
    Known known(const std::vector<Prepared>& values, const Eigen::VectorXd& weights) const;
    /// Returns sum_p w_p k(p, at) over the places p stored in `known`, followed by the derivatives
    /// of the sum with respect to the coordinates x, q, u and v of `at`. Here w_p is the weight of
    /// the place p, and k is the prior covariance between the values at two places without the
    /// contribution of the polynomials.
    /// @param with_pressure whether the derivative with respect to u is needed; if false, the
    ///        derivative with respect to u may be incomplete
    std::array<double, 1 + coordinate_count> sums(const Known& known, const Prepared& at,
                                                  bool with_pressure) const;

    /// Returns the prior covariance matrix of values or derivatives of the emulated quantity. The
    /// matrix has a row and a column for each entry of `of`.
    Eigen::MatrixXd matrix(const std::vector<Prepared>& of) const;
    /// Returns the derivatives of tr(W K)/2 with respect to the logarithms of the first eight
    /// hyperparameters (amplitudes and correlation lengths). W is the symmetric matrix `weights`. K
    /// is the contribution of the Gaussian processes to the prior covariance matrix of `values`.
    /// The fit of the hyperparameters needs these derivatives.
    std::array<double, Hyperparameters::of_processes> half_traces(
        const std::vector<Prepared>& values, const Eigen::MatrixXd& weights) const;

    const Hyperparameters& hyperparameters() const { return hyperparameters_; }

  private:
    /// Form of the factor b(u) by which a Gaussian process is multiplied, with the inverse reduced
    /// pressure u: 1 (`one`), u (`linear`), or 0 at u = 0 and 1 elsewhere (`step`).
    enum class Amplitude { one, linear, step };
    /// One of the two Gaussian processes of the kernel, for dry or for wet flow, with the form of
    /// the factor b(u) by which the process is multiplied. Here u is the inverse reduced pressure.
    /// For dry flow, b = 1.
    struct Part {
        /// Variance of the Gaussian process before the multiplication by the factor b(u), in the
        /// square of the unit of the quantity.
        double variance = 0;
        /// Inverse squares of the correlation lengths of the Gaussian process, one for each
        /// coordinate. The entry is 0 for a coordinate on which the process does not depend.
        std::array<double, coordinate_count> inverse_squares{};
        Amplitude amplitude = Amplitude::one;
    };
    /// Returns the value [1] at the place `at` of the factor b(u) by which the Gaussian process
    /// `part` is multiplied, with the inverse reduced pressure u.
    static double amplitude(const Part& part, const Prepared& at);
    /// Returns the contribution of one Gaussian process to the prior covariance between two values
    /// or derivatives, including the factor b(u) by which the process is multiplied.
    static double of_part(const Part& part, const Prepared& a, const Prepared& b);

    Hyperparameters hyperparameters_;
    std::vector<Part> parts_;
    /// For each Gaussian process in `parts_`, whether the process describes dry flow.
    std::vector<bool> is_dry_;
    Basis basis_;
    /// Number of terms of the polynomial of dry flow, which are the first terms of `basis_`.
    Eigen::Index dry_terms_ = 0;
    /// Whether the polynomial of wet flow jumps to zero at u = 0 (dry grains), as for
    /// `Domain::contacts`.
    bool steps_ = false;
    double coefficient_variance_;
};

}  // namespace pendular
