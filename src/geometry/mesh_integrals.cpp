// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_integrals.h"

#include <array>
#include <cmath>

#include "geometry/mesh_expectations.h"

namespace poinsot::geometry {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Neumaier's compensated sum: adding up a million triangles loses no digits.
class Sum {
 public:
  void add(double term) {
    const double next = total_ + term;
    rest_ += std::fabs(total_) >= std::fabs(term) ? (total_ - next) + term : (term - next) + total_;
    total_ = next;
  }
  double value() const { return total_ + rest_; }

 private:
  double total_ = 0, rest_ = 0;
};

/// Integrals over the inside of a mesh, about the origin of the coordinates.
struct Moments {
  Sum volume;                 // ∫dV
  std::array<Sum, 3> first;   // first moments ∫x, ∫y, ∫z
  std::array<Sum, 6> second;  // second moments ∫xx, ∫yy, ∫zz, ∫yz, ∫zx, ∫xy

  void add(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double det = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0]);
    const Vector3d s = a + b + c;
    volume.add(det / 6);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const auto at = static_cast<std::size_t>(i);
      first[at].add(det * s[i] / 24);
      second[at].add(det * (s[i] * s[i] + a[i] * a[i] + b[i] * b[i] + c[i] * c[i]) / 120);
      second[at + 3].add(det * (s[j] * s[k] + a[j] * a[k] + b[j] * b[k] + c[j] * c[k]) / 120);
    }
  }

  Vector3d centre() const {
    const double V = volume.value();
    return {first[0].value() / V, first[1].value() / V, first[2].value() / V};
  }
};

struct Frame {
  Vector3d origin_M = Vector3d::Zero();
  int exponent = 0;  // lengths are divided by 2^exponent, so that fifth powers neither overflow nor underflow
};

Frame frameOf(const Mesh& mesh) {
  const Bounds bounds = boundsOf(mesh);
  Frame frame{bounds.centre_M(), 0};
  std::frexp(bounds.size_m().maxCoeff(), &frame.exponent);
  return frame;
}

Moments momentsAbout(const Mesh& mesh, const Frame& frame) {
  const double scale = std::ldexp(1.0, -frame.exponent);
  Moments moments;
  const auto vertex = [&](std::uint32_t i) -> Vector3d { return (mesh.vertices_M[i] - frame.origin_M) * scale; };
  for (const Mesh::Triangle& t : mesh.triangles) moments.add(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  return moments;
}

/// Returns the inertia tensor per volume about the centre c: tr(C) 1 - C, where C contains the second moments per
/// volume about c (eq 14).
Matrix3d inertiaPerVolume(const Moments& moments, const Vector3d& c) {
  const double V = moments.volume.value();
  Matrix3d I;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const auto squareOf = [&](int axis) {
      return moments.second[static_cast<std::size_t>(axis)].value() / V - c[axis] * c[axis];
    };
    I(i, i) = squareOf(j) + squareOf(k);
    I(j, k) = I(k, j) = c[j] * c[k] - moments.second[static_cast<std::size_t>(i) + 3].value() / V;
  }
  return I;
}

}  // namespace

MeshIntegrals integrals(const Mesh& mesh) {
  expectIndicesInRange(mesh);
  expectFinite(mesh);
  Frame frame = frameOf(mesh);
  const double scale = std::ldexp(1.0, frame.exponent);
  frame.origin_M += momentsAbout(mesh, frame).centre() * scale;
  const Moments moments = momentsAbout(mesh, frame);
  const Vector3d rest = moments.centre();
  return {moments.volume.value() * scale * scale * scale, frame.origin_M + rest * scale,
          inertiaPerVolume(moments, rest) * (scale * scale)};
}

}  // namespace poinsot::geometry
