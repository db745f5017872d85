// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "core/number.h"
#include "core/text.h"
#include "scene/document/document.h"
#include "scene/keys/key_text.h"
#include "scene/keys/keys.h"
#include "scene/keys/reference.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

using Json = nlohmann::ordered_json;  // an ordered object, to keep the order of the table of keys

Json toJson(const Node& node) {
  if (const auto* flag = node.as<bool>()) return *flag;
  if (const auto* integer = node.as<std::int64_t>()) return *integer;
  if (const auto* number = node.as<double>()) return *number;
  if (const auto* text = node.as<std::string>()) return *text;
  Json array = Json::array();
  if (const auto* elements = node.as<Node::Array>())
    for (const Node& element : *elements) array.push_back(toJson(element));
  return array;
}

Json tomlToJson(std::string_view toml) {
  const Source source("table", fmt::format("v = {}", toml));
  const Node document = parseDocument(source);
  return toJson(std::get<Node::Table>(document.value).at(0).value);
}

// Rounds a bound to nine digits, because an editor shows it and 2.0943951023931953 rad is hard to read. A rounded
// bound can accept a value that is slightly out of range. The program rejects such a value later.
double readable(double value) {
  const std::string text = fmt::format("{:.9g}", value);
  double rounded = value;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

Json bound(double value, bool whole) {
  if (whole) return static_cast<std::int64_t>(value);
  return readable(value);
}

/// Returns the schema of a number without a unit, in SI units. A range with `ofSize` allows both signs and 0.
Json bareNumber(const Key& key, const char* type) {
  const double unit = unitFactor(key.range.unit, key.dimension);
  const bool whole = std::string_view(type) == "integer";
  Json json = {{"type", type}};
  const double least = key.range.ofSize ? -key.range.most : key.range.least;
  json["minimum"] = bound(least * unit, whole);
  json["maximum"] = bound(key.range.most * unit, whole);
  return json;
}

constexpr const char* kNumberPattern = R"([+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)";

// Pattern of a frame rate: a decimal from 0.001 to 1000, or a fraction without zeros. The pattern does not limit
// the value of the fraction or all numbers of digits. The program checks these later.
constexpr const char* kFrameRatePattern = R"(^(0*[1-9][0-9]{0,2}(\.[0-9]{1,9})?|0*1000(\.0{1,9})?|)"
                                          R"(0+\.([1-9][0-9]{0,8}|0[1-9][0-9]{0,7}|00[1-9][0-9]{0,6})|)"
                                          R"([0-9]*[1-9][0-9]*/[0-9]*[1-9][0-9]*)$)";

/// Returns the schema of text with a number and a unit. The pattern checks the form of the number and the
/// dimension of the unit. The program checks the range later.
Json quantity(const Key& key) {
  const std::string units = fmt::format("number and unit: {}", someUnits(key.dimension));
  return {{"type", "string"},
          {"description", units},
          {"pattern", fmt::format("^ *{} *{} *$", kNumberPattern, unitPattern(key.dimension))}};
}

/// Returns the schema of one of the key's words. A word that is a number may also be given without quotes.
Json words(const Key& key) {
  Json any = Json::array();
  for (const std::string_view word : key.words) any.push_back(std::string(word));
  for (const std::string_view word : key.words)
    if (const auto number = core::parseInteger<int>(word)) any.push_back(*number);
  return {{"enum", any}};
}

Json number(const Key& key) {
  Json any = Json::array({bareNumber(key, "number"), quantity(key)});
  if (!key.words.empty()) any.push_back(words(key));
  return {{"anyOf", any}};
}

/// Returns the schema of a number, or of a word that may be followed by a number.
Json moment(const Key& key) {
  const std::string numbered = fmt::format("^({}) +[1-9][0-9]{{0,8}} *$", core::joined(key.words, "|"));
  Json any = number(key)["anyOf"];
  any.push_back({{"type", "string"}, {"pattern", numbered}});
  return {{"anyOf", any}};
}

Json arrayOf(Json items, int least, int most) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", least}, {"maxItems", most}};
}

Json arrayOf(Json items, int count) { return arrayOf(std::move(items), count, count); }

/// Returns the schema of an array of numbers, or one number for all elements.
/// @param least  smallest number of elements; the largest is 3
Json perAxis(const Key& key, int least) {
  Json any = number(key)["anyOf"];
  any.push_back(arrayOf(number(key), least, 3));
  return {{"anyOf", any}};
}

Json frameRate(const Key& key) {
  const Json fraction = {{"type", "string"}, {"pattern", kFrameRatePattern}};
  return {{"anyOf", Json::array({bareNumber(key, "number"), fraction})}};
}

Json pixels(const Key& key) {
  Json side = bareNumber(key, "integer");
  side["multipleOf"] = 2;
  return arrayOf(side, 2);
}

Json someWords(const Key& key) {
  Json json = arrayOf(words(key), 1, static_cast<int>(key.words.size()));
  json["uniqueItems"] = true;
  return json;
}

Json line(const Key& key) { return {{"type", "string"}, {"maxLength", static_cast<int>(key.range.most)}}; }

/// Returns the schema of lines of text. For several lines in one string, the program checks their lengths later.
Json lines(const Key& key) {
  const Json text = {{"type", "string"}};
  return {{"anyOf", Json::array({text, arrayOf(line(key), 1, static_cast<int>(kMostLines))})}};
}

Json typeSchema(const Key& key) {
  switch (key.type) {
    case ValueType::kNumber:
      return number(key);
    case ValueType::kInteger:
      return bareNumber(key, "integer");
    case ValueType::kBool:
      return {{"type", "boolean"}};
    case ValueType::kColor:
      return {{"type", "string"}, {"pattern", "^#[0-9A-Fa-f]{6}$"}};
    case ValueType::kText:
      return line(key);
    case ValueType::kWord:
      return words(key);
    case ValueType::kVector:
      return arrayOf(number(key), 3);
    case ValueType::kPerAxis:
      return perAxis(key, 3);
    case ValueType::kExtents:
      return perAxis(key, 2);
    case ValueType::kMatrix:
      return arrayOf(arrayOf(number(key), 3), 3);
    case ValueType::kQuaternion:
      return arrayOf({{"type", "number"}}, 4);
    case ValueType::kFrameRate:
      return frameRate(key);
    case ValueType::kPixels:
      return pixels(key);
    case ValueType::kCell:
      return arrayOf(bareNumber(key, "integer"), 2);
    case ValueType::kWords:
      return someWords(key);
    case ValueType::kNumbers:
      return arrayOf(number(key), 1, static_cast<int>(kMostNumbers));
    case ValueType::kPair:
      return arrayOf(number(key), 2);
    case ValueType::kMoment:
      return moment(key);
    case ValueType::kLines:
      return lines(key);
  }
  return {};
}

Json keySchema(const Key& key) {
  const std::string range = rangeText(key);
  Json json = {{"description", std::string(key.help) + (range.empty() ? "" : " (" + range + ")")}};
  json.update(typeSchema(key));
  if (!key.fallback.empty()) json["default"] = tomlToJson(key.fallback);
  return json;
}

Json required(std::initializer_list<const char*> names) {
  return {{"required", std::vector<std::string>(names.begin(), names.end())}};
}

/// Adds required keys, and alternatives of which a scene must give exactly one, such as the ways to give a body.
void addRequired(Json& json, const std::string& table) {
  if (table.empty()) json["required"] = {"body", "motion"};
  if (table == "body")
    json["oneOf"] = {required({"principal_moments"}),
                     required({"inertia"}),
                     required({"shape"}),
                     required({"catalogue"}),
                     {{"anyOf", Json::array({required({"part"}), required({"point_mass"})})}}};
  if (table == "vector[]")
    json["oneOf"] = {required({"components"}), required({"position_of"}), required({"velocity_of"})};
  if (table == "angle[]") json["required"] = {"between"};
  if (table == "timeline[]") json["oneOf"] = {required({"at"}), required({"at_motion"}), required({"around"})};
  if (table == "plot[]") json["required"] = {"quantities"};
  if (table == "readout[]") json["required"] = {"quantity"};
  if (table == "note[]") json["anyOf"] = {required({"text"}), required({"matrix"})};
  if (table == "motion")
    json["oneOf"] = {required({"omega_body"}), required({"omega_space"}),       required({"L_body"}),
                     required({"L_space"}),    required({"spin", "spin_axis"}), required({"energy", "L"})};
}

Json tableSchema(const std::string& table);

Json tableArraySchema(const std::string& path) {
  return {{"type", "array"},
          {"description", fmt::format("Any number of [[{}]].", path)},
          {"items", tableSchema(path + "[]")},
          {"maxItems", rowOf(Limit::kElements).usual}};
}

Json schemaOf(const std::string& path) {
  if (const Key* key = findKey(path)) return keySchema(*key);
  return isTableArray(path) ? tableArraySchema(path) : tableSchema(path);
}

Json tableSchema(const std::string& table) {
  Json properties;
  for (const std::string& name : namesBelow(table)) properties[name] = schemaOf(pathBelow(table, name));
  Json json = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  addRequired(json, table);
  if (!hasVisible(table)) return json;
  const Json& visible = properties["visible"];
  return {{"description", visible["description"]}, {"anyOf", Json::array({json, {{"type", "boolean"}}})}};
}

}  // namespace

std::string schemaJson() {
  Json json = {{"$schema", "http://json-schema.org/draft-04/schema#"}, {"title", "poinsot scene"}};
  json.update(tableSchema(""));
  return json.dump(2) + "\n";
}

}  // namespace poinsot::scene
