#include "calib/emulator/bell_sums.h"

#include <cstdint>
#include <cstring>

#include "sim/dem/vector.h"

namespace pendular {
namespace {

/// Bells at a time: the doubles of the widest vector registers, of 512 bits.
constexpr std::size_t lane_count = 8;
using Lanes = double __attribute__((vector_size(sizeof(double) * lane_count)));
using LaneBits = std::int64_t __attribute__((vector_size(sizeof(double) * lane_count)));

/// Coefficients 1/k! of the series of exp, from k = 13 to 0: the next term is below 4e-18 where
/// |x| <= ln(2)/2.
constexpr double inverse_factorials[] = {1.0 / 6227020800,
                                         1.0 / 479001600,
                                         1.0 / 39916800,
                                         1.0 / 3628800,
                                         1.0 / 362880,
                                         1.0 / 40320,
                                         1.0 / 5040,
                                         1.0 / 720,
                                         1.0 / 120,
                                         1.0 / 24,
                                         1.0 / 6,
                                         1.0 / 2,
                                         1.0,
                                         1.0};

/// Replaces each exponent, at most 0, by its exponential; exponents below -700 count as -700.
///     exp(x) = 2^n exp(r),  n = round(x/ln 2),  r = x - n ln 2
[[gnu::always_inline]] inline void exponentiate(Lanes& x) {
    // Adding 1.5 2^52 leaves n in the lowest bits of the sum.
    constexpr double to_bits = 6755399441055744.0;
    constexpr double log2_of_e = 1.4426950408889634074;
    // ln 2 in two parts, the first with zeros at its end, so that n times it is exact.
    constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
    x = x < -700.0 ? Lanes{} - 700.0 : x;
    const Lanes shifted = x * log2_of_e + to_bits;
    const Lanes n = shifted - to_bits;
    const Lanes r = x - n * ln2_high - n * ln2_low;
    Lanes series = Lanes{} + inverse_factorials[0];
    for (std::size_t k = 1; k < std::size(inverse_factorials); ++k) {
        series = series * r + inverse_factorials[k];
    }
    const LaneBits power = ((LaneBits)shifted + 1023) << 52;  // 2^n
    x = series * (Lanes)power;
}

template <std::size_t coordinates>
[[gnu::always_inline]] inline void sum_blocks(const double* block, std::size_t blocks,
                                              const double* at, const double* inverse_squares,
                                              double* result) {
    Lanes sums[1 + coordinates] = {};
    for (std::size_t b = 0; b < blocks; ++b, block += (coordinates + 1) * lane_count) {
        Lanes apart[coordinates], exponent = {}, weight;
        for (std::size_t k = 0; k < coordinates; ++k) {
            std::memcpy(&apart[k], block + k * lane_count, sizeof(Lanes));
            apart[k] -= at[k];
            exponent -= 0.5 * inverse_squares[k] * apart[k] * apart[k];
        }
        std::memcpy(&weight, block + coordinates * lane_count, sizeof(Lanes));
        exponentiate(exponent);
        const Lanes term = weight * exponent;
        sums[0] += term;
        for (std::size_t k = 0; k < coordinates; ++k) {
            sums[1 + k] += term * apart[k];
        }
    }
    for (std::size_t k = 0; k <= coordinates; ++k) {
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            result[k] += sums[k][lane];
        }
    }
}

PENDULAR_SIMD_CLONES
void add_sums(std::size_t coordinates, const double* blocks, std::size_t count, const double* at,
              const double* inverse_squares, double* result) {
    if (coordinates == 2) {
        sum_blocks<2>(blocks, count, at, inverse_squares, result);
    } else if (coordinates == 4) {
        sum_blocks<4>(blocks, count, at, inverse_squares, result);
    } else {
        sum_blocks<5>(blocks, count, at, inverse_squares, result);
    }
}

}  // namespace

void BellSums::add(const Place& place, double weight) {
    if (weight == 0) return;
    const std::size_t block_size = (coordinates_ + 1) * lane_count, lane = count_ % lane_count;
    if (lane == 0) blocks_.resize(blocks_.size() + block_size);
    double* const block = blocks_.data() + blocks_.size() - block_size;
    for (std::size_t k = 0; k < coordinates_; ++k) {
        block[k * lane_count + lane] = place[k];
    }
    block[coordinates_ * lane_count + lane] = weight;
    ++count_;
}

std::array<double, 1 + BellSums::most_coordinates> BellSums::at(const Place& at) const {
    std::array<double, 1 + most_coordinates> result{};
    add_sums(coordinates_, blocks_.data(), (count_ + lane_count - 1) / lane_count, at.data(),
             inverse_squares_.data(), result.data());
    return result;
}

}  // namespace pendular
