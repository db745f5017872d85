// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "request/output_target.h"
#include "request/picture_options.h"
#include "scene/limits.h"

namespace poinsot::cli {

class Command;

/// Parses a time: a number of seconds, or a number with a unit of time as in scene files. Infinity and NaN are
/// possible results.
/// @throws core::Error(kUsage) naming the option
double parseTime_s(std::string_view option, const std::string& word);

/// Parses times that are separated by commas, such as "0,-1.5,90 ms".
/// @throws core::Error(kUsage) naming the option
std::vector<double> parseTimes_s(std::string_view option, std::string_view words);

/// Converts the value of --times, such as "0,0.9,1.8" or "0..3.6:5", to an override with a range of
/// scene::kInstantKey.
/// @throws core::Error(kUsage) if a time is malformed or negative, or if the times do not increase
std::string instantsOverride(const std::string& times);

/// Parses a width on paper: a number with mm, cm, in or pt, such as "86mm" or "3.4 in". A point is 1/72.27 inch as
/// in TeX, so users can copy the value of \the\columnwidth.
/// @throws core::Error(kUsage) if the text is malformed, or the width is less than 15 mm
double parseWidth_mm(const std::string& word);

/// Parses the size of text on paper: a number with pt, mm, cm or in, such as "8pt". A point is 1/72.27 inch.
/// @returns the size in points of 1/72 inch
/// @throws core::Error(kUsage) if the text is malformed, or the size is not from 3 to 40 pt
double parseTypeSize_pt(const std::string& word);

/// Returns the size in pixels of a picture on paper, with the aspect ratio of `proportion`.
/// @throws core::Error(kLimit) if a side is too small or too large, naming an allowed --dpi
image::PixelSize printedPixels(const request::PrintSize& print, image::PixelSize proportion,
                               const scene::Limits& limits);

/// Parses the size of a file: a number of bytes, or a number with kB, MB, GB (powers of 1000) or KiB, MiB, GiB
/// (powers of 1024), such as "5MB" or "1.5 MiB".
/// @throws core::Error(kUsage) naming the option
std::int64_t parseFileSize_bytes(std::string_view option, const std::string& word);

/// Returns a size of a file with three digits, such as "4.63 MB".
std::string fileSizeText(std::int64_t size_bytes);

void addBitsOption(const Command& command, int& bits);

/// @throws core::Error(kUsage) if pictures of the target cannot have that many bits, naming targets that can
void checkBits(int bits, const request::OutputTarget& target);

}  // namespace poinsot::cli
