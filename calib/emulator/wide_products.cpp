#include "calib/emulator/wide_products.h"

#include <utility>

#include "calib/emulator/products_avx2.h"

namespace pendular {
#ifdef PENDULAR_AVX2_PRODUCTS
namespace {

/// Returns whether the processor has the instructions of products_avx2.cpp.
bool has_avx2() {
    static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return has;
}

}  // namespace
#endif

Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& lower, Eigen::MatrixXd right) {
#ifdef PENDULAR_AVX2_PRODUCTS
    if (has_avx2()) {
        avx2::solve_lower(lower.data(), lower.rows(), right.data(), right.cols());
        return right;
    }
#endif
    lower.triangularView<Eigen::Lower>().solveInPlace(right);
    return right;
}

Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a,
                                   const Eigen::Ref<const Eigen::MatrixXd>& b) {
#ifdef PENDULAR_AVX2_PRODUCTS
    if (has_avx2()) {
        Eigen::MatrixXd result(a.cols(), b.cols());
        avx2::transposed_product(a.data(), a.rows(), a.cols(), b.data(), b.outerStride(), b.cols(),
                                 result.data());
        return result;
    }
#endif
    return a.transpose() * b;
}

}  // namespace pendular
