// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "compare/film_diff.h"
#include "output/file_kind.h"

namespace poinsot::compare {

/// Left and right end of the time axis in a film's diagram, as fractions of the diagram's width.
inline constexpr double kCurveLeft = 0.055, kCurveRight = 0.985;

/// Returns the figures of all frames as CSV, with a header and one line per frame.
std::string curveCsv(const FilmDiff& diff);

/// Returns an SVG diagram of FLIP's maximum and mean over time, with their limits. A strip below shows the
/// verdicts. For long films, each point shows the maximum of several frames.
std::string curveSvg(const FilmDiff& diff, const NearRule& rule);

/// Returns the kind of curve file by the file's extension, .csv or .svg.
/// @throws core::Error(kUsage) for other extensions
output::FileKind curveKind(const std::filesystem::path& file);

/// Returns the curve in the format that the file's extension selects: CSV for .csv, SVG otherwise.
std::string curveText(const std::filesystem::path& file, const FilmDiff& diff, const NearRule& rule);

}  // namespace poinsot::compare
