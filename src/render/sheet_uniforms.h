// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/sheets.h"

/// Tells a program about the chosen sheets of one kind; the names are those of composite.frag.
namespace poinsot::render {

void setEllipsoids(const gl::ShaderProgram& program, const draw::DrawList& list,
                   const std::vector<EllipsoidSheet>& sheets, const std::vector<std::size_t>& chosen);

void setPlanes(const gl::ShaderProgram& program, const draw::DrawList& list, const std::vector<PlaneSheet>& sheets,
               const std::vector<std::size_t>& chosen);

void setCones(const gl::ShaderProgram& program, const draw::DrawList& list, const std::vector<ConeSheet>& sheets,
              const std::vector<std::size_t>& chosen);

/// @param sides  that the program has room for in each polygon
void setPolygons(const gl::ShaderProgram& program, const draw::DrawList& list,
                 const std::vector<PolygonSheet>& sheets, const std::vector<std::size_t>& chosen,
                 std::size_t sides);

}  // namespace poinsot::render
