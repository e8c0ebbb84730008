#pragma once

/// Compiles a function once per instruction set; the program picks one version when it starts.
/// Without fused multiply-adds (-ffp-contract=off) all versions give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define PENDULAR_SIMD_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define PENDULAR_SIMD_CLONES
#endif
