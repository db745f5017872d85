// SPDX-License-Identifier: Apache-2.0
#include "render/mesh_painter.h"

#include <cstddef>
#include <glm/matrix.hpp>

#include "render/mesh_edge_lines.h"

namespace poinsot::render {

namespace {

// Reports whether edges are drawn hard, for the reference renderer. The CPU resolves no pixel in that case.
bool hardEdges(float sharpness) { return sharpness > 1; }

// Largest area of a rough face whose pixels the CPU resolves, in square pixels. OpenGL takes one sample per pixel
// and would hit such small faces by chance, so the surface would sparkle.
constexpr double kSmall_px2 = 2;

void markEdges(const ScreenMesh& screen, PixelMarks& marks) {
  for (const MeshEdge& e : screen.topology->edges)
    if (screen.isSilhouette(e) || (e.sharp && screen.isFront(e)))
      marks.markSegment(glm::dvec2(screen.vertices[e.from]), glm::dvec2(screen.vertices[e.to]));
}

void markFaces(const ScreenMesh& screen, SolidCells& cells) {
  for (std::size_t f = 0; f < screen.front.size(); ++f) {
    if (!screen.front[f]) continue;
    const auto t = screen.triangle(f);
    DepthRange depths;
    for (const glm::dvec3& v : t) depths.include(static_cast<float>(v.z));
    cells.markSolid({glm::vec2(t[0]), glm::vec2(t[1]), glm::vec2(t[2])}, depths);
  }
}

void markPixel(const ResolvedPixel& pixel, SolidCells& cells) {
  const glm::vec2 p(pixel.place);
  cells.markEdge(PixelBounds{p.x - 0.25f, p.y - 0.25f, p.x + 0.25f, p.y + 0.25f});
}

// Marks the resolved pixels as edges of one strand (a set of edges that never hide one another). If two edges lie
// in one pixel, the second begins a new strand.
void markResolved(const ResolvedPixels& resolved, SolidCells& cells) {
  cells.nextStrand();
  for (const ResolvedPixel& pixel : resolved.full) markPixel(pixel, cells);
  for (std::size_t i = 0; i < resolved.partial.size(); ++i) {
    const bool second = i > 0 && glm::vec2(resolved.partial[i].place) == glm::vec2(resolved.partial[i - 1].place);
    if (second) cells.nextStrand();
    markPixel(resolved.partial[i], cells);
  }
}

void markSmallFaces(const ScreenMesh& screen, PixelMarks& marks) {
  for (std::size_t f = 0; f < screen.front.size(); ++f) {
    if (!screen.front[f] || !screen.topology->rough[f]) continue;
    const auto t = screen.triangle(f);
    if (-signedArea(t) > kSmall_px2) continue;
    PixelBounds bounds;
    for (const glm::dvec3& v : t) bounds.include(glm::vec2(v));
    marks.mark(bounds);
  }
}

// Returns the constants of a mesh in the order in which mesh.vert reads them.
Constants constantsOf(const ScreenMesh& screen, float solid) {
  Constants own{{screen.origin_C, solid}};
  for (int i = 0; i < 3; ++i) own.emplace_back(screen.axes_C[i], 0);
  for (int i = 0; i < 3; ++i) own.emplace_back(screen.normals_C[i], 0);
  own.emplace_back(screen.mesh->material.color, screen.mesh->material.gloss);
  return own;
}

}  // namespace

MeshPainter::MeshPainter()
    : faces_{SolidProgram("mesh.vert", "mesh.frag", SolidPass::kFull, 8),
             SolidProgram("mesh.vert", "mesh.frag", SolidPass::kSeams, 8)},
      pixels_{SolidProgram("mesh_pixel.vert", "mesh_pixel.frag", SolidPass::kFull, 0),
              SolidProgram("mesh_pixel.vert", "mesh_pixel.frag", SolidPass::kEdges, 0)} {
  glBindTexture(GL_TEXTURE_RECTANGLE, marksTexture_.id());
  glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindVertexArray(pixelVertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, pixelBuffer_.id());
  constexpr GLuint kFacets = ResolvedPixel::kFacets;
  floatAttribute(0, 4, sizeof(ResolvedPixel), offsetof(ResolvedPixel, place));
  floatAttribute(1 + 2 * kFacets, 1, sizeof(ResolvedPixel), offsetof(ResolvedPixel, solid));
  for (GLuint i = 0; i < kFacets; ++i) {
    const std::size_t offset = i * sizeof(glm::vec4);
    floatAttribute(1 + i, 4, sizeof(ResolvedPixel), offsetof(ResolvedPixel, normals_C) + offset);
    floatAttribute(1 + kFacets + i, 4, sizeof(ResolvedPixel), offsetof(ResolvedPixel, materials) + offset);
  }
}

MeshPainter::Kept MeshPainter::keep(const draw::Mesh& mesh) {
  Kept made{mesh.mesh, meshTopology(*mesh.mesh, mesh.crease_rad), gl::VertexArrayName::make(),
            gl::BufferName::make(), gl::BufferName::make()};
  glBindVertexArray(made.vertexArray.id());
  upload(GL_ARRAY_BUFFER, made.corners, made.topology.corners, GL_STATIC_DRAW);
  upload(GL_ELEMENT_ARRAY_BUFFER, made.indices, made.topology.triangles, GL_STATIC_DRAW);
  floatAttribute(0, 3, sizeof(MeshCorner), offsetof(MeshCorner, position_M));
  floatAttribute(1, 3, sizeof(MeshCorner), offsetof(MeshCorner, normal_M));
  return made;
}

const MeshPainter::Kept& MeshPainter::kept(const draw::Mesh& mesh) {
  return kept_.get({mesh.mesh.get(), mesh.crease_rad}, [&] { return keep(mesh); });
}

std::vector<std::vector<draw::Curve>> MeshPainter::prepare(const draw::DrawList& list, float sharpness,
                                                           SolidCells& solidCells) {
  solidCells_ = &solidCells;
  meshes_ = list.meshes;
  for (const draw::Box& box : list.boxes) meshes_.push_back(boxMesh(box));
  screens_.clear();
  screensKept_.clear();
  solids_.clear();
  resolved_ = {};
  std::vector<std::vector<draw::Curve>> lines;
  for (const draw::Mesh& mesh : meshes_) {
    if (!mesh.mesh || mesh.mesh->triangles.empty()) continue;
    const Kept& own = kept(mesh);
    ScreenMesh screen = screenMesh(list.camera, mesh, own.topology);
    if (screen.bounds.empty()) continue;
    solids_.push_back(solidCells.nextSolid());
    markFaces(screen, solidCells);
    lines.push_back(meshEdgeLines(list.camera, screen));
    screens_.push_back(std::move(screen));
    screensKept_.push_back(&own);
  }
  if (screens_.empty()) return lines;
  resetMarks(glm::ivec2(list.camera.size_px));
  for (const ScreenMesh& screen : screens_) {
    if (hardEdges(sharpness)) break;
    markEdges(screen, marks_);
    markSmallFaces(screen, marks_);
  }
  marks_.finish();
  resolved_ = resolveMeshes(screens_, marks_, list.camera);
  markResolved(resolved_, solidCells);
  uploadMarks();
  uploadPixels();
  return lines;
}

void MeshPainter::resetMarks(glm::ivec2 size_px) {
  const bool resized = size_px != marks_.size_px();
  PixelBounds part;
  for (const ScreenMesh& screen : screens_) {
    part.include({screen.bounds.left, screen.bounds.top}, 1);
    part.include({screen.bounds.right, screen.bounds.bottom}, 1);
  }
  marks_.reset(size_px, part);
  if (!resized) return;
  glBindTexture(GL_TEXTURE_RECTANGLE, marksTexture_.id());
  glTexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_R8, size_px.x, size_px.y, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  gl::expectStored("marks", static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y));
}

// Uploads only the marks within marks_.part(). The rest of the texture is out of date, and shaders do not read it.
void MeshPainter::uploadMarks() {
  const PixelBounds& part = marks_.part();
  const glm::ivec2 from(part.left, part.top), to(part.right, part.bottom);
  glBindTexture(GL_TEXTURE_RECTANGLE, marksTexture_.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, marks_.size_px().x);
  glTexSubImage2D(GL_TEXTURE_RECTANGLE, 0, from.x, from.y, to.x - from.x, to.y - from.y, GL_RED, GL_UNSIGNED_BYTE,
                  marks_.bytes());
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void MeshPainter::uploadPixels() {
  std::vector<ResolvedPixel> all = resolved_.partial;
  all.insert(all.end(), resolved_.full.begin(), resolved_.full.end());
  for (ResolvedPixel& pixel : all) pixel.solid = solids_[static_cast<std::size_t>(pixel.solid)];
  upload(GL_ARRAY_BUFFER, pixelBuffer_, all, GL_STREAM_DRAW);
}

void MeshPainter::drawFaces(SolidPass pass, const PictureConstants& ofPicture) {
  const bool full = pass == SolidPass::kFull;
  SolidProgram& program = faces_[full ? 0 : 1];
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_RECTANGLE, marksTexture_.id());
  // OpenGL's y axis points up but rows count downwards, so faces counter-clockwise for the eye are clockwise here.
  glFrontFace(GL_CW);
  glEnable(GL_CULL_FACE);
  for (std::size_t i = 0; i < screens_.size(); ++i) {
    const ScreenMesh& screen = screens_[i];
    if (!full) {
      const PixelBounds part = solidCells_->sharedPart(screen.bounds);
      if (part.empty()) continue;
      glEnable(GL_SCISSOR_TEST);
      const glm::ivec2 from(glm::vec2(part.left, part.top) - ofPicture.layers_px);
      glScissor(from.x, from.y, static_cast<GLsizei>(part.right - part.left),
                static_cast<GLsizei>(part.bottom - part.top));
    }
    program.use(ofPicture, constantsOf(screen, solids_[i])).set("marks", 0);
    glBindVertexArray(screensKept_[i]->vertexArray.id());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * screen.front.size()), GL_UNSIGNED_INT, nullptr);
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
}

void MeshPainter::drawPixels(SolidPass pass, const PictureConstants& ofPicture) {
  const bool full = pass == SolidPass::kFull;
  const std::size_t first = full ? resolved_.partial.size() : 0;
  const std::size_t count = full ? resolved_.full.size() : resolved_.partial.size();
  if (count == 0) return;
  pixels_[static_cast<std::size_t>(pass)].use(ofPicture, {});
  glBindVertexArray(pixelVertices_.id());
  glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(count));
}

void MeshPainter::draw(SolidPass pass, const PassInputs& inputs, const PictureConstants& ofPicture) {
  if (screens_.empty()) return;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  bindInputs(inputs);
  if (pass != SolidPass::kEdges) drawFaces(pass, ofPicture);
  if (pass != SolidPass::kSeams) drawPixels(pass, ofPicture);
  glDisable(GL_DEPTH_TEST);
}

namespace {

using Index = std::uint32_t;

// Returns a cube with corners at (±1, ±1, ±1). Bit k of a corner's index is 1 if coordinate k of the corner is +1.
std::shared_ptr<const draw::TriangleMesh> makeCube() {
  auto cube = std::make_shared<draw::TriangleMesh>();
  for (int i = 0; i < 8; ++i) cube->vertices_M.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  for (Index axis = 0; axis < 3; ++axis) {
    const Index u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, far = 1u << axis;
    cube->triangles.insert(
        cube->triangles.end(),
        {{far, far + u, far + u + v}, {far, far + u + v, far + v}, {0, u + v, u}, {0, v, u + v}});
  }
  return cube;
}

}  // namespace

draw::Mesh boxMesh(const draw::Box& box) {
  static const auto cube = makeCube();
  draw::Mesh mesh;
  const float determinant = glm::determinant(box.halfAxes_V);
  if (determinant != 0) mesh.mesh = cube;
  mesh.origin_V = box.centre_V;
  mesh.axes_V = box.halfAxes_V;
  if (determinant < 0) mesh.axes_V[0] *= -1.0f;  // makes the axes right-handed; a mirrored box is the same box
  mesh.material = box.material;
  return mesh;
}

}  // namespace poinsot::render
