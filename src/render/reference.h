// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/renderer.h"

namespace poinsot::render {

/// Renders a picture by brute force, to check the anti-aliasing of the normal renderer. Each pixel is the mean of
/// n x n samples with hard edges, in linear light. Text is painted once, because its coverage is already exact.
image::Image renderReference(Renderer& renderer, const draw::DrawList& list, image::PixelSize size, int n);

}  // namespace poinsot::render
