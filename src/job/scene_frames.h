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

/// The frames of what is drawn of a scene: stage composes, renderer draws. Needs a current context for life.
class SceneFrames : public FrameSource {
 public:
  /// Of a render.
  /// @param steps  where the time is entered.
  /// @throws core::Error(kPhysics, kGraphics)
  SceneFrames(const RenderRequest& render, gl::OffscreenContext& context, core::StepLedger* steps);
  /// Of a scene, for who shows pictures and keeps none: they have no digests.
  /// @throws core::Error(kPhysics, kGraphics)
  SceneFrames(const request::RequestedScene& requested, const request::PictureOptions& form,
              gl::OffscreenContext& context);

  /// As if made with that time.
  void setTime(std::optional<double> time_s) {
    time_s_ = time_s;
    composed_.reset();
  }

  image::Frame frame(std::int64_t k) override;
  core::Digest digest(std::int64_t k) override;
  /// What the last frame was drawn from, whole.
  const draw::Picture& picture() const { return picture_; }
  /// GL_RENDERER of what draws.
  const std::string& renderer() const { return rendererName_; }

 private:
  SceneFrames(const request::RequestedScene& requested, const RenderChoices& choices,
              std::optional<figure::FigureMedium> medium, const std::string& settings,
              gl::OffscreenContext& context, core::StepLedger* steps);

  /// Leaves the frame's picture in picture_.
  void compose(std::int64_t k);

  image::PixelSize size_;
  core::Rational fps_;
  std::optional<double> time_s_;
  request::PictureOptions form_;
  std::optional<figure::FigureMedium> medium_;
  draw::Picture picture_;
  std::optional<std::int64_t> composed_;  // whose picture that is
  std::unique_ptr<const stage::Composer> composer_;
  render::Renderer renderer_;
  image::AnyImage fitted_;  // of the last transparent frame
  std::string rendererName_;
  FrameDigester digestOf_;
  core::StepLedger* steps_;
};

}  // namespace poinsot::job
