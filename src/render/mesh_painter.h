// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "draw/draw_list.h"
#include "render/mesh_resolver.h"
#include "render/mesh_topology.h"
#include "render/picture_cache.h"
#include "render/pixel_marks.h"
#include "render/screen_mesh.h"
#include "render/solid_cells.h"
#include "render/solid_pass.h"
#include "render/solid_program.h"

namespace poinsot::render {

/// Draws the triangle meshes and boxes of a draw list: the inside of faces by OpenGL, the pixels that an outline
/// or a crease runs through as the CPU resolved them. A mesh that is not wholly in front of the camera is left
/// out, as every solid.
class MeshPainter {
 public:
  MeshPainter();

  /// Forgets the meshes that the picture before did not show.
  void beginPicture() { kept_.beginPicture(); }

  /// Works out this list, once for all passes, and marks the tiles and the cells that its meshes may touch.
  /// @return the sharp edges of each mesh, where they are to be drawn.
  std::vector<std::vector<draw::Curve>> prepare(const draw::DrawList& list, float sharpness,
                                                SolidCells& solidCells);

  /// Draws what prepare() was given into the bound framebuffer, as SolidPainter::draw().
  void draw(SolidPass pass, const PassInputs& inputs, const PictureConstants& ofPicture);

 private:
  /// A mesh's own, made once and kept while pictures in a row show the mesh.
  struct Kept {
    std::shared_ptr<const draw::TriangleMesh> mesh;  // held, so that its address stays its name
    MeshTopology topology;
    gl::VertexArrayName vertexArray;
    gl::BufferName corners, indices;
  };
  using Key = std::pair<const draw::TriangleMesh*, float>;  // mesh, crease angle

  static Kept keep(const draw::Mesh& mesh);
  const Kept& kept(const draw::Mesh& mesh);
  void resetMarks(glm::ivec2 size_px);
  void uploadMarks();
  void uploadPixels();
  void drawFaces(SolidPass pass, const PictureConstants& ofPicture);
  void drawPixels(SolidPass pass, const PictureConstants& ofPicture);

  std::array<SolidProgram, 2> faces_;   // in the full pass, in that of the seams
  std::array<SolidProgram, 2> pixels_;  // by SolidPass
  gl::TextureName marksTexture_ = gl::TextureName::make();
  gl::VertexArrayName pixelVertices_ = gl::VertexArrayName::make();
  gl::BufferName pixelBuffer_ = gl::BufferName::make();
  PictureCache<Key, Kept> kept_;

  // Of the list last prepared.
  std::vector<draw::Mesh> meshes_;  // boxes too
  std::vector<ScreenMesh> screens_;
  std::vector<const Kept*> screensKept_;
  std::vector<float> solids_;  // their numbers
  const SolidCells* solidCells_ = nullptr;
  PixelMarks marks_;
  ResolvedPixels resolved_;
};

/// A box as the mesh that it is: twelve triangles, all edges sharp. All boxes share one surface. A box without
/// volume has none.
draw::Mesh boxMesh(const draw::Box& box);

}  // namespace poinsot::render
