// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>

#include "scene/scene.h"
#include "stage/composer.h"
#include "stage/figures/globe.h"
#include "stage/palette.h"
#include "stage/stability_scale.h"
#include "stage/type/pixel_box.h"
#include "stage/type/written_number.h"

namespace poinsot::stage {

/// How long a body takes from flip to flip, for every direction of L in it: the momentum sphere, coloured by the
/// time, with the separatrix, the principal axes, and the scene's own L. Half of the sphere is seen, that in whose
/// middle octant the scene's L lies; the other half is the same, as the time does not depend on the signs of L's
/// components. The picture is flat and stands still.
///
/// The time is one of the energy alone, so that its colours are bands along polhodes: each is the part of the
/// sphere within a polhode, laid over the wider ones.
class StabilityMap final : public Composer {
 public:
  /// @throws core::Error(kPhysics) for a body that does not flip (two moments are equal), is at rest, or is not
  /// free.
  explicit StabilityMap(const scene::Scene& scene);

  using Composer::compose;
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const override;

  const StabilityScale& scale() const { return scale_; }
  /// Of the scene's L, s; infinite on the separatrix.
  double sceneTime_s() const { return scale_.time_s(sceneDirection_P_); }

 private:
  struct Pen;
  struct Layout;

  Layout layoutIn(const PixelBox& room, const Pen& pen) const;
  void addBands(draw::Picture& picture, const Globe& globe) const;
  void addCurves(draw::Picture& picture, const Globe& globe, const Pen& pen) const;
  void addAxes(draw::Picture& picture, const Globe& globe, const Pen& pen) const;
  void addScenesL(draw::Picture& picture, const Globe& globe, const Pen& pen) const;
  void addBar(draw::Picture& picture, const PixelBox& bar, const Pen& pen) const;
  /// `at`: of a share of the scale the height in the picture.
  void addTimes(draw::Picture& picture, const PixelBox& bar, const std::function<double(double)>& at,
                const Pen& pen) const;

  scene::Scene scene_;  // with what is written
  Palette colors_;
  Eigen::Vector3d m_P_;  // L at the start, kg·m²/s
  Eigen::Vector3d sceneDirection_P_;
  Eigen::Vector3d signs_;  // of the octant that is seen
  StabilityScale scale_;
  WrittenUnit unit_;  // of times
};

}  // namespace poinsot::stage
