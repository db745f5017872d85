// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "image/image.h"
#include "scene/document/document.h"
#include "scene/limits.h"

/// Functions that read values of a golden.toml. All throw core::Error(kScene) with the expected value and the
/// actual one.
namespace poinsot::suite {

[[noreturn]] void refuseValue(const std::string& message);

/// Returns a node's text, which must not be empty.
const std::string& textOf(const scene::Node& node);

/// Returns a node's text. Converts a number to text.
std::string wordOf(const scene::Node& node);

/// Returns the width or height of a picture in pixels, from scene::kLeastSide to scene::Limit::kSide.
int sideOf(const scene::Node& node, const scene::Limits& limits);

image::PixelSize sizeOf(const scene::Node& node, const scene::Limits& limits);

/// Returns a film time in seconds, which the manifest gives as 1.5 or "90 ms".
double timeOf(const scene::Node& node);

/// Returns the elements of a list. A single value counts as a list with one element.
/// @param element  function that reads one element
template <class F>
auto listOf(const scene::Node& node, F element) {
  std::vector<std::decay_t<decltype(element(node))>> list;
  if (const auto* nodes = node.as<scene::Node::Array>())
    for (const scene::Node& one : *nodes) list.push_back(element(one));
  else
    list.push_back(element(node));
  if (list.empty()) refuseValue("expected at least one");
  return list;
}

/// Returns one or more rectangles. The manifest gives a rectangle as [x, y, width, height] in pixels, or a list of
/// them.
std::vector<image::PixelRect> boxesOf(const scene::Node& node);

/// Reports whether a path, with its links resolved, is a folder or lies below that folder.
bool isBeneath(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace poinsot::suite
