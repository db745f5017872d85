// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/sha256.h"
#include "draw/picture_digest.h"
#include "job/job_record.h"
#include "job/render_request.h"

/// By what a render knows its own work again, so that a later one can go on with it.
namespace poinsot::job {

/// Of a scene's text, what overrides it, the files that it names, and how it is swept.
core::Digest sceneDigest(const request::RequestedScene& requested);

/// All that the bytes of a frame depend on besides its picture and what draws it: size, and of a film the rate,
/// the encoder and its settings and the segments' length; the libraries that write. As text, for people too.
std::string renderSettings(const RenderRequest& render);

/// Of both: two renders of one identity may share their segments.
core::Digest jobDigest(const core::Digest& scene, const std::string& settings);

/// What a render of a film or a sequence says of itself. @throws core::Error(kPhysics) as pictureWords().
JobRecord jobRecordOf(const RenderRequest& render);

/// Digests of frames: of one's picture, the settings and what draws it.
class FrameDigester {
 public:
  /// `renderer`: GL_RENDERER.
  FrameDigester(const std::string& settings, const std::string& renderer);

  core::Digest operator()(const draw::Picture& picture);

 private:
  core::Digest basis_;
  draw::PictureDigester pictureDigest_;
};

}  // namespace poinsot::job
