// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/sha256.h"
#include "draw/picture_digest.h"
#include "job/job_record.h"
#include "job/render_request.h"

/// Digests by which a later render detects finished work that it can reuse.
namespace poinsot::job {

/// Returns the digest of a requested scene: text, overrides, files that the scene names, sweep and selected view.
core::Digest sceneDigest(const request::RequestedScene& requested);

/// Returns the settings that determine the bytes of a frame besides the picture and the renderer, as JSON.
/// Settings are the picture size, and the versions of poinsot and of the libraries that write the files. For a
/// film, the frame rate, the encoder with its settings and the segment length are included.
std::string renderSettings(const RenderRequest& render);

/// Returns the digest of a scene and its settings. Renders with equal job digests may share segments.
core::Digest jobDigest(const core::Digest& scene, const std::string& settings);

/// Returns the record of a render of a film or sequence. @throws core::Error(kPhysics) like pictureWords()
JobRecord jobRecordOf(const RenderRequest& render);

/// Computes the digest of a frame from the picture, the render settings and the renderer.
class FrameDigester {
 public:
  /// @param settings  text from renderSettings()
  /// @param renderer  OpenGL's GL_RENDERER string
  FrameDigester(const std::string& settings, const std::string& renderer);

  core::Digest operator()(const draw::Picture& picture);

 private:
  core::Digest basis_;
  draw::PictureDigester pictureDigest_;
};

}  // namespace poinsot::job
