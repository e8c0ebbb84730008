// Compiled for processors with AVX2 and FMA (calib/CMakeLists.txt). Eigen has another name in this
// file: else the linker might take these versions of Eigen's functions for the whole program, which
// then would not run on older processors.
#define Eigen EigenAvx2

#include "calib/emulator/products_avx2.h"

#include <Eigen/Core>

namespace pendular::avx2 {

using Matrix = Eigen::Map<Eigen::MatrixXd>;
using ConstMatrix = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

void solve_lower(const double* lower, std::ptrdiff_t n, double* right, std::ptrdiff_t m) {
    Matrix solution(right, n, m);
    ConstMatrix(lower, n, n, Eigen::OuterStride<>(n))
        .triangularView<Eigen::Lower>()
        .solveInPlace(solution);
}

void transposed_product(const double* a, std::ptrdiff_t n, std::ptrdiff_t m, const double* b,
                        std::ptrdiff_t stride, std::ptrdiff_t k, double* result) {
    Matrix(result, m, k).noalias() = ConstMatrix(a, n, m, Eigen::OuterStride<>(n)).transpose() *
                                     ConstMatrix(b, n, k, Eigen::OuterStride<>(stride));
}

}  // namespace pendular::avx2
