// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/carried_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/text.h"
#include "scene/keys/check.h"

namespace poinsot::scene {
namespace {

bool isNumber(const Node& node) { return node.as<std::int64_t>() || node.as<double>(); }
bool isScalar(const Node& node) { return isNumber(node) || node.as<std::string>(); }

double numberOf(const Node& node) {
  const auto* integer = node.as<std::int64_t>();
  return integer ? static_cast<double>(*integer) : *node.as<double>();
}

Node zeroAt(const Place& place) { return {std::int64_t{0}, place}; }

Node listOf(std::vector<Node> elements, const Place& place) { return {Node::Array(std::move(elements)), place}; }

/// Returns a bare number, or an array of them, with a unit. Leaves other values and SI units as they are.
Node withUnit(const Node& given, std::string_view unit, Dimension dimension) {
  if (unit.empty() || parseQuantity(fmt::format("1 {}", unit), dimension).value == 1) return given;
  if (const auto* array = given.as<Node::Array>()) {
    std::vector<Node> elements;
    for (const Node& element : *array) elements.push_back(withUnit(element, unit, dimension));
    return listOf(std::move(elements), given.place);
  }
  return isNumber(given) ? Node{fmt::format("{} {}", describe(given), unit), given.place} : given;
}

/// Returns two integers for a text such as "1920x1080".
std::optional<Node> sidesIn(const Node& given) {
  const auto* text = given.as<std::string>();
  const std::size_t cross = text ? text->find_first_of("x*") : std::string::npos;
  if (cross == std::string::npos) return std::nullopt;
  std::vector<Node> sides;
  for (const std::string_view part : {core::trimmed(std::string_view(*text).substr(0, cross)),
                                      core::trimmed(std::string_view(*text).substr(cross + 1))}) {
    std::int64_t side = 0;
    if (std::from_chars(part.data(), part.data() + part.size(), side).ptr != part.data() + part.size())
      return std::nullopt;
    sides.push_back({side, given.place});
  }
  return listOf(std::move(sides), given.place);
}

/// Returns the magnitude of a vector with a single component that is not zero: 9.81 for gravity [0, 0, -9.81].
std::optional<Node> onlyComponent(const Node& given) {
  const auto* array = given.as<Node::Array>();
  if (!array || !std::ranges::all_of(*array, isNumber)) return std::nullopt;
  double only = 0;
  for (const Node& element : *array) {
    if (only != 0 && numberOf(element) != 0) return std::nullopt;
    if (numberOf(element) != 0) only = std::abs(numberOf(element));
  }
  return Node{only, given.place};
}

/// Returns a word in the spelling of this program: "box" for "cuboid", "#ffffff" for "white".
std::optional<Node> inOurWords(const Key& key, const Node& given) {
  const auto* text = given.as<std::string>();
  if (!text) return std::nullopt;
  const std::string small = core::lowered(*text);
  const std::string_view word = key.type == ValueType::kColor ? namedColor(small) : wordElsewhere(small);
  return Node{word.empty() ? small : std::string(word), given.place};
}

/// Returns the forms of a value to try for a key, its own form first.
std::vector<Node> formsOf(const Key& key, const Node& given) {
  std::vector<Node> forms{given};
  const auto add = [&](std::optional<Node> form) {
    if (form) forms.push_back(std::move(*form));
  };
  if (key.type == ValueType::kVector && isScalar(given)) {
    add(listOf({zeroAt(given.place), zeroAt(given.place), given}, given.place));
    add(listOf({given, given, given}, given.place));
  }
  if (key.type == ValueType::kPixels) add(sidesIn(given));
  if (key.dimension == Dimension::kAcceleration) add(onlyComponent(given));
  if (key.type == ValueType::kWord || key.type == ValueType::kColor) add(inOurWords(key, given));
  return forms;
}

std::vector<KeyLine> lineOf(const Key& key, const std::optional<std::string>& value) {
  if (!value) return {};
  return {{std::string(nameOf(key.path)), *value}};
}

/// Returns a matrix of the six elements xx, xy, xz, yy, yz, zz. Empty if a moment or all products are missing.
std::optional<Node> tensorOf(const std::vector<const Node*>& six) {
  constexpr std::array<std::size_t, 9> kPlaces{0, 1, 2, 1, 3, 4, 2, 4, 5};
  const bool moments = six[0] && six[3] && six[5], products = six[1] || six[2] || six[4];
  if (!moments || !products) return std::nullopt;
  const Place place = six[0]->place;
  std::vector<Node> rows;
  for (std::size_t row = 0; row < 3; ++row) {
    std::vector<Node> elements;
    for (std::size_t column = 0; column < 3; ++column) {
      const Node* element = six[kPlaces[3 * row + column]];
      elements.push_back(element ? *element : zeroAt(place));
    }
    rows.push_back(listOf(std::move(elements), place));
  }
  return listOf(std::move(rows), place);
}

std::optional<Node> listFrom(const std::vector<const Node*>& values) {
  if (std::ranges::find(values, nullptr) != values.end()) return std::nullopt;
  std::vector<Node> elements;
  for (const Node* value : values) elements.push_back(*value);
  return listOf(std::move(elements), values[0]->place);
}

/// Returns a number times a factor. The number may have a unit.
Node scaled(const Node& given, double factor) {
  if (factor == 1) return given;
  if (const auto* array = given.as<Node::Array>()) {
    std::vector<Node> elements;
    for (const Node& element : *array) elements.push_back(scaled(element, factor));
    return listOf(std::move(elements), given.place);
  }
  if (isNumber(given)) return {factor * numberOf(given), given.place};
  const auto* text = given.as<std::string>();
  double number = 0;
  const char* end = text ? std::from_chars(text->data(), text->data() + text->size(), number).ptr : nullptr;
  if (!text || end == text->data()) return given;
  return {fmt::format("{:.6g}{}", factor * number, std::string_view(end, text->data() + text->size() - end)),
          given.place};
}

std::optional<Node> below(const Node& distance) {
  if (!isScalar(distance)) return std::nullopt;
  return listOf({zeroAt(distance.place), zeroAt(distance.place), scaled(distance, -1)}, distance.place);
}

std::optional<Node> scalarFirst(const Node& given) {
  const auto* array = given.as<Node::Array>();
  if (!array || array->size() != 4) return std::nullopt;
  return listOf({(*array)[3], (*array)[0], (*array)[1], (*array)[2]}, given.place);
}

/// Returns the azimuth and the elevation of a camera at a position.
std::vector<KeyLine> directionOf(const Node& position) {
  const auto* array = position.as<Node::Array>();
  if (!array || array->size() != 3 || !std::ranges::all_of(*array, isNumber)) return {};
  const double x = numberOf((*array)[0]), y = numberOf((*array)[1]), z = numberOf((*array)[2]);
  const double across = std::hypot(x, y), degrees = 180 / std::numbers::pi;
  if (!std::isfinite(across) || !std::isfinite(z) || std::hypot(across, z) == 0) return {};
  return {{"azimuth", fmt::format("\"{:.4g} deg\"", std::atan2(y, x) * degrees)},
          {"elevation", fmt::format("\"{:.4g} deg\"", std::atan2(z, across) * degrees)}};
}

}  // namespace

std::optional<std::string> carriedValue(const Key& key, const Node& given, const Limits& limits,
                                        std::string_view unit) {
  for (const Node& form : formsOf(key, withUnit(given, unit, key.dimension))) {
    Problems ignored;
    if (check(key, key.path, form, ignored, limits)) return tomlText(form);
  }
  return std::nullopt;
}

std::vector<KeyLine> carriedLines(const ForeignNames& row, const Key& key, const std::vector<const Node*>& values,
                                  const Limits& limits) {
  const auto carried = [&](const std::optional<Node>& node) {
    return node ? lineOf(key, carriedValue(key, scaled(*node, row.factor), limits, row.unit))
                : std::vector<KeyLine>();
  };
  switch (row.carry) {
    case Carry::kValue:
      return carried(*values[0]);
    case Carry::kNothing:
      return {};
    case Carry::kList:
      return carried(listFrom(values));
    case Carry::kTensor:
      return carried(tensorOf(values));
    case Carry::kXyzw:
      return carried(scalarFirst(*values[0]));
    case Carry::kBelow:
      return carried(below(*values[0]));
    case Carry::kPosition:
      return directionOf(*values[0]);
  }
  return {};
}

std::string unitInName(std::string_view suffix, Dimension dimension) {
  std::string blanks(suffix), divided(suffix);
  std::ranges::replace(blanks, '_', ' ');
  std::ranges::replace(divided, '_', '/');
  std::string last = blanks;  // kg_m2_s is kg m2/s
  if (const std::size_t end = last.rfind(' '); end != std::string::npos) last[end] = '/';
  for (const std::string& unit : {blanks, last, divided})
    if (dimension != Dimension::kNone && parseQuantity("1 " + unit, dimension).ok()) return unit;
  return "";
}

}  // namespace poinsot::scene
