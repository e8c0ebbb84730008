#pragma once

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
