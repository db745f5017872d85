// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "image/image.h"

namespace poinsot::image {

/// Slips of programs that read pixels back: rows from the bottom, columns from the right, blue before red.
enum class Symmetry { kUpsideDown, kMirrored, kRedAndBlueExchanged };

/// Returns the one that makes `test` from `reference`. @pre both have the same shape, and differ.
std::optional<Symmetry> symmetryOf(const Image& reference, const Image& test);
std::optional<Symmetry> symmetryOf(const DeepImage& reference, const DeepImage& test);

}  // namespace poinsot::image
