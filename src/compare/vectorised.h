// SPDX-License-Identifier: Apache-2.0
#pragma once

// Attribute of functions with loops over the columns of a row. The compiler makes two versions of such a function.
// The AVX2 version computes the same results, four values per instruction; it has no FMA, which would round
// differently. Builds for ThreadSanitizer have one version, because selecting a version before ThreadSanitizer is
// ready would end the program.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
#define POINSOT_VECTORISED [[gnu::target_clones("avx2", "default")]]
#else
#define POINSOT_VECTORISED
#endif
