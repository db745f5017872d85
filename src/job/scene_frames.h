// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/rational.h"
#include "figure/figure.h"
#include "gl/offscreen_context.h"
#include "job/frame_source.h"
#include "job/job_identity.h"
#include "render/renderer.h"
#include "request/picture_form.h"
#include "scene/scene.h"
#include "stage/composer.h"

namespace poinsot::job {

/// The frames of what is drawn of a scene: stage composes, renderer draws. Needs a current context for life.
class SceneFrames : public FrameSource {
 public:
  /// @param scene  of which rate and size are
  /// @param composer  of its pictures: composerOf() a request, or the scene's own stage
  /// @param time_s  film time of every frame, in place of its own: of a still.
  /// @param medium  of a figure: a frame is then only what the figure holds as an image.
  /// @param settings  renderSettings(), of which digests are.
  /// @param steps  where the time is entered.
  /// @throws core::Error(kPhysics, kGraphics)
  SceneFrames(const scene::Scene& scene, std::unique_ptr<const stage::Composer> composer,
              gl::OffscreenContext& context, std::optional<double> time_s, const request::PictureForm& form = {},
              std::optional<figure::FigureMedium> medium = std::nullopt, const std::string& settings = "",
              core::StepLedger* steps = nullptr);

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
  /// Leaves the frame's picture in picture_.
  void compose(std::int64_t k);

  image::PixelSize size_;
  core::Rational fps_;
  std::optional<double> time_s_;
  request::PictureForm form_;
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
