// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/sha256.h"
#include "draw/picture_digest.h"
#include "job/job_record.h"
#include "job/render_request.h"

/// Digests by which a later render recognises finished work and resumes it.
namespace poinsot::job {

/// Returns the digest of a scene's text, its overrides, the files that it names, its sweep and its selected view.
core::Digest sceneDigest(const request::RequestedScene& requested);

/// Returns, as JSON, everything besides picture and renderer that decides the bytes of a frame: the size; for a
/// film also the frame rate, the encoder with its settings and the segment length; the versions of poinsot and of
/// the libraries that write the files.
std::string renderSettings(const RenderRequest& render);

/// Returns the digest of a scene and its settings. Renders with the same job digest may share their segments.
core::Digest jobDigest(const core::Digest& scene, const std::string& settings);

/// Returns the record of a render of a film or sequence. @throws core::Error(kPhysics) as pictureWords()
JobRecord jobRecordOf(const RenderRequest& render);

/// Computes the digest of a frame from its picture, the render settings and the renderer.
class FrameDigester {
 public:
  /// @param settings  text of renderSettings()
  /// @param renderer  GL_RENDERER
  FrameDigester(const std::string& settings, const std::string& renderer);

  core::Digest operator()(const draw::Picture& picture);

 private:
  core::Digest basis_;
  draw::PictureDigester pictureDigest_;
};

}  // namespace poinsot::job
