// SPDX-License-Identifier: Apache-2.0
#include "job/scene_frames.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/frame_clock.h"
#include "draw/crop.h"
#include "figure/alpha.h"
#include "image/ink.h"
#include "request/requested_scene.h"

namespace poinsot::job {

SceneFrames::SceneFrames(const request::RequestedScene& requested, const RenderChoices& choices,
                         std::optional<figure::FigureMedium> medium, const std::string& settings,
                         gl::OffscreenContext& context, core::StepLedger* steps)
    : size_(requested.size()),
      fps_(requested.scene.time.fps),
      time_s_(choices.time_s),
      form_(choices.form),
      style_(requested.scene.style),
      medium_(medium),
      composer_(request::composerOf(requested, steps)),
      renderer_(context, steps),
      rendererName_(context.renderer()),
      digestOf_(settings, rendererName_),
      steps_(steps) {}

SceneFrames::SceneFrames(const RenderRequest& render, gl::OffscreenContext& context, core::StepLedger* steps)
    : SceneFrames(render.scene, render, figure::figureMedium(render.target.path), renderSettings(render), context,
                  steps) {}

SceneFrames::SceneFrames(const request::RequestedScene& requested, const request::PictureOptions& form,
                         gl::OffscreenContext& context)
    : SceneFrames(requested, {.form = form}, std::nullopt, "", context, nullptr) {}

core::Digest SceneFrames::digest(std::int64_t k) {
  compose(k);
  return digestOf_(picture_);
}

image::Frame SceneFrames::frame(std::int64_t k) {
  compose(k);
  render::RenderOptions options;
  options.transparent = form_.transparent;
  const image::Frame drawn =
      renderer_.frame(medium_ ? figure::imagePartOf(picture_, *medium_) : picture_, form_.bits, options);
  if (!form_.transparent) return drawn;
  fitted_ = drawn.picture;
  std::visit([&](auto& image) { figure::fitAlpha(image, picture_.background); }, fitted_);
  return fitted_;
}

void SceneFrames::compose(std::int64_t k) {
  if (composed_ == k) return;
  const core::StepScope timing(steps_, core::Step::kCompose);
  const stage::Moment moment(time_s_.value_or(core::filmTime_s(k, fps_)), time_s_.has_value());
  const glm::ivec2 size_px(size_.width, size_.height);
  picture_ = composer_->compose(moment, size_px, request::sizingOf(form_, style_, size_px));
  if (form_.crop) crop();
  composed_ = k;
}

// Leaves out the empty borders of the picture, except a narrow margin.
void SceneFrames::crop() {
  constexpr double kMargin = 0.012;  // fraction of the picture's longer side
  render::RenderOptions options;
  options.transparent = true;
  const image::Frame drawn = renderer_.frame(picture_, 8, options);
  const image::PixelRect ink = image::inkOf(std::get<image::Image>(drawn.picture));
  if (ink.empty()) return;
  const int margin = static_cast<int>(std::ceil(kMargin * std::max(size_.width, size_.height)));
  const glm::ivec2 low = glm::max(glm::ivec2(ink.left, ink.top) - margin, glm::ivec2(0));
  const glm::ivec2 high = glm::min(glm::ivec2(ink.right, ink.bottom) + margin, picture_.size_px);
  picture_ = draw::cropped(picture_, low, high - low);
}

}  // namespace poinsot::job
