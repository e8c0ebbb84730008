#include "analysis/null_draws.h"

#include <cmath>
#include <random>

namespace pendular {

ErrorKnowledge ErrorKnowledge::known(Eigen::Index n) {
    return {std::vector<std::size_t>(static_cast<std::size_t>(n), 0), {INFINITY}};
}

NullDraws::NullDraws(const ErrorKnowledge& knowledge, std::uint64_t seed, Eigen::Index count)
    : errors_(static_cast<Eigen::Index>(knowledge.kind.size()), count) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (Eigen::Index draw = 0; draw < count; ++draw) {
        std::vector<double> believed;  // true error over the believed one
        for (const double freedom : knowledge.freedom) {
            believed.push_back(
                std::isfinite(freedom)
                    ? std::sqrt(freedom / std::chi_squared_distribution<double>(freedom)(random))
                    : 1.0);
        }
        for (Eigen::Index k = 0; k < errors_.rows(); ++k) {
            errors_(k, draw) =
                normal(random) * believed[knowledge.kind[static_cast<std::size_t>(k)]];
        }
    }
}

double NullDraws::p(double observed, const Eigen::VectorXd& drawn) {
    const auto as_large = (drawn.array() >= observed).count();
    return static_cast<double>(1 + as_large) / static_cast<double>(1 + drawn.size());
}

}  // namespace pendular
