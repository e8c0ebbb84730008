#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "calib/emulator/basis.h"

namespace pendular {

/// Number of coordinates for derivatives: x, q, u, v of `Coordinates`.
constexpr int coordinate_count = 4;

/// Value of a function at a place, or its derivative in one coordinate.
struct Functional {
    static constexpr int value = -1;
    Coordinates at;
    int derivative = value;
};

/// Kind of an emulated quantity, which decides its dry limit.
enum class Domain {
    all_flow,  ///< defined for dry grains too, which it goes over into as 1/P* -> 0
    contacts,  ///< defined for dry grains too, with a step: in wet flow, grains without contacts
               ///< hang in bridges
    bridges,   ///< of liquid bridges, which keep a structure where their force no longer matters
};

/// Hyperparameters of a Gaussian process; all positive.
struct Hyperparameters {
    double dry_amplitude = 1;  ///< of what the polynomial leaves of dry flow, unit of the quantity
    double dry_x = 1, dry_q = 0.2;  ///< lengths over which the dry part changes
    double wet_amplitude = 1;       ///< of what it leaves of capillarity, per 1/P*
    double wet_x = 1, wet_q = 0.2, wet_u = 1, wet_v = 1;
    double noise = 1;                   ///< factor on the runs' stated variances
    double between_run_scatter = 1e-3;  ///< between-run scatter beyond that, unit of the quantity

    static constexpr std::size_t count = 10, of_processes = 8;  ///< the last two describe noise
    static constexpr std::array<std::string_view, count> names = {
        "dry_amplitude", "dry_friction", "dry_inertia", "wet_amplitude", "wet_friction",
        "wet_inertia",   "wet_pressure", "wet_volume",  "noise",         "between"};
    std::array<double, count> as_array() const;
    static Hyperparameters from_array(const std::array<double, count>& values);
};

/// Covariance of a random function of friction, inertial number, reduced pressure and bridge
/// volume that has the limits physics demands, before any run is known:
///     f = h(z).beta + g_dry(x, q) + b(u) [h_wet(z).gamma + g_wet(x, q, u, v)],
/// h polynomials with coefficients that are hardly known, g Gaussian processes of squared
/// exponential covariance with a length for every coordinate (that of u in ln(1 + u/0.1)), b(u) =
/// u, or 1 from the least u on for contacts. Dry flow (u = 0) thus does not depend on the bridge
/// volume and the capillary part vanishes with 1/P*; q = sqrt(I) makes the quasi-static limit
/// finite, approached as some power of I between 1/2 and 1.
class Kernel {
  public:
    /// `unit`: a typical size of the quantity, for coefficients to be large beside.
    Kernel(Domain domain, const Hyperparameters& hyperparameters, double unit);

    /// Functional with the terms that all its covariances need, computed once.
    struct Prepared {
        int derivative = Functional::value;
        double u = 0;
        std::array<double, coordinate_count> place{};    ///< in coordinates of distance
        std::array<double, coordinate_count> stretch{};  ///< their derivatives by u and the others
        Eigen::RowVectorXd polynomial;                   ///< h, or its derivative
    };
    Prepared prepare(const Functional& functional) const;
    std::vector<Prepared> prepare(const std::vector<Coordinates>& at) const;

    /// Covariance of two functionals.
    double operator()(const Prepared& a, const Prepared& b) const {
        return coefficient_variance_ * a.polynomial.dot(b.polynomial) + of_processes(a, b);
    }
    /// Covariance of the Gaussian processes alone, without the polynomial.
    double of_processes(const Prepared& a, const Prepared& b) const;
    /// Variance of each coefficient of the polynomial, whose terms are uncorrelated.
    double coefficient_variance() const { return coefficient_variance_; }
    /// Values known at some places, side by side for sums over them.
    struct Known {
        std::array<Eigen::ArrayXd, coordinate_count> place;
        Eigen::ArrayXXd weights;  ///< times variance and amplitude there, a column per process
    };
    Known known(const std::vector<Prepared>& values, const Eigen::VectorXd& weights) const;
    /// The sum of weight x of_processes(known, at), then its derivatives by the coordinates of
    /// `at`, which are garbage where they are not asked for.
    std::array<double, 1 + coordinate_count> sums(const Known& known, const Prepared& at,
                                                  bool with_derivatives) const;

    /// Covariance matrix of functionals.
    Eigen::MatrixXd matrix(const std::vector<Prepared>& of) const;
    /// Derivatives of half the trace of W K by the logarithms of the hyperparameters of processes,
    /// K being the matrix of values; W symmetric.
    std::array<double, Hyperparameters::of_processes> half_traces(
        const std::vector<Prepared>& values, const Eigen::MatrixXd& weights) const;

    const Hyperparameters& hyperparameters() const { return hyperparameters_; }

  private:
    enum class Amplitude { one, linear, step };
    /// One process g with its amplitude function.
    struct Part {
        double variance = 0;
        std::array<double, coordinate_count> inverse_squares{};  ///< of the lengths; 0: no matter
        Amplitude amplitude = Amplitude::one;
    };
    static double amplitude(const Part& part, const Prepared& at);
    static double of_part(const Part& part, const Prepared& a, const Prepared& b);

    Hyperparameters hyperparameters_;
    std::vector<Part> parts_;
    std::vector<bool> is_dry_;  ///< of the parts
    Basis basis_;
    Eigen::Index dry_terms_ = 0;
    bool steps_ = false;  ///< whether the wet terms begin with a step
    double coefficient_variance_;
};

}  // namespace pendular
