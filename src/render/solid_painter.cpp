// SPDX-License-Identifier: Apache-2.0
#include "render/solid_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render/frustum_outline.h"
#include "render/shader_source.h"

namespace poinsot::render {
namespace {

std::string passDefine(SolidPass pass) { return "#define PASS " + std::to_string(static_cast<int>(pass)) + "\n"; }

gl::ShaderProgram solidProgram(const std::string& vertex, const std::string& fragment, SolidPass pass) {
  return {fragment, shaderSource(vertex), shaderSource(fragment, passDefine(pass))};
}

glm::mat3 toCameraAxes(const draw::Camera& camera, const glm::mat3& columns_W) {
  return glm::transpose(camera.R_WC) * columns_W;
}

void setMaterial(const gl::ShaderProgram& program, const draw::Material& material) {
  program.set("color", material.color);
  program.set("gloss", material.gloss);
}

void drawRectangle(const gl::ShaderProgram& program, const PixelBounds& bounds, glm::vec2 size_px) {
  const PixelBounds clipped = bounds.clipped(size_px);
  if (clipped.empty()) return;
  program.set("bounds_px", clipped.asVec4());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

// The faces of a box in camera axes that look at the eye.
struct BoxFaces {
  std::vector<glm::vec3> edges, normals_C, points_C;
  PixelBounds bounds;
};

BoxFaces visibleFaces(const draw::Camera& camera, const draw::Box& box) {
  BoxFaces faces;
  const glm::vec3 centre_C = toCamera(camera, box.centre_W);
  const glm::mat3 half_C = toCameraAxes(camera, box.halfAxes_W);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const glm::vec3 u = half_C[(axis + 1) % 3], v = half_C[(axis + 2) % 3];
      const glm::vec3 middle = centre_C + side * half_C[axis];
      const glm::vec3 normal = side * glm::normalize(half_C[axis]);
      if (glm::dot(normal, middle) >= 0) continue;  // looks away from the eye
      std::array<glm::vec2, 4> corners;
      const std::array<glm::vec3, 4> corners_C{middle - u - v, middle + u - v, middle + u + v, middle - u + v};
      for (std::size_t i = 0; i < 4; ++i) {
        corners[i] = projectCamera(camera, corners_C[i]);
        faces.bounds.include(corners[i], 1.5f);
      }
      const auto edges = quadEdges(corners);
      faces.edges.insert(faces.edges.end(), edges.begin(), edges.end());
      faces.normals_C.push_back(normal);
      faces.points_C.push_back(middle);
    }
  }
  return faces;
}

template <typename Offset>
void floatAttribute(GLuint index, GLint components, Offset offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(StripVertex),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace

void setPicture(const gl::ShaderProgram& program, const draw::DrawList& list, float sharpness) {
  program.use();
  program.set("pictureSize_px", list.camera.size_px);
  program.set("opticalCentre_px", list.camera.centre_px);
  program.set("focal_px", list.camera.focal_px());
  program.set("depthRange", glm::vec2(list.camera.near, list.camera.far));
  program.set("sharpness", sharpness);
  program.set("lightDirection_C", glm::normalize(list.lightDirection_C));
}

SolidPainter::Programs SolidPainter::makePrograms(SolidPass pass) {
  return {solidProgram("rectangle.vert", "ellipsoid.frag", pass),
          solidProgram("rectangle.vert", "frustum.frag", pass), solidProgram("rectangle.vert", "box.frag", pass),
          solidProgram("curve.vert", "curve.frag", pass)};
}

SolidPainter::SolidPainter()
    : programs_{makePrograms(SolidPass::kFull), makePrograms(SolidPass::kNearestEdge),
                makePrograms(SolidPass::kNextEdge)} {
  glBindVertexArray(curveVertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, curveBuffer_.id());
  floatAttribute(0, 2, offsetof(StripVertex, position_px));
  floatAttribute(1, 4, offsetof(StripVertex, across));
  floatAttribute(2, 4, offsetof(StripVertex, tangent_C));
}

PixelBounds SolidPainter::prepare(const draw::DrawList& list, float sharpness) {
  list_ = &list;
  sharpness_ = sharpness;
  vertices_.clear();
  curves_.clear();
  PixelBounds bounds;
  for (const draw::Curve& curve : list.curves) {
    const CurveStrip strip = makeCurveStrip(list.camera, curve);
    curves_.push_back({static_cast<GLint>(vertices_.size()), static_cast<GLsizei>(strip.triangles.size()),
                       curve.material, curve.lift_W});
    vertices_.insert(vertices_.end(), strip.triangles.begin(), strip.triangles.end());
    bounds.include(strip.bounds);
  }
  for (const draw::Ellipsoid& e : list.ellipsoids)
    bounds.include(
        ellipseOutline(list.camera, toCamera(list.camera, e.centre_W), toCameraAxes(list.camera, e.semiAxes_W))
            .bounds);
  for (const draw::Frustum& f : list.frustums) bounds.include(frustumOutline(list.camera, f).bounds);
  for (const draw::Box& b : list.boxes) bounds.include(visibleFaces(list.camera, b).bounds);
  glBindBuffer(GL_ARRAY_BUFFER, curveBuffer_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(StripVertex)), vertices_.data(),
               GL_STREAM_DRAW);
  return bounds.clipped(list.camera.size_px);
}

void SolidPainter::draw(SolidPass pass, GLuint nearestEdgeDepth) const {
  const Programs& programs = programs_[static_cast<std::size_t>(pass)];
  for (const auto* program : {&programs.ellipsoid, &programs.frustum, &programs.box, &programs.curve}) {
    setPicture(*program, *list_, sharpness_);
    program->set("nearestEdgeDepth", 0);
  }
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, nearestEdgeDepth);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  glBindVertexArray(noVertices_.id());
  drawEllipsoids(programs);
  drawFrustums(programs);
  drawBoxes(programs);
  drawCurves(programs);
  glDisable(GL_DEPTH_TEST);
}

void SolidPainter::drawEllipsoids(const Programs& programs) const {
  programs.ellipsoid.use();
  for (const draw::Ellipsoid& e : list_->ellipsoids) {
    const glm::vec3 centre_C = toCamera(list_->camera, e.centre_W);
    const glm::mat3 semiAxes_C = toCameraAxes(list_->camera, e.semiAxes_W);
    if (!inFront(list_->camera, centre_C, semiAxes_C)) continue;
    const ScreenEllipse outline = ellipseOutline(list_->camera, centre_C, semiAxes_C);
    programs.ellipsoid.set("centre_C", centre_C);
    programs.ellipsoid.set("toUnitSphere", glm::mat3(glm::inverse(glm::dmat3(semiAxes_C))));
    programs.ellipsoid.set("outlineCentre_px", outline.centre_px);
    programs.ellipsoid.set("outlineForm", outline.form);
    setMaterial(programs.ellipsoid, e.material);
    drawRectangle(programs.ellipsoid, outline.bounds, list_->camera.size_px);
  }
}

void SolidPainter::drawFrustums(const Programs& programs) const {
  const gl::ShaderProgram& program = programs.frustum;
  program.use();
  for (const draw::Frustum& f : list_->frustums) {
    const FrustumOutline outline = frustumOutline(list_->camera, f);
    if (outline.bounds.empty()) continue;
    program.set("from_C", outline.from_C);
    program.set("axis_C", outline.axis_C);
    program.set("radii",
                glm::vec4(f.fromRadius, f.toRadius, outline.height, (f.toRadius - f.fromRadius) / outline.height));
    program.set("discCentres_px", glm::vec4(outline.first.centre_px, outline.second.centre_px));
    program.set("firstForm", outline.first.form);
    program.set("secondForm", outline.second.form);
    program.set("sides", std::vector<glm::vec3>(outline.sides.begin(), outline.sides.end()));
    program.set("visibleCap", outline.visibleCap);
    setMaterial(program, f.material);
    drawRectangle(program, outline.bounds, list_->camera.size_px);
  }
}

void SolidPainter::drawBoxes(const Programs& programs) const {
  programs.box.use();
  for (const draw::Box& box : list_->boxes) {
    const BoxFaces faces = visibleFaces(list_->camera, box);
    if (faces.normals_C.empty()) continue;
    programs.box.set("faceCount", static_cast<int>(faces.normals_C.size()));
    programs.box.set("edges", faces.edges);
    programs.box.set("normals_C", faces.normals_C);
    programs.box.set("points_C", faces.points_C);
    setMaterial(programs.box, box.material);
    drawRectangle(programs.box, faces.bounds, list_->camera.size_px);
  }
}

void SolidPainter::drawCurves(const Programs& programs) const {
  programs.curve.use();
  glBindVertexArray(curveVertices_.id());
  for (const PreparedCurve& curve : curves_) {
    setMaterial(programs.curve, curve.material);
    programs.curve.set("lift", curve.lift);
    if (curve.count > 0) glDrawArrays(GL_TRIANGLES, curve.first, curve.count);
  }
}

}  // namespace poinsot::render
