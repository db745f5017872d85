// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/error.h"
#include "geometry/mesh.h"
#include "geometry/primitives.h"

namespace poinsot::geometry {

struct Sample {
  const char* name;
  Mesh mesh;
};

inline std::vector<Sample> primitives(int segments) {
  return {{"box", boxMesh({1.2, .9, .5})},
          {"prism", lPrismMesh({3, 2}, .5, .25)},
          {"tetrahedron", tetrahedronMesh(1)},
          {"cube", cubeMesh(1)},
          {"octahedron", octahedronMesh(1)},
          {"dodecahedron", dodecahedronMesh(1)},
          {"icosahedron", icosahedronMesh(1)},
          {"ellipsoid", ellipsoidMesh({1.3, .8, .5}, 3)},
          {"hemisphere", hemisphereMesh(.45, segments)},
          {"cone", frustumMesh(.45, 0, -.425, 1.275, segments)},
          {"cone, apex below", frustumMesh(0, .45, 0, 1, segments)},
          {"frustum", frustumMesh(.45, .3, -1, 1, segments)},
          {"capsule", capsuleMesh(.45, 1, segments)},
          {"torus", torusMesh(1.1, .35, segments)},
          {"tube", tubeMesh(.45, .3, 1.7, segments)}};
}

/// Returns the message of the error that `act` throws, or "accepted".
inline std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const core::Error& error) {
    return error.what();
  }
  return "accepted";
}

/// Source of random numbers from a fixed seed.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace poinsot::geometry
