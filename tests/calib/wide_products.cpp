// Products of matrices with the widest instructions of the processor.
#include "calib/emulator/wide_products.h"

#include <gtest/gtest.h>

#include <random>

namespace wide_products_test {

using namespace pendular;

/// Matrix of random elements between -1 and 1.
Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns) {
    static std::mt19937_64 random(5);
    std::uniform_real_distribution<double> element(-1, 1);
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return element(random); });
}

TEST(WideProducts, AreThoseOfEigen) {
    for (const Eigen::Index n : {1, 7, 64, 301}) {
        const Eigen::MatrixXd a = random_matrix(n, 5), wide = random_matrix(n, 20);
        const auto part = wide.middleCols(3, 11);
        EXPECT_TRUE(transposed_product(a, part).isApprox(a.transpose() * part, 1e-13)) << n;
        EXPECT_TRUE(transposed_product(a, wide.block(0, 0, n, 4))
                        .isApprox(a.transpose() * wide.leftCols(4), 1e-13));
        Eigen::MatrixXd lower = random_matrix(n, n) / static_cast<double>(n);
        lower.diagonal().array() += 2;  // what stands above the diagonal is not read
        const Eigen::MatrixXd solved = solve_lower(lower, wide);
        EXPECT_TRUE((lower.triangularView<Eigen::Lower>() * solved).isApprox(wide, 1e-12)) << n;
    }
    EXPECT_EQ(transposed_product(random_matrix(3, 0), random_matrix(3, 2)).size(), 0);
    EXPECT_EQ(solve_lower(random_matrix(3, 3), random_matrix(3, 0)).cols(), 0);
}

}  // namespace wide_products_test
