// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "render/renderer.h"
#include "stage/stage.h"

namespace poinsot::render {

/// Compares the edges of a gallery scene, as the stage composes it, with 16 x 16 samples a pixel. Judges each view
/// alone, and the flat parts of all plots together, so that many good edges of one view cannot make up for bad
/// edges of another. Both pictures leave out type: glyphs are exact areas already (text_painter_test.cpp) and
/// would lower the mean.
class GalleryEdges {
 public:
  GalleryEdges(std::string scene, glm::ivec2 size);

  /// Film times of the gallery's picture, and of a picture late in the film, when paths are long.
  double still_s() const { return stage_.scene().time.stillTime_s(); }
  double late_s() const { return 0.7 * stage_.scene().time.duration_s; }

  /// Returns the largest mean error (edge_error.h) of a view, or of the flat parts, at a film time.
  double worstMean(double filmTime_s);

  /// Largest allowed mean error, in 1/255.
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
