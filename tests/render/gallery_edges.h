// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/renderer.h"
#include "stage/stage.h"

namespace poinsot::render {

/// The edges of a scene of the gallery, as the stage composes it, against 16 x 16 samples a pixel. Every view is
/// judged alone, and so are the flat things of plots, all together: the many good edges of one cannot make up for
/// those of another. Type is left out of either picture, and is no edge: glyphs are exact areas already
/// (text_painter_test.cpp), and would water the mean down.
class GalleryEdges {
 public:
  GalleryEdges(std::string scene, glm::ivec2 size);

  /// Film times: that of the gallery's picture, and one late in the film, when paths are long.
  double still_s() const { return stage_.scene().time.stillTime_s(); }
  double late_s() const { return 0.7 * stage_.scene().time.duration_s; }

  /// The largest mean of the errors (edge_error.h) at an instant.
  double worstMean(double filmTime_s);

  /// What is asked for.
  static constexpr double kMost = 2;

 private:
  double meanOf(draw::DrawList view, const std::string& name);
  double meanOfFlat(draw::Picture picture, const std::string& name);

  std::string name_;
  glm::ivec2 size_;
  stage::Stage stage_;
  std::unique_ptr<gl::OffscreenContext> context_;
  Renderer renderer_;
};

}  // namespace poinsot::render
