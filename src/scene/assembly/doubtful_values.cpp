// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/assemble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include "physics/mass_properties.h"
#include "scene/shapes.h"
#include "scene/units.h"

namespace poinsot::scene {
namespace {

constexpr double kDensest_kg_m3 = 23000;  // osmium, the densest metal, has 22 590 kg/m³
constexpr double kAir_kg_m3 = 1.2;        // at sea level; a body that is lighter would float away
constexpr double kLightest_kg_m3 = 20;    // polystyrene foam, the lightest material of usual bodies
constexpr double kLong_m = 2;             // large for a body whose other lengths have a unit, such as cm

std::optional<double> bareNumber(const Node& node) {
  if (const auto* integer = node.as<std::int64_t>()) return static_cast<double>(*integer);
  if (const auto* number = node.as<double>()) return *number;
  return std::nullopt;
}

/// Returns the SI value of a node, which is a bare number or text with a unit. Returns nullopt for invalid text.
std::optional<double> valueOf(const Node& node, Dimension dimension) {
  const auto* text = node.as<std::string>();
  if (!text) return bareNumber(node);
  const Quantity read = parseQuantity(*text, dimension);
  return read.ok() ? std::optional(read.value) : std::nullopt;
}

std::vector<Node> elementsOf(const Node& node) {
  const auto* array = node.as<Node::Array>();
  return array ? std::vector<Node>(array->begin(), array->end()) : std::vector<Node>{node};
}

void doubtAngle(const std::string& path, const Node& node, Findings& findings) {
  const auto number = bareNumber(node);
  if (!number || *number == 0 || *number != std::round(*number)) return;
  findings.doubt(path, fmt::format("{} is in radians ({:.3g} deg); for degrees write \"{} deg\"", *number,
                                   *number / unitFactor("deg", Dimension::kAngle), *number));
}

void doubtDensity(const std::string& path, const Node& node, Findings& findings) {
  const auto density = valueOf(node, Dimension::kDensity);
  if (density && *density > kDensest_kg_m3)
    findings.doubt(path, fmt::format("a density of {:.4g} kg/m^3 is higher than that of any metal", *density));
}

bool isBodyLength(const std::string& path) {
  return path.starts_with("body") && findKey(path)->dimension == Dimension::kLength;
}

/// Returns whether a length of the body has a unit.
bool haveUnits(const Leaves& leaves) {
  return std::ranges::any_of(leaves.values, [](const auto& leaf) {
    return isBodyLength(leaf.first) && std::ranges::any_of(elementsOf(leaf.second), [](const Node& element) {
             return element.template as<std::string>() != nullptr;
           });
  });
}

void doubtBareLengths(const Leaves& leaves, Findings& findings) {
  if (!haveUnits(leaves)) return;
  for (const auto& [path, node] : leaves.values)
    for (const Node& element : isBodyLength(path) ? elementsOf(node) : std::vector<Node>())
      if (const auto metres = bareNumber(element); metres && std::abs(*metres) >= kLong_m)
        findings.doubt(path, fmt::format("{} is in metres; other lengths of this body have a unit", *metres));
}

/// Doubts a whole number of quarter turns. Few bodies turn at exactly 90 or 360 rad/s.
void doubtSpin(const std::string& path, const Node& node, Findings& findings) {
  constexpr double kQuarter_deg = 90;
  for (const Node& element : elementsOf(node)) {
    const auto number = bareNumber(element);
    if (!number || *number == 0 || std::fmod(*number, kQuarter_deg) != 0) continue;
    return findings.doubt(
        path, fmt::format("{} is in rad/s ({:.3g} turns per second); for degrees per second write \"{} "
                          "deg/s\"",
                          *number, *number / unitFactor("rev/s", Dimension::kAngularVelocity), *number));
  }
}

/// Returns the path of the first length of a piece of the body; empty if there is none.
std::string firstLengthOf(const std::string& table, const Leaves& leaves) {
  for (const std::string_view name : shapeKeyNames())
    if (std::string path = pathBelow(table, name); leaves.values.contains(path) && isBodyLength(path)) return path;
  return "";
}

bool isUsual(double density) { return density >= kLightest_kg_m3 && density <= kDensest_kg_m3; }

/// Doubts metres that should be centimetres or millimetres: a phone 14 m long, if its mass is that of a phone.
void doubtLightness(const std::string& table, double density, const Leaves& leaves, Findings& findings) {
  const std::string path = firstLengthOf(table, leaves);
  if (path.empty() || density >= kAir_kg_m3) return;
  for (const char* unit : {"cm", "mm"}) {
    const double factor = unitFactor(unit, Dimension::kLength);
    if (isUsual(density / (factor * factor * factor)))
      return findings.doubt(
          path,
          fmt::format("is in metres, so the mean density is {:.2g} kg/m^3, less than that of air; for {} write "
                      "\"{} {}\"",
                      density, unit, *bareNumber(elementsOf(leaves.values.find(path)->second)[0]), unit));
  }
}

/// Doubts kilograms that should be grams.
void doubtHeaviness(const std::string& path, double density, const Leaves& leaves, Findings& findings) {
  const auto mass = leaves.values.find(path);
  const auto bare = mass == leaves.values.end() ? std::nullopt : bareNumber(mass->second);
  if (bare && density > kDensest_kg_m3 && isUsual(density / 1000))
    findings.doubt(path,
                   fmt::format("{} is in kilograms, so the mean density is {:.2g} kg/m^3, higher than that of "
                               "any metal; for grams write \"{} g\"",
                               *bare, density, *bare));
}

/// Doubts sizes and masses that do not fit each other, for all solid pieces of the body.
void doubtPieces(const Body& body, const Leaves& leaves, Findings& findings) {
  const bool whole = findings.has("body.shape"), bare = !haveUnits(leaves);
  for (std::size_t i = 0; i < body.parts.size(); ++i) {
    const auto* solid = std::get_if<physics::Solid>(&body.parts[i].figure);
    const double volume_m3 = solid ? physics::volume(*solid) : 0;
    if (!(volume_m3 > 0)) continue;
    const std::string table = whole ? "body" : fmt::format("body.part[{}]", i);
    const double density = body.parts[i].mass_kg / volume_m3;
    if (bare && findings.has(table + ".mass")) doubtLightness(table, density, leaves, findings);
    doubtHeaviness(table + ".mass", density, leaves, findings);
  }
}

}  // namespace

void doubtValues(const Scene& scene, const Leaves& leaves, Findings& findings) {
  for (const auto& [path, node] : leaves.values) {
    const Dimension dimension = findKey(path)->dimension;
    if (dimension == Dimension::kAngle) doubtAngle(path, node, findings);
    if (dimension == Dimension::kDensity) doubtDensity(path, node, findings);
    if (dimension == Dimension::kAngularVelocity) doubtSpin(path, node, findings);
  }
  doubtBareLengths(leaves, findings);
  doubtPieces(scene.body, leaves, findings);
}

}  // namespace poinsot::scene
