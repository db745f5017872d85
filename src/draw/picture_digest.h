// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>

#include "core/sha256.h"
#include "draw/picture.h"

namespace poinsot::draw {

/// Digests of pictures: one for two pictures that agree in every value, bit for bit. What is drawn is a function
/// of the picture, so of the same digest the same pixels come.
class PictureDigester {
 public:
  core::Digest operator()(const Picture& picture);

 private:
  const core::Digest& ofMesh(const std::shared_ptr<const TriangleMesh>& mesh);

  struct Known {
    std::weak_ptr<const TriangleMesh> mesh;
    core::Digest digest;
  };
  std::map<const TriangleMesh*, Known>
      meshes_;  // as long as they live, as they are shared from picture to picture
};

}  // namespace poinsot::draw
