// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <random>

namespace poinsot::render {

/// Random numbers that are the same on all machines: mt19937_64 is portable, the library's distributions are not.
/// Draw several in braces or statements, because compilers differ in the order in which they evaluate a function's
/// arguments.
class Random {
 public:
  float in(float low, float high) {
    return low + (high - low) * static_cast<float>(static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  glm::vec3 direction() {
    for (;;) {
      const glm::vec3 v{in(-1, 1), in(-1, 1), in(-1, 1)};
      const float n = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
      if (n > 0.1f && n < 1) return v / n;
    }
  }
  glm::vec3 across(glm::vec3 axis) {
    const glm::vec3 v = direction();
    const glm::vec3 w(axis.y * v.z - axis.z * v.y, axis.z * v.x - axis.x * v.z, axis.x * v.y - axis.y * v.x);
    return w / std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
  }

 private:
  std::mt19937_64 engine_{20261121};
};

}  // namespace poinsot::render
