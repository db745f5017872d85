// SPDX-License-Identifier: Apache-2.0
#include "render/compositor.h"

#include <fmt/format.h>

#include <array>

#include "render/cells.h"
#include "render/shader_source.h"
#include "render/solid_pass.h"

namespace poinsot::render {
namespace {

void bindLayers(const gl::ShaderProgram& program, const SolidLayers& solids) {
  const std::array<std::pair<const char*, GLuint>, 6> textures{{{"solidColor", solids.full.color(0)},
                                                                {"solidDepth", solids.full.depth()},
                                                                {"edgeColor", solids.edge.color(0)},
                                                                {"edgeDepth", solids.edge.depth()},
                                                                {"nextEdgeColor", solids.nextEdge.color(0)},
                                                                {"nextEdgeDepth", solids.nextEdge.depth()}}};
  for (std::size_t i = 0; i < textures.size(); ++i) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    glBindTexture(GL_TEXTURE_2D, textures[i].second);
    program.set(textures[i].first, static_cast<int>(i));
  }
}

}  // namespace

const gl::ShaderProgram& Compositor::program(const Variant& variant) {
  if (const auto known = programs_.find(variant); known != programs_.end()) return known->second;
  const auto& [transparent, solids, sheets] = variant;
  const std::string defines = fmt::format(
      "#define TRANSPARENT {:d}\n#define SOLIDS {:d}\n#define ELLIPSOIDS {}\n#define PLANES {}\n#define CONES {}\n"
      "#define POLYGONS {}\n#define SIDES {}\n",
      transparent, solids, sheets.ellipsoids, sheets.planes, sheets.cones, sheets.polygons, sheets.polygonSides);
  gl::ShaderProgram made("composite.frag", shaderSource("tiles.vert"), shaderSource("composite.frag", defines));
  return programs_.emplace(variant, std::move(made)).first->second;
}

void Compositor::draw(const draw::DrawList& list, const SolidLayers& solids, const TileMask& solidTiles,
                      float sharpness, bool transparent) {
  const Sheets sheets(list);
  std::map<Content, std::vector<glm::vec2>> tiles;
  for (int row = 0; row < solidTiles.rows(); ++row) {
    for (int column = 0; column < solidTiles.columns(); ++column) {
      const PixelBounds tile = solidTiles.tile(column, row);
      const Content content{solidTiles.marked(column, row), sheets.reaching(tile)};
      if (content.first || !content.second.empty()) addRectangle(tiles[content], tile);
    }
  }

  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  floatAttribute(0, 2, sizeof(glm::vec2), 0);
  for (const auto& [content, triangles] : tiles) {
    const auto& [hasSolids, chosen] = content;
    const auto& shader = program({transparent, hasSolids, sheets.counts(chosen)});
    setPicture(shader, list, sharpness);
    shader.set("background", list.background);
    bindLayers(shader, solids);
    sheets.setUniforms(shader, chosen);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec2)), triangles.data(),
                 GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
  }
}

}  // namespace poinsot::render
