// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace poinsot::physics {

/// Expects residual <= bound. If POINSOT_SHOW_RESIDUALS is set, prints the residual, which tests note as
/// "measured".
inline void expectResidual(const char* what, double residual, double bound) {
  if (std::getenv("POINSOT_SHOW_RESIDUALS")) std::printf("  %-52s %.3g (bound %.3g)\n", what, residual, bound);
  EXPECT_LE(residual, bound) << what;
}

}  // namespace poinsot::physics
