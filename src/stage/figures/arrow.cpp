// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/arrow.h"

#include <algorithm>

#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

// Size of an arrow's head, in radii of the shaft.
constexpr double kHeadLength = 9.0, kHeadRadius = 3.0;
constexpr double kLongestHead = 0.45;     // longest head, as a fraction of the arrow's length
constexpr double kSmallestLength = 1e-6;  // shorter arrows are not drawn

}  // namespace

void addArrow(draw::DrawList& list, const Eigen::Vector3d& from_V, const Eigen::Vector3d& to_V, double shaftRadius,
              const draw::Color& color) {
  const Eigen::Vector3d along = to_V - from_V;
  const double length = along.norm();
  if (length < kSmallestLength) return;
  const double radius = std::min(shaftRadius, kLongestHead * length / kHeadLength);
  const Eigen::Vector3d neck_V = to_V - along * (kHeadLength * radius / length);
  const draw::Material material{color, 0.3f};
  draw::Curve shaft;
  // The shaft ends inside the head, so that no seam shows.
  shaft.points_V = {toPicture(from_V), toPicture(Eigen::Vector3d(neck_V + 0.1 * (to_V - neck_V)))};
  shaft.radius_V = static_cast<float>(radius);
  shaft.material = material;
  list.curves.push_back(std::move(shaft));
  list.frustums.push_back(
      {toPicture(neck_V), toPicture(to_V), static_cast<float>(kHeadRadius * radius), 0.0f, material});
}

double headRadius(double shaftRadius) { return kHeadRadius * shaftRadius; }

}  // namespace poinsot::stage
