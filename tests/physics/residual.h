// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace poinsot::physics {

/// Asserts residual <= bound. With POINSOT_SHOW_RESIDUALS set, prints the residual: the figure noted beside the
/// bound.
inline void expectResidual(const char* what, double residual, double bound) {
  if (std::getenv("POINSOT_SHOW_RESIDUALS")) std::printf("  %-52s %.3g (bound %.3g)\n", what, residual, bound);
  EXPECT_LE(residual, bound) << what;
}

}  // namespace poinsot::physics
