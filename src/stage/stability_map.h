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

/// Map of the time between two flips of a body, for every direction of L in the body. The map is a sphere of
/// directions, coloured by that time, with the separatrix, the principal axes and the scene's own L. The visible
/// half of the sphere is the one around the octant of the scene's L. The other half is the same, because the time
/// does not depend on the signs of L's components. The picture is flat and does not change with the moment.
///
/// The time depends only on the energy, so the colours form bands along polhodes. A band is drawn as the part of
/// the sphere inside a polhode, over the wider bands.
class StabilityMap final : public Composer {
 public:
  /// @throws core::Error(kPhysics) if the body does not flip (two moments are equal), is at rest, or is not free.
  explicit StabilityMap(const scene::Scene& scene);

  using Composer::compose;
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const override;

  const StabilityScale& scale() const { return scale_; }
  /// Returns the time between two flips for the scene's L, s; infinite on the separatrix.
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
  /// @param at  function from a fraction of the scale to a y coordinate in the picture
  void addTimes(draw::Picture& picture, const PixelBox& bar, const std::function<double(double)>& at,
                const Pen& pen) const;

  scene::Scene scene_;
  Palette colors_;
  Eigen::Vector3d m_P_;  // L at the start, kg·m²/s
  Eigen::Vector3d sceneDirection_P_;
  Eigen::Vector3d signs_;
  StabilityScale scale_;
  WrittenUnit unit_;
};

}  // namespace poinsot::stage
