// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compare/picture_diff.h"

namespace poinsot::python {

/// Picture or film to compare: the name of a PNG or a film as bytes, or an array of rows, columns, and 1 to 4
/// channels (grey, grey and alpha, RGB, RGB and alpha) of uint8 or uint16, without gaps.
using PictureSource = pybind11::object;
using Source = std::variant<std::filesystem::path, compare::DiffPicture>;

/// Keys and words of a rule as in a golden.toml, such as "max" and "0-2".
using RuleWords = std::vector<std::pair<std::string, std::string>>;

/// Converts an array as in PictureSource to a picture of RGB, or of RGB and alpha.
compare::DiffPicture pictureOf(const pybind11::array& array);

Source sourceOf(const PictureSource& source);

/// @throws core::Error(kUsage) if a key or a word is unknown, or if the rule lets every picture pass
compare::NearRule limitsOf(const RuleWords& rule);

/// Returns a rule with ignored boxes (left, top, width, height; pixels). @throws core::Error(kUsage) as limitsOf()
compare::PictureRule ruleOf(const RuleWords& rule, const std::vector<std::vector<double>>& ignore);

}  // namespace poinsot::python
