// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/rational.h"
#include "figure/figure.h"
#include "gl/offscreen_context.h"
#include "job/frame_source.h"
#include "job/job_identity.h"
#include "job/render_request.h"
#include "render/renderer.h"
#include "request/picture_options.h"
#include "stage/composer.h"

namespace poinsot::job {

/// Source of a scene's frames. A composer creates the picture of each frame, and a renderer draws the picture. The
/// OpenGL context must stay current during the lifetime of this object.
class SceneFrames : public FrameSource {
 public:
  /// @param steps  ledger to which the time of each step is added
  /// @throws core::Error(kPhysics, kGraphics)
  SceneFrames(const RenderRequest& render, gl::OffscreenContext& context, core::StepLedger* steps);
  /// Makes frames only for display, for example in the preview. digest() then omits the render settings.
  /// @throws core::Error(kPhysics, kGraphics)
  SceneFrames(const request::RequestedScene& requested, const request::PictureOptions& form,
              gl::OffscreenContext& context);

  /// Sets RenderChoices::time_s, the film time of every frame. nullopt restores the time of each frame.
  void setTime(std::optional<double> time_s) {
    time_s_ = time_s;
    composed_.reset();
  }

  image::Frame frame(std::int64_t k) override;
  core::Digest digest(std::int64_t k) override;
  /// Returns the picture of the last frame, including the parts that a figure draws as vector graphics.
  const draw::Picture& picture() const { return picture_; }
  /// Returns the size of the frames before they are cropped.
  image::PixelSize size() const { return size_; }
  const std::string& renderer() const { return rendererName_; }

 private:
  SceneFrames(const request::RequestedScene& requested, const RenderChoices& choices,
              std::optional<figure::FigureMedium> medium, const std::string& settings,
              gl::OffscreenContext& context, core::StepLedger* steps);

  void compose(std::int64_t k);
  void crop();

  image::PixelSize size_;
  core::Rational fps_;
  std::optional<double> time_s_;
  request::PictureOptions form_;
  scene::Style style_;
  std::optional<figure::FigureMedium> medium_;
  draw::Picture picture_;
  std::optional<std::int64_t> composed_;  // frame number of picture_
  std::unique_ptr<const stage::Composer> composer_;
  render::Renderer renderer_;
  image::AnyImage fitted_;
  std::string rendererName_;
  FrameDigester digestOf_;
  core::StepLedger* steps_;
};

}  // namespace poinsot::job
