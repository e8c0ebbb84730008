#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace pendular {

/// How well errors of readings are known: entry k of the readings has an error of kind `kind[k]`,
/// whose size was estimated with `freedom[kind]` degrees of freedom; infinite where it is known.
struct ErrorKnowledge {
    std::vector<std::size_t> kind;
    std::vector<double> freedom;

    /// n entries whose errors are known.
    static ErrorKnowledge known(Eigen::Index n);
};

/// Errors of the readings as they come, in units of what they are believed to be: of each kind
///     z sqrt(nu/chi2_nu),   z standard normal.
/// The same draws serve every test of a diagnosis, so that its tests together are wrong as often as
/// is said.
class NullDraws {
  public:
    NullDraws(const ErrorKnowledge& knowledge, std::uint64_t seed, Eigen::Index count);

    /// A column for each draw.
    const Eigen::MatrixXd& errors() const { return errors_; }
    Eigen::Index count() const { return errors_.cols(); }

    /// Probability of a statistic at least as large as `observed`, from its values in the draws:
    /// (1 + how many are) / (1 + draws).
    static double p(double observed, const Eigen::VectorXd& drawn);

  private:
    Eigen::MatrixXd errors_;
};

}  // namespace pendular
