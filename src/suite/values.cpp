// SPDX-License-Identifier: Apache-2.0
#include "suite/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "compare/picture_rule.h"
#include "core/error.h"
#include "scene/units.h"

namespace poinsot::suite {
namespace {

namespace fs = std::filesystem;
using scene::Node;

double numberOf(const Node& node) {
  const auto* whole = node.as<std::int64_t>();
  if (!whole) refuseValue(fmt::format("expected a whole number of pixels, got {}", describe(node)));
  return static_cast<double>(*whole);
}

/// Returns a path with its links resolved, as far as the path exists. Returns an empty path on failure.
fs::path real(const fs::path& path) {
  std::error_code failure;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path, failure), failure);
  if (failure) return {};
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

void refuseValue(const std::string& message) { throw core::sceneError(message); }

const std::string& textOf(const Node& node) {
  const auto* text = node.as<std::string>();
  if (!text || text->empty()) refuseValue(fmt::format("expected text, got {}", describe(node)));
  return *text;
}

int sideOf(const Node& node, const scene::Limits& limits) {
  const auto* side = node.as<std::int64_t>();
  const std::int64_t most = limits[scene::Limit::kSide];
  if (!side || *side < scene::kLeastSide || *side > most)
    refuseValue(fmt::format("expected pixels from {} to {}, got {}{}", scene::kLeastSide, most, describe(node),
                            side && *side > most ? "; " + howToRaise(scene::Limit::kSide) : ""));
  return static_cast<int>(*side);
}

image::PixelSize sizeOf(const Node& node, const scene::Limits& limits) {
  const auto* sides = node.as<Node::Array>();
  if (!sides || sides->size() != 2) refuseValue(fmt::format("expected [width, height], got {}", describe(node)));
  return {sideOf((*sides)[0], limits), sideOf((*sides)[1], limits)};
}

double timeOf(const Node& node) {
  const auto* whole = node.as<std::int64_t>();
  const auto* number = node.as<double>();
  double t_s = whole ? static_cast<double>(*whole) : number ? *number : -1;
  if (const auto* text = node.as<std::string>()) {
    const auto quantity = scene::parseQuantity(*text, scene::Dimension::kTime);
    t_s = quantity.ok() ? quantity.value : -1;
  }
  if (!(t_s >= 0))
    refuseValue(fmt::format("expected a film time such as 1.5 or \"90 ms\", got {}", describe(node)));
  return t_s;
}

std::string wordOf(const Node& node) {
  if (const auto* whole = node.as<std::int64_t>()) return fmt::format("{}", *whole);
  if (const auto* number = node.as<double>()) return fmt::format("{}", *number);
  return textOf(node);
}

std::vector<image::PixelRect> boxesOf(const Node& node) {
  const auto* list = node.as<Node::Array>();
  if (!list || list->empty())
    refuseValue(fmt::format("expected [[x, y, width, height], ...], got {}", describe(node)));
  if (!list->front().as<Node::Array>()) return {compare::ignoredBox(describe(node), listOf(node, numberOf))};
  return listOf(node, [](const Node& n) { return compare::ignoredBox(describe(n), listOf(n, numberOf)); });
}

bool isBeneath(const fs::path& path, const fs::path& folder) {
  const fs::path inner = real(path), outer = real(folder);
  return !inner.empty() && !outer.empty() && std::ranges::mismatch(outer, inner).in1 == outer.end();
}

}  // namespace poinsot::suite
