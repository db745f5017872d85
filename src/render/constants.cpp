// SPDX-License-Identifier: Apache-2.0
#include "render/constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/shader_source.h"

namespace poinsot::render {
namespace {

// Number of constants that the vertex shader passes on as varyings; the fragment shader reads the others from
// uniforms, which is slower. llvmpipe has 31 varyings in addition to the position. Curves use two of them.
constexpr std::size_t kMostHandedOn = 28;
constexpr std::size_t kOfPicture = 3;

}  // namespace

PictureConstants pictureConstants(const draw::DrawList& list, float sharpness, glm::vec2 layers_px) {
  const draw::Camera& camera = list.camera;
  return {camera.size_px,
          layers_px,
          {{camera.centre_px, 1 / camera.focal_px(), camera.orthographic ? 1 : 0},
           {layers_px, camera.near, 1 / (camera.far - camera.near)},
           {glm::normalize(list.lightDirection_C), sharpness}}};
}

gl::ShaderProgram programWithConstants(const std::string& vertexFile, const std::string& fragmentFile,
                                       std::size_t own, const std::string& defines) {
  const std::size_t count = kOfPicture + own;
  const auto stage = [&](bool vertex) {
    return fmt::format("#define VERTEX {:d}\n#define CONSTANTS {}\n#define HANDED_ON {}\n", vertex, count,
                       std::min(count, kMostHandedOn));
  };
  return {fragmentFile, shaderSource(vertexFile, stage(true)), shaderSource(fragmentFile, stage(false) + defines)};
}

void useWith(const gl::ShaderProgram& program, const PictureConstants& ofPicture, const Constants& own) {
  Constants all = ofPicture.shared;
  all.insert(all.end(), own.begin(), own.end());
  program.use();
  program.set("pictureSize_px", ofPicture.size_px);
  program.set("constants", all);
}

}  // namespace poinsot::render
