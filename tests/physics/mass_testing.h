// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <functional>
#include <string>

#include "core/error.h"

namespace poinsot::physics {

/// Returns the largest difference of an entry, relative to the largest expected entry.
template <typename Measured, typename Expected>
double relative(const Measured& measured, const Expected& expected) {
  return (measured - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// Returns the message of the kPhysics error that `make` throws, or "accepted".
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
