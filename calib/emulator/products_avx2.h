#pragma once

#include <cstddef>

// Matrix products for processors with the instructions AVX2 and FMA only. All matrices are stored
// by columns, without gaps unless stated. Pointers instead of Eigen's types, since Eigen has
// another name where these functions are compiled.
namespace pendular::avx2 {

/// Solves L X = B in place: replaces the n x m matrix `right` (B) by X. L is the lower triangle of
/// the n x n matrix `lower`.
void solve_lower(const double* lower, std::ptrdiff_t n, double* right, std::ptrdiff_t m);

/// Sets the m x k matrix `result` to A' B, for an n x m matrix `a` (A) and an n x k matrix `b` (B).
/// @param stride distance in memory between the starts of successive columns of `b`, counted in
///        elements of type double
void transposed_product(const double* a, std::ptrdiff_t n, std::ptrdiff_t m, const double* b,
                        std::ptrdiff_t stride, std::ptrdiff_t k, double* result);

}  // namespace pendular::avx2
