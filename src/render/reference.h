// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/renderer.h"

namespace poinsot::render {

/// Renders a picture by brute force: n x n hard-edged samples a pixel, averaged in linear light. Slow; used to
/// judge the analytic edges. Type is exact already and is painted once.
image::Image renderReference(Renderer& renderer, const draw::DrawList& list, image::PixelSize size, int n);

}  // namespace poinsot::render
