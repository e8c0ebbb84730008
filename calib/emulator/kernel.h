#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "calib/emulator/basis.h"
#include "calib/emulator/bell_sums.h"

namespace pendular {

/// Number of the coordinates x, q, u and v.
constexpr int coordinate_count = 4;
/// Index of u, the inverse reduced pressure, among the coordinates.
constexpr int pressure_coordinate = 2;

/// Value of a function of `Coordinates` at one place, or its derivative by one of them.
struct Functional {
    static constexpr int value = -1;
    Coordinates at;
    int derivative = value;  ///< 0 for x, 1 for q, 2 for u, 3 for v, or `value`
};

/// Kind of an emulated quantity, which determines its behaviour in the dry limit 1/P* -> 0.
enum class Domain {
    /// Defined for wet and dry grains and continuous as 1/P* -> 0.
    all_flow,
    /// Defined for wet and dry grains, with a step at 1/P* = 0, such as the number of contacts per
    /// grain: bridges, however small their force, hold grains that have no contacts in dry flow.
    contacts,
    /// Defined for wet grains only, with a finite limit as 1/P* -> 0: bridges exist without force.
    bridges,
};

/// Hyperparameters of the Gaussian process of one emulated quantity (`Kernel`), all positive.
struct Hyperparameters {
    /// Standard deviation of g_dry, in the unit of the quantity.
    double dry_amplitude = 1;
    /// Correlation lengths [1] of g_dry along x and q.
    double dry_x = 1, dry_q = 0.2;
    /// Standard deviation of g_wet, before the factor b(u), in the unit of the quantity.
    double wet_amplitude = 1;
    /// Correlation lengths [1] of g_wet along x, q, ln(1 + u/0.1) and v.
    double wet_x = 1, wet_q = 0.2, wet_u = 1, wet_v = 1;
    /// Factor [1] of the squared standard errors of the runs, which state them only approximately.
    double noise = 1;
    /// Between-run scatter, in the unit of the quantity.
    double between_run_scatter = 1e-3;

    /// Number of all hyperparameters, and of the amplitudes and lengths, which come first.
    static constexpr std::size_t count = 10, of_processes = 8;
    /// Column names in emulator.csv (`hyperparameters_name`).
    static constexpr std::array<std::string_view, count> names = {
        "dry_amplitude", "dry_friction", "dry_inertia", "wet_amplitude", "wet_friction",
        "wet_inertia",   "wet_pressure", "wet_volume",  "noise",         "between"};
    /// Returns the values of all hyperparameters, in the order of their declaration.
    std::array<double, count> as_array() const;
    /// Returns hyperparameters with the values `values`, in the order of `as_array`.
    static Hyperparameters from_array(const std::array<double, count>& values);
};

/// Prior covariance of an emulated quantity f,
///     f = h(z).beta + g_dry(x, q) + b(u) [h_wet(z).gamma + g_wet(x, q, u, v)],
/// with the coordinates z = (x, q, u, v) of `emulated::place_of`, where q = sqrt(I) and u = 1/P*.
/// The vectors h and h_wet contain terms of polynomials. Their coefficients beta and gamma have
/// broad priors. The functions g_dry and g_wet are Gaussian processes of squared exponential
/// covariance with a correlation length for each coordinate. The correlation length for u applies
/// to ln(1 + u/0.1).
///
/// The kind of the quantity (`Domain`) determines b(u) and thus the dry limit u -> 0. For
/// `all_flow`, b = u. For `contacts`, b = 0 at u = 0 and b = 1 elsewhere. For `bridges`, b = 1 and
/// the dry terms h and g_dry are absent. The quasi-static limit I -> 0 of f is finite.
class Kernel {
  public:
    /// @param unit typical size of the quantity, in its own unit; the prior standard deviation of
    ///        the coefficients of the polynomials is five times this size
    Kernel(Domain domain, const Hyperparameters& hyperparameters, double unit);

    /// Value or derivative with the terms of its covariances that depend on its place alone.
    struct Prepared {
        int derivative = Functional::value;
        double u = 0;
        std::array<double, coordinate_count> place{};  ///< [x, q, ln(1 + u/0.1), v]
        /// Derivative of each entry of `place` with respect to x, q, u or v.
        std::array<double, coordinate_count> stretch{};
        Eigen::RowVectorXd polynomial;  ///< terms h and b h_wet, or their derivatives
    };
    /// Computes the terms of the covariances that depend on the place of `functional` alone.
    Prepared prepare(const Functional& functional) const;
    /// Computes `Prepared` for the value at each of the places `at`.
    std::vector<Prepared> prepare(const std::vector<Coordinates>& at) const;

    /// Returns the prior covariance between two values or derivatives.
    double operator()(const Prepared& a, const Prepared& b) const {
        return coefficient_variance_ * a.polynomial.dot(b.polynomial) + of_processes(a, b);
    }
    /// Returns the prior covariance without the contribution of the polynomials.
    double of_processes(const Prepared& a, const Prepared& b) const;
    /// Returns the prior variance of each coefficient of the polynomials, which are uncorrelated.
    double coefficient_variance() const { return coefficient_variance_; }
    /// Sum of bells for each of g_dry and g_wet, with a bell at each of given places. Its weight is
    /// the weight of the place times the variance of the process and b(u) at the place.
    using Known = std::vector<BellSums>;
    /// Returns the places of `values` with their weights in the form that `sums` needs.
    Known known(const std::vector<Prepared>& values, const Eigen::VectorXd& weights) const;
    /// Returns sum_p w_p k(p, at) over the places p of `known`, with the weights w_p and k of
    /// of_processes(), then its derivatives with respect to x, q, u and v of `at`.
    /// @param with_pressure if false, the derivative with respect to u may be incomplete
    std::array<double, 1 + coordinate_count> sums(const Known& known, const Prepared& at,
                                                  bool with_pressure) const;

    /// Returns the prior covariance matrix of values or derivatives.
    Eigen::MatrixXd matrix(const std::vector<Prepared>& of) const;
    /// Returns the derivatives of tr(W K)/2 with respect to the logarithms of the amplitudes and
    /// lengths, with the symmetric matrix `weights` (W) and K of of_processes() between `values`.
    std::array<double, Hyperparameters::of_processes> half_traces(
        const std::vector<Prepared>& values, const Eigen::MatrixXd& weights) const;

    const Hyperparameters& hyperparameters() const { return hyperparameters_; }

  private:
    /// Form of b(u): 1, u, or a step from 0 at u = 0 to 1.
    enum class Amplitude { one, linear, step };
    /// One of g_dry and g_wet, with its factor b(u) (1 for g_dry).
    struct Part {
        double variance = 0;  ///< before the factor b(u)
        /// Inverse squares of the correlation lengths; 0 for coordinates without influence.
        std::array<double, coordinate_count> inverse_squares{};
        Amplitude amplitude = Amplitude::one;
    };
    static double amplitude(const Part& part, const Prepared& at);
    /// Returns the prior covariance due to one process, including b(u).
    static double of_part(const Part& part, const Prepared& a, const Prepared& b);

    Hyperparameters hyperparameters_;
    std::vector<Part> parts_;
    std::vector<bool> is_dry_;  ///< for each of `parts_`
    Basis basis_;
    Eigen::Index dry_terms_ = 0;  ///< number of terms h, the first ones of `basis_`
    /// Whether h_wet jumps to zero at u = 0, as for `Domain::contacts`.
    bool steps_ = false;
    double coefficient_variance_;
};

}  // namespace pendular
