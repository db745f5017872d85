// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "image/image.h"

namespace poinsot::compare {

/// Slips of programs that read pixels back: rows from the bottom, columns from the right, blue before red.
enum class Symmetry { kUpsideDown, kMirrored, kRedAndBlueExchanged };

/// Returns the one that makes `test` from `reference`. @pre both have the same shape, and differ.
std::optional<Symmetry> symmetryOf(const image::Image& reference, const image::Image& test);
std::optional<Symmetry> symmetryOf(const image::DeepImage& reference, const image::DeepImage& test);

}  // namespace poinsot::compare
