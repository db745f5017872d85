// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <utility>
#include <vector>

namespace poinsot::python {

/// Picture or film to compare: the name of a PNG or a film as bytes, or an array of rows, columns, and 1 to 4
/// channels (grey, grey and alpha, RGB, RGB and alpha) of uint8 or uint16, without gaps.
using PictureSource = pybind11::object;

/// Arguments of poinsot.diff() that decide how pictures are compared.
struct DiffAsk {
  std::vector<std::pair<std::string, std::string>> rule;  ///< keys and words as in a golden.toml: "max", "0-2"
  std::vector<std::vector<double>> ignore;                ///< boxes: left, top, width, height; pixels
  PictureSource mask;                                     ///< None if there is no mask
  double pixelsPerDegree = 0;
  int jobs = 1;                     ///< frames of films compared at a time
  std::vector<std::string> limits;  ///< words of --limit
};

/// Compares two pictures or two films, and returns the JSON that `diff --json` prints.
/// @throws core::Error(kUsage) for an unknown rule, for pictures of different sizes, and for a film beside a
/// picture; otherwise as compare::compareFiles() and compare::diffFilms().
std::string diffJson(const PictureSource& reference, const PictureSource& test, const DiffAsk& ask);

}  // namespace poinsot::python
