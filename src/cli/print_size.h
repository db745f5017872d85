// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "image/image.h"
#include "request/picture_form.h"
#include "scene/limits.h"

namespace poinsot::cli {

/// A width on paper: a number with mm, cm, in or pt, such as "86mm" or "3.4 in". A point is TeX's, 1/72.27 inch,
/// as \the\columnwidth prints it.
/// @throws core::Error(kUsage) when it is no such thing or not more than 0.
double parseWidth_mm(const std::string& word);

/// The pixels of a print whose sides are as those of `proportion`.
/// @throws core::Error(kLimit) beyond the limits of a picture, saying how many dpi would do.
image::PixelSize printedPixels(const request::PrintSize& print, image::PixelSize proportion,
                               const scene::Limits& limits);

}  // namespace poinsot::cli
