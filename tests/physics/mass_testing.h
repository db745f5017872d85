// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <functional>
#include <string>

#include "core/error.h"

namespace poinsot::physics {

/// The largest difference of an entry, of the largest entry expected.
template <typename Measured, typename Expected>
double relative(const Measured& measured, const Expected& expected) {
  return (measured - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// What was said on refusal, which must be of a physical kind.
inline std::string refusal(const std::function<void()>& make) {
  try {
    make();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kPhysics);
    return error.message();
  }
  return "accepted";
}

}  // namespace poinsot::physics
