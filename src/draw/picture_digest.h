// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>

#include "core/sha256.h"
#include "draw/picture.h"

namespace poinsot::draw {

/// Computes digests of pictures. Pictures with the same values, bit for bit, have the same digest. Pixels depend
/// only on the picture, so equal digests mean equal pixels. Caches digests of meshes while the meshes exist.
class PictureDigester {
 public:
  core::Digest operator()(const Picture& picture);

 private:
  const core::Digest& ofMesh(const std::shared_ptr<const TriangleMesh>& mesh);

  struct Known {
    std::weak_ptr<const TriangleMesh> mesh;
    core::Digest digest;
  };
  std::map<const TriangleMesh*, Known> meshes_;
};

}  // namespace poinsot::draw
