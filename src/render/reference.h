// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/renderer.h"

namespace poinsot::render {

/// The picture by brute force: n x n hard-edged samples a pixel, averaged in linear light. Slow; what the analytic
/// edges are judged against. Type is laid over once, as it is exact already.
image::Image renderReference(Renderer& renderer, const draw::DrawList& list, image::PixelSize size, int n);

}  // namespace poinsot::render
