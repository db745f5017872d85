// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

#include "image/image.h"
#include "scene/document/document.h"
#include "scene/limits.h"

/// Values of a golden.toml. All throw core::Error(kScene) that says what was expected and what there is.
namespace poinsot::suite {

[[noreturn]] void refuseValue(const std::string& message);

/// A text that is not empty.
const std::string& textOf(const scene::Node& node);

/// A text, or a number as it would be written in one.
std::string wordOf(const scene::Node& node);

/// A side of a picture in pixels.
int sideOf(const scene::Node& node, const scene::Limits& limits);

/// [width, height] of a picture.
image::PixelSize sizeOf(const scene::Node& node, const scene::Limits& limits);

/// A film time in seconds: 1.5 or "90 ms".
double timeOf(const scene::Node& node);

/// A value, or a list of such. @param element  reads one
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

/// [x, y, width, height] in pixels, or a list of such.
std::vector<image::PixelRect> boxesOf(const scene::Node& node);

/// Whether a path, with its links followed, lies in a folder or below it.
bool isBeneath(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace poinsot::suite
