// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "draw/draw_list.h"
#include "draw/picture.h"
#include "scene/scene.h"
#include "stage/palette.h"
#include "stage/picture_layout.h"

/// Type that stands still in a picture: title, notes. (label_layout.h: type that follows its
/// thing.)
namespace poinsot::stage {

/// What type and lines are sized by: the height of the largest 16:9 picture inside one of this size, in pixels.
double referenceHeight(glm::vec2 size_px);

/// Title and subtitle at the top left, set smaller where they would not fit; at the bottom, what is not to scale.
/// Returns how far down the title reaches, in pixels; 0 without one.
double addTitle(draw::Picture& picture, const scene::Scene& scene, const Palette& colors);

/// A panel's title and subtitle, centred over it; `type_px` as of referenceHeight(). Returns how far down they
/// reach from the panel's top.
double addHeading(draw::Picture& picture, const Cell& cell, const scene::View& view, double type_px,
                  const Palette& colors);

}  // namespace poinsot::stage
