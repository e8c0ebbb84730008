#pragma once

#include <cstddef>

/// PENDULAR_SIMD_CLONES compiles a function once per instruction set; the version for the processor
/// is selected when the program starts. Without fused multiply-adds (-ffp-contract=off), all
/// versions give identical bits. With sanitizers, only the default version is compiled, because the
/// resolver (the function that selects the version) is called before the sanitizers are
/// initialised.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PENDULAR_SIMD_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define PENDULAR_SIMD_CLONES
#endif

namespace pendular::dem {

/// Vector of three components in a register of four lanes, the fourth unused. Operators work
/// component by component, so that every instruction set of the processor gives identical bits.
struct alignas(32) Vector {
    using Lanes = double __attribute__((vector_size(32)));
    Lanes lanes{};

    constexpr Vector() = default;
    constexpr Vector(double x, double y, double z, double free = 0) : lanes{x, y, z, free} {}
    constexpr explicit Vector(Lanes all) : lanes(all) {}

    double operator[](std::size_t k) const { return lanes[k]; }
    /// Returns a writable reference to component k. This moves the vector from its register to
    /// memory; an assignment to `lanes` does not.
    double& operator[](std::size_t k) { return reinterpret_cast<double*>(&lanes)[k]; }

    Vector& operator+=(const Vector& other) {
        lanes += other.lanes;
        return *this;
    }
    Vector& operator-=(const Vector& other) {
        lanes -= other.lanes;
        return *this;
    }
    friend Vector operator+(const Vector& a, const Vector& b) { return Vector(a.lanes + b.lanes); }
    friend Vector operator-(const Vector& a, const Vector& b) { return Vector(a.lanes - b.lanes); }
    friend Vector operator-(const Vector& a) { return Vector(-a.lanes); }
    friend Vector operator*(double factor, const Vector& a) { return Vector(factor * a.lanes); }
    /// Returns the product component by component.
    friend Vector operator*(const Vector& a, const Vector& b) { return Vector(a.lanes * b.lanes); }
    friend bool operator==(const Vector& a, const Vector& b) {
        return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    }
};

inline double dot(const Vector& a, const Vector& b) {
    const Vector p = a * b;
    return p[0] + p[1] + p[2];
}

}  // namespace pendular::dem
