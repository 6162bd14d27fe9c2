// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Compiles a function for plain x86-64 and for AVX2, and picks one when the library is loaded: one package serves
/// every robot. Both give the same bits, since nothing is contracted (-ffp-contract=off). Elsewhere it does nothing,
/// nor under the thread sanitizer: what picks runs before the sanitizer does.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__linux__) && \
    !defined(__SANITIZE_THREAD__)
#define HIDWA_VECTOR_CLONES __attribute__((noinline, target_clones("avx2", "default")))
#else
#define HIDWA_VECTOR_CLONES
#endif

namespace hidwa_local_planner {

/// Four numbers that are computed with as one.
typedef double Four __attribute__((vector_size(4 * sizeof(double))));

}  // namespace hidwa_local_planner
