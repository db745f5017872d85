// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/film_diff.h"

namespace poinsot::app {

/// Where the curve of a film's picture begins and ends, as shares of its width.
inline constexpr double kCurveLeft = 0.055, kCurveRight = 0.985;

/// The figures over time: a line for each frame, CSV with a header.
std::string curveCsv(const FilmDiff& diff);

/// FLIP's largest and mean over time as an SVG picture, each with its limit, above a strip of the verdicts. Where
/// frames are many, each point has the most of those that it stands for.
std::string curveSvg(const FilmDiff& diff, const image::NearRule& rule);

/// Whether a file of that name gets a curve: .csv or .svg. @throws core::Error(kUsage) if not; as
/// output::checkTarget(), which knows a curve of an earlier run: a
/// table by its first line.
void checkCurveTarget(const std::filesystem::path& file, bool force);

/// Writes it in the form that the name says.
void writeCurve(const std::filesystem::path& file, const FilmDiff& diff, const image::NearRule& rule);

}  // namespace poinsot::app
