// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/carried_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/number.h"
#include "core/text.h"
#include "scene/keys/check.h"
#include "scene/keys/value_forms.h"

namespace poinsot::scene {
namespace {

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
    rows.push_back(listNode(std::move(elements), place));
  }
  return listNode(std::move(rows), place);
}

std::optional<Node> listFrom(const std::vector<const Node*>& values) {
  if (std::ranges::find(values, nullptr) != values.end()) return std::nullopt;
  std::vector<Node> elements;
  for (const Node* value : values) elements.push_back(*value);
  return listNode(std::move(elements), values[0]->place);
}

std::optional<Node> below(const Node& distance) {
  if (!isScalar(distance)) return std::nullopt;
  return listNode({zeroAt(distance.place), zeroAt(distance.place), scaled(distance, -1)}, distance.place);
}

/// Returns the vector [a, a, c] of two values.
std::optional<Node> symmetric(const std::vector<const Node*>& two) {
  if (two.size() != 2 || !two[0] || !two[1] || !isScalar(*two[0]) || !isScalar(*two[1])) return std::nullopt;
  return listNode({*two[0], *two[0], *two[1]}, two[0]->place);
}

/// Returns a vector of a magnitude and a direction, which may be a vector or the name of an axis.
std::optional<Node> directed(const std::vector<const Node*>& two) {
  if (two.size() != 2 || !two[0] || !two[1] || !isScalar(*two[0])) return std::nullopt;
  Node direction = *two[1];
  if (const auto* text = direction.as<std::string>(); text && !numbersIn(direction)) {
    const char last = text->empty() ? ' ' : text->back();
    const std::size_t axis = std::string_view("xyz123").find(last);
    if (axis == std::string_view::npos) return std::nullopt;
    std::vector<Node> unit(3, zeroAt(direction.place));
    unit[axis % 3] = {std::int64_t{1}, direction.place};
    direction = listNode(std::move(unit), direction.place);
  } else if (text) {
    direction = *numbersIn(direction);
  }
  const auto* array = direction.as<Node::Array>();
  if (!array || array->size() != 3) return std::nullopt;
  double squares = 0;
  for (const Node& element : *array) {
    const auto number = numberIn(element);
    if (!number) return std::nullopt;
    squares += *number * *number;
  }
  if (!(squares > 0) || !std::isfinite(squares)) return std::nullopt;
  std::vector<Node> elements;
  for (const Node& element : *array) {
    Node one = scaled(*two[0], *numberIn(element) / std::sqrt(squares));
    if (const auto number = numberIn(one))
      one = {std::strtod(fmt::format("{:.6g}", *number).c_str(), nullptr), one.place};
    elements.push_back(std::move(one));
  }
  return listNode(std::move(elements), two[0]->place);
}

std::optional<Node> reversed(const Node& given) {
  const auto* array = given.as<Node::Array>();
  if (!array || array->size() != 3) return std::nullopt;
  return listNode({(*array)[2], (*array)[1], (*array)[0]}, given.place);
}

/// Returns a rate of one turn per period, in the unit of the period.
std::optional<Node> rateOf(const Node& period, std::string_view unit) {
  std::string ofTime(unit.empty() ? "s" : unit);
  auto time = numberIn(period);
  if (const auto* text = period.as<std::string>()) {
    double number = 0;
    const auto read = std::from_chars(text->data(), text->data() + text->size(), number);
    if (read.ec != std::errc() || !parseQuantity(*text, Dimension::kTime).ok()) return std::nullopt;
    time = number;
    ofTime = core::trimmed(std::string_view(read.ptr, text->data() + text->size()));
  }
  if (!time || !(*time > 0)) return std::nullopt;
  return Node{fmt::format("{:.6g} rev/{}", 1 / *time, ofTime), period.place};
}

/// Returns the number 1/n as text of few digits; empty for other values.
std::optional<Node> inverse(const Node& given, double numerator) {
  const auto number = numberIn(given);
  if (!number || !(*number > 0)) return std::nullopt;
  return Node{std::strtod(fmt::format("{:.6g}", numerator / *number).c_str(), nullptr), given.place};
}

/// Returns the speed for a factor by which a film is slower. A factor below 1 is already the speed.
std::optional<Node> speedOf(const Key& key, const Node& slowness) {
  for (const Node& form : formsOf(key, slowness))
    if (const auto number = numberIn(form); number && *number > 0)
      return *number > 1 ? inverse(form, 1) : std::optional(form);
  return std::nullopt;
}

std::optional<Node> spanOf(const Node& given) {
  const auto* array = given.as<Node::Array>();
  if (!array || array->size() < 2) return std::nullopt;
  const auto from = numberIn(array->front()), to = numberIn(array->back());
  if (from && to) return Node{*to - *from, given.place};
  if (from && *from == 0) return array->back();
  return std::nullopt;
}

/// Returns the moments [1, 1, 1 + e] of an ellipticity e.
std::optional<Node> momentsOf(const Node& ellipticity) {
  for (const Node& form : formsOf(*findKey("time.speed"), ellipticity))  // a number, or a text such as "1/305"
    if (const auto e = numberIn(form); e && *e > -1 && *e <= 1) {
      const double c = std::strtod(fmt::format("{:.8g}", 1 + *e).c_str(), nullptr);
      const Node one{std::int64_t{1}, ellipticity.place};
      return listNode({one, one, {c, ellipticity.place}}, ellipticity.place);
    }
  return std::nullopt;
}

/// Returns the number of a value in SI units in the first form that a key accepts.
std::optional<double> siIn(std::string_view key, const Node* given, const Limits& limits) {
  const Key* known = given && isScalar(*given) ? findKey(key) : nullptr;
  const auto text = known ? carriedValue(*known, *given, limits) : std::nullopt;
  const auto numbers = text ? numbersInToml(*text, known->dimension) : std::vector<double>();
  return numbers.empty() ? std::nullopt : std::optional(numbers[numbers.size() == 3 ? 2 : 0]);
}

/// Returns the velocity of a throw with this speed at this angle above the ground.
std::optional<Node> launched(const std::vector<const Node*>& two, const Limits& limits) {
  if (two.size() != 2) return std::nullopt;
  const auto speed = siIn("motion.flight.velocity", two[0], limits), angle = siIn("motion.lean", two[1], limits);
  if (!speed || !angle) return std::nullopt;
  const Place place = two[0]->place;
  const auto part = [&](double value) {
    return Node{std::strtod(fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0 : value).c_str(), nullptr), place};
  };
  return listNode({part(*speed * std::cos(*angle)), zeroAt(place), part(*speed * std::sin(*angle))}, place);
}

/// Returns a size in pixels for a size in inches and the pixels of an inch, of which 100 are usual.
std::optional<Node> pixelsOf(const std::vector<const Node*>& values) {
  if (values.empty() || !values[0] || !values[0]->as<Node::Array>()) return std::nullopt;
  const auto dpi = values.size() > 1 && values[1] ? numberIn(*values[1]) : 100;
  return dpi ? std::optional(scaled(*values[0], *dpi)) : std::nullopt;
}

std::vector<KeyLine> orbitLines(const Node& given) {
  const auto* array = given.as<Node::Array>();
  if (!array || array->size() != 2 || !numberIn((*array)[0]) || !numberIn((*array)[1])) return {};
  const double from = *numberIn((*array)[0]), to = *numberIn((*array)[1]);
  if (!(std::abs(from) <= 360) || !(std::abs(to - from) <= 36000)) return {};
  return {{"azimuth", fmt::format("\"{:g} deg\"", from)}, {"orbit", fmt::format("\"{:g} deg\"", to - from)}};
}

std::vector<KeyLine> frameLines(const Node& given) {
  const auto* flag = given.as<bool>();
  if (!flag) return {};
  return {{"frame", *flag ? "\"body\"" : "\"space\""}};
}

const Node* firstOf(const std::vector<const Node*>& values) {
  const auto found = std::ranges::find_if(values, [](const Node* value) { return value != nullptr; });
  return found == values.end() ? nullptr : *found;
}

std::optional<Node> scalarFirst(const Node& given) {
  const auto* array = given.as<Node::Array>();
  if (!array || array->size() != 4) return std::nullopt;
  return listNode({(*array)[3], (*array)[0], (*array)[1], (*array)[2]}, given.place);
}

/// Returns the azimuth and the elevation of a camera at a position.
std::vector<KeyLine> directionOf(const Node& position) {
  const auto* array = position.as<Node::Array>();
  if (!array || array->size() != 3 ||
      !std::ranges::all_of(*array, [](const Node& n) { return numberIn(n).has_value(); }))
    return {};
  const double x = *numberIn((*array)[0]), y = *numberIn((*array)[1]), z = *numberIn((*array)[2]);
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
    case Carry::kSymmetric:
      return carried(symmetric(values));
    case Carry::kDirected:
      return carried(directed(values));
    case Carry::kReversed:
      return carried(reversed(*values[0]));
    case Carry::kEllipticity:
      return carried(momentsOf(*values[0]));
    case Carry::kLaunch:
      return carried(launched(values, limits));
    case Carry::kPeriod: {
      const auto rate = rateOf(*values[0], row.unit);
      return rate ? lineOf(key, carriedValue(key, *rate, limits)) : std::vector<KeyLine>();
    }
    case Carry::kSlowness:
      return carried(speedOf(key, *values[0]));
    case Carry::kInterval: {
      const auto rate = inverse(*values[0], row.unit == "ms" && numberIn(*values[0]).value_or(0) >= 1 ? 1000 : 1);
      return rate ? lineOf(key, carriedValue(key, *rate, limits)) : std::vector<KeyLine>();
    }
    case Carry::kEuler:
      return eulerLines(key, withUnit(*values[0], row.unit, key.dimension), limits);
    case Carry::kInches:
      return carried(pixelsOf(values));
    case Carry::kSpan:
      return carried(spanOf(*values[0]));
    case Carry::kOrbit:
      return orbitLines(*values[0]);
    case Carry::kFrame:
      return frameLines(*values[0]);
    case Carry::kEither: {
      const Node* first = firstOf(values);
      return first ? lineOf(key, carriedValue(key, *first, limits)) : std::vector<KeyLine>();
    }
    case Carry::kFrames:  // needs the frames per second
    case Carry::kFilm:    // needs other values of the scene
    case Carry::kShown:   // becomes keys of several tables
    case Carry::kPlot:    // becomes a table
    case Carry::kArrow:   // becomes a key of [show]
    case Carry::kPoints:  // becomes several tables
    case Carry::kRemove:
      return {};
  }
  return {};
}

std::vector<KeyLine> eulerLines(const Key& key, const Node& three, const Limits& limits) {
  Key vector = key;  // reads a table or a text of three values
  vector.type = ValueType::kVector;
  for (const Node& form : formsOf(vector, three)) {
    const auto* array = form.as<Node::Array>();
    if (!array || array->size() != 3) continue;
    std::vector<KeyLine> lines;
    for (std::size_t i = 0; i < 3; ++i) {
      constexpr std::array<std::string_view, 3> kNames{"precession", "nutation", "spin"};
      const Key* one = findKey(pathBelow(tableOf(key.path), kNames[i]));
      Problems ignored;
      if (one && check(*one, one->path, (*array)[i], ignored, limits))
        lines.push_back({std::string(kNames[i]), tomlText((*array)[i])});
    }
    if (lines.size() == 3) return lines;
  }
  return {};
}

std::optional<double> secondsIn(const Node* given) {
  if (!given) return std::nullopt;
  if (const auto number = numberIn(*given)) return number;
  const auto* text = given->as<std::string>();
  if (!text) return std::nullopt;
  const Quantity time = parseQuantity(*text, Dimension::kTime);
  return time.ok() && std::isfinite(time.value) ? std::optional(time.value) : std::nullopt;
}

std::optional<double> dateIn(const Node* given) {
  const auto* text = given ? given->as<std::string>() : nullptr;
  if (!text || text->size() < 10 || text->size() > 40) return std::nullopt;
  const auto part = [&](std::size_t begin, std::size_t count) {
    return begin + count <= text->size() ? core::parseInteger<int>(text->substr(begin, count)) : std::nullopt;
  };
  const auto year = part(0, 4), month = part(5, 2), day = part(8, 2);
  if (!year || !month || !day || (*text)[4] != '-' || (*text)[7] != '-') return std::nullopt;
  if (*month < 1 || *month > 12 || *day < 1 || *day > 31 || *year < 1) return std::nullopt;
  const std::chrono::sys_days days = std::chrono::year(*year) / std::chrono::month(static_cast<unsigned>(*month)) /
                                     std::chrono::day(static_cast<unsigned>(*day));
  return 86400.0 * static_cast<double>(days.time_since_epoch().count()) + 3600 * part(11, 2).value_or(0) +
         60 * part(14, 2).value_or(0) + part(17, 2).value_or(0);
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
