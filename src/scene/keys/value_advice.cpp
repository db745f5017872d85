// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/value_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "scene/keys/carried_value.h"
#include "scene/keys/foreign_words.h"
#include "scene/keys/shape_advice.h"
#include "scene/keys/unknown_names.h"
#include "scene/keys/value_forms.h"

namespace poinsot::scene {
namespace {

std::string pastedLine(std::string_view name, std::string_view value) {
  return fmt::format("\n    {} = {}", name, value);
}

/// Returns advice for a film that is as long as a motion of hours or days.
std::string filmAdvice(const Node& given, const Leaves& leaves) {
  const auto span_s = secondsIn(&given);
  if (!span_s || !(*span_s > static_cast<double>(leaves.limits[Limit::kDuration]))) return "";
  const std::string text = ". It is the length of the film, not of the motion.";
  if (leaves.meant.contains("time.speed")) return text;
  const auto known = leaves.values.find("time.speed");
  const bool hasSpeed = known != leaves.values.end();
  const auto speed = hasSpeed ? numberIn(known->second) : std::nullopt;
  const double film_s = speed && *speed > 0 ? *span_s / *speed : 0;
  if (film_s >= 1 && film_s <= 600)
    return text + " For example:" + pastedLine("duration", fmt::format("{:.6g}", film_s));
  return text + " For example:" + pastedLine("duration", "\"20 s\"") +
         (hasSpeed ? "" : pastedLine("speed", fmt::format("{:.6g}", *span_s / kUsualFilm_s)));
}

std::string startAdvice(const Node& given, const Leaves& leaves) {
  if (!dateIn(&given) && !given.as<DateOrTime>()) return "";
  const std::string text = ". Time counts from the start of the motion, without a date.";
  return leaves.meant.contains("time.start") ? text : text + " For example:" + pastedLine("start", "0");
}

/// Returns motion.lean for a tilt of a quarter turn or more, which only a top under gravity can have.
std::string tiltAdvice(const Node& given) {
  const auto angle_rad = numberIn(given);
  if (!angle_rad || !(*angle_rad > 0 && *angle_rad <= std::numbers::pi)) return "";
  return ". The angle to the vertical under gravity is motion.lean. For example, in place of tilt:" +
         pastedLine("lean", tomlText(given));
}

/// Returns the key that takes an angle in place of motion.nutation, which names a kind of nutation.
std::string nutationAdvice(const Node& given, const Leaves& leaves) {
  const bool spins = leaves.values.contains("motion.spin") || leaves.meant.contains("motion.spin");
  std::vector<std::string> names{"euler.nutation"};
  if (isUnderGravity(leaves))
    names.insert(names.begin(), "lean");
  else if (spins)
    names.insert(names.begin(), "tilt");
  for (const std::string& name : names)
    if (const auto angle = carriedValue(*findKey("motion." + name), given, leaves.limits))
      return fmt::format(". An angle is motion.{}. For example, in place of nutation:", name) +
             pastedLine(name, *angle);
  return "";
}

std::string colorAdvice(const Node& given) {
  const auto* text = given.as<std::string>();
  if (!text || !(text->starts_with('#') || !namedColor(plainWord(*text)).empty())) return "";
  return ". It names a colour of [style.colors], where the colours themselves are. For example:" +
         pastedLine("color", "\"vector\"");
}

std::string adviceOf(const Key& key, const std::string& path, const Node& given, Leaves& leaves) {
  if (key.path == "time.duration")
    if (std::string advice = filmAdvice(given, leaves); !advice.empty()) return advice;
  if (key.path == "time.start")
    if (std::string advice = startAdvice(given, leaves); !advice.empty()) return advice;
  if (key.path == "motion.tilt")
    if (std::string advice = tiltAdvice(given); !advice.empty()) return advice;
  if (key.path == "motion.nutation")
    if (std::string advice = nutationAdvice(given, leaves); !advice.empty()) return advice;
  if (key.path == "vector[].color")
    if (std::string advice = colorAdvice(given); !advice.empty()) return advice;
  if (given.as<Node::Array>() && key.type == ValueType::kNumber)
    if (std::string advice = adviceFor(path, given, leaves); !advice.empty())
      return advice;  // three numbers for L are a vector, which has another key
  const auto carried = carriedValue(key, given, leaves.limits);
  const bool isSize = nameOf(path) == "size" && key.dimension == Dimension::kLength;
  if (carried)
    return (isSize ? ". It takes full extents, not halves. For example:" : " For example:") +
           pastedLine(nameOf(path), *carried);
  const bool isPlain = key.type == ValueType::kNumber && key.dimension == Dimension::kNone && key.words.empty();
  return isPlain && !key.example.empty() ? " For example:" + pastedLine(nameOf(path), key.example) : "";
}

}  // namespace

std::string withAdvice(std::string message, const std::string& path, const Node& given, Leaves& leaves) {
  if (!given.place.source->hasLines()) {
    const bool isVector = given.as<Node::Array>() && findKey(path)->type == ValueType::kNumber;
    return isVector ? message + adviceFor(path, given, leaves) : message;
  }
  if (nameOf(path) == "shape")
    if (const std::string advice = shapeAdvice(path, given, leaves); !advice.empty())
      return fmt::format("{}: expected a shape (poinsot explain {} lists all), got {}{}", path, patternOf(path),
                         describe(given), advice);
  const bool hasAdvice =
      std::ranges::any_of(std::to_array<std::string_view>({"; did you mean \"", "; write [[", "; the nearest "}),
                          [&](std::string_view begin) { return message.find(begin) != std::string::npos; });
  if (hasAdvice) return message;
  const std::string advice = adviceOf(*findKey(path), path, given, leaves);
  return message + (advice.starts_with(" For") ? "." : "") + advice;
}

}  // namespace poinsot::scene
