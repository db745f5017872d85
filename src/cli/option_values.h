// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "request/output_target.h"
#include "request/picture_options.h"
#include "scene/limits.h"

namespace poinsot::cli {

class Command;

/// A number of seconds, or a number with a unit of time as scene files have it; possibly not finite.
/// @throws core::Error(kUsage) naming the option
double parseTime_s(std::string_view option, const std::string& word);

/// "0,-1.5,90 ms", separated by commas.
/// @throws core::Error(kUsage) naming the option
std::vector<double> parseTimes_s(std::string_view option, std::string_view words);

/// A width on paper: a number with mm, cm, in or pt, such as "86mm" or "3.4 in". A point is TeX's, 1/72.27 inch,
/// as \the\columnwidth prints it.
/// @throws core::Error(kUsage) when it is no such thing or not more than 0.
double parseWidth_mm(const std::string& word);

/// The pixels of a print whose sides are as those of `proportion`.
/// @throws core::Error(kLimit) beyond the limits of a picture, saying how many dpi would do.
image::PixelSize printedPixels(const request::PrintSize& print, image::PixelSize proportion,
                               const scene::Limits& limits);

/// Declares --bits.
void addBitsOption(const Command& command, int& bits);

/// @throws core::Error(kUsage) where the target takes no pictures of that many bits, saying what does.
void checkBits(int bits, const request::OutputTarget& target);

}  // namespace poinsot::cli
