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

/// Draws the triangle meshes and boxes of a draw list. OpenGL draws the interiors of faces. The CPU computes the
/// pixels that an outline or a crease crosses. Meshes that are not completely in front of the camera are left out.
class MeshPainter {
 public:
  MeshPainter();

  void beginPicture() { kept_.beginPicture(); }

  /// Prepares the meshes of a list for all passes, and marks the cells that the meshes may touch.
  /// @returns for each visible mesh, its sharp edges as lines to draw
  std::vector<std::vector<draw::Curve>> prepare(const draw::DrawList& list, float sharpness,
                                                SolidCells& solidCells);

  /// Draws the prepared meshes into the bound framebuffer. The passes are those of SolidPainter::draw().
  void draw(SolidPass pass, const PassInputs& inputs, const PictureConstants& ofPicture);

 private:
  /// Data of one mesh, cached while consecutive pictures show the mesh. Key: address and crease angle.
  struct Kept {
    std::shared_ptr<const draw::TriangleMesh> mesh;  // owned here, so that no other mesh can get the same address
    MeshTopology topology;
    gl::VertexArrayName vertexArray;
    gl::BufferName corners, indices;
  };
  using Key = std::pair<const draw::TriangleMesh*, float>;

  static Kept keep(const draw::Mesh& mesh);
  const Kept& kept(const draw::Mesh& mesh);
  void resetMarks(glm::ivec2 size_px);
  void uploadMarks();
  void uploadPixels();
  void drawFaces(SolidPass pass, const PictureConstants& ofPicture);
  void drawPixels(SolidPass pass, const PictureConstants& ofPicture);

  std::array<SolidProgram, 2> faces_;  // programs of the full pass and of the seam pass
  std::array<SolidProgram, 2> pixels_;
  gl::TextureName marksTexture_ = gl::TextureName::make();
  gl::VertexArrayName pixelVertices_ = gl::VertexArrayName::make();
  gl::BufferName pixelBuffer_ = gl::BufferName::make();
  PictureCache<Key, Kept> kept_;

  // Data of the list that was last passed to prepare().
  std::vector<draw::Mesh> meshes_;
  std::vector<ScreenMesh> screens_;
  std::vector<const Kept*> screensKept_;
  std::vector<float> solids_;  // numbers of the meshes in solidCells_
  const SolidCells* solidCells_ = nullptr;
  PixelMarks marks_;
  ResolvedPixels resolved_;
};

/// Returns a box as a mesh of twelve triangles with sharp edges. All boxes use one cube; a box without volume has
/// a null mesh.
draw::Mesh boxMesh(const draw::Box& box);

}  // namespace poinsot::render
