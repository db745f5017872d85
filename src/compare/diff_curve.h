// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "compare/film_diff.h"
#include "output/file_kind.h"

namespace poinsot::compare {

/// Where the curve of a film's picture begins and ends, as shares of its width.
inline constexpr double kCurveLeft = 0.055, kCurveRight = 0.985;

/// The figures over time: a line for each frame, CSV with a header.
std::string curveCsv(const FilmDiff& diff);

/// FLIP's largest and mean over time as an SVG picture, each with its limit, above a strip of the verdicts. Where
/// frames are many, each point has the most of those that it stands for.
std::string curveSvg(const FilmDiff& diff, const NearRule& rule);

/// Curves of this program, in the form that the name of a file asks for: .csv or .svg.
/// @throws core::Error(kUsage) for another name.
output::FileKind curveKind(const std::filesystem::path& file);

/// The curve in the form that the name says.
std::string curveText(const std::filesystem::path& file, const FilmDiff& diff, const NearRule& rule);

}  // namespace poinsot::compare
