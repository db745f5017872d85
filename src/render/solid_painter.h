// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "draw/draw_list.h"
#include "gl/shader_program.h"
#include "render/curve_strip.h"
#include "render/screen_outline.h"

namespace poinsot::render {

/// Which fragments of the solids are kept; the numbers are PASS in emit.glsl.
enum class SolidPass { kFull = 0, kNearestEdge = 1, kNextEdge = 2 };

/// What all shaders are told about the picture.
void setPicture(const gl::ShaderProgram& program, const draw::DrawList& list, float sharpness);

/// Draws the opaque things of a draw list: ellipsoids, frustums, boxes and curves.
class SolidPainter {
 public:
  SolidPainter();

  /// Works out outlines and strips of this list, once for the three passes.
  /// @return the pixels that any solid may touch.
  PixelBounds prepare(const draw::DrawList& list, float sharpness);

  /// Draws what prepare() was given into the bound framebuffer. `nearestEdgeDepth` is read in kNextEdge only.
  void draw(SolidPass pass, GLuint nearestEdgeDepth) const;

 private:
  struct Programs {
    gl::ShaderProgram ellipsoid, frustum, box, curve;
  };
  static Programs makePrograms(SolidPass pass);

  void drawEllipsoids(const Programs& programs) const;
  void drawFrustums(const Programs& programs) const;
  void drawBoxes(const Programs& programs) const;
  void drawCurves(const Programs& programs) const;

  struct PreparedCurve {
    GLint first = 0;
    GLsizei count = 0;
    draw::Material material;
    float lift = 0;
  };

  std::array<Programs, 3> programs_;
  gl::VertexArrayName noVertices_ = gl::VertexArrayName::make();
  gl::VertexArrayName curveVertices_ = gl::VertexArrayName::make();
  gl::BufferName curveBuffer_ = gl::BufferName::make();
  const draw::DrawList* list_ = nullptr;
  float sharpness_ = 1;
  std::vector<StripVertex> vertices_;
  std::vector<PreparedCurve> curves_;
};

}  // namespace poinsot::render
