// SPDX-License-Identifier: Apache-2.0
// The table of keys, the parser, the schema and the reference must agree.
#include "scene/keys/keys.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "key_contexts.h"
#include "scene/keys/check.h"
#include "scene/keys/reference.h"
#include "scene_testing.h"
#include "schema_testing.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Scene path beside the files that the examples name.
const std::string kFileName = dataPath("test.toml");

std::string messagesWith(const Key& key, std::string_view value) {
  return messagesOf(sceneFor(key), {pathIn(key) + "=" + std::string(value)}, kFileName);
}

TEST(EveryKey, HasAnExampleAndADefaultThatPassItsChecks) {
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    EXPECT_FALSE(key.example.empty());
    EXPECT_EQ(messagesWith(key, key.example), "") << sceneFor(key);
    if (!key.fallback.empty()) {
      EXPECT_EQ(messagesWith(key, key.fallback), "");
    }
  }
}

/// Text that names neither a file nor a unit is typeset and is checked before anything is drawn.
TEST(Keys, TextKeysAreTexExceptFileAndUnit) {
  for (const Key& key : keys()) {
    if (key.type != ValueType::kText && key.type != ValueType::kLines) continue;
    EXPECT_NE(key.isTex, nameOf(key.path) == "file" || nameOf(key.path) == "unit") << key.path;
  }
}

TEST(EveryKey, HasHelpOfOneLine) {
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    EXPECT_FALSE(key.help.empty());
    EXPECT_EQ(key.help.find('\n'), std::string_view::npos);
    EXPECT_TRUE(key.help.ends_with('.'));
  }
}

TEST(EveryKey, RefusesWrongTypes) {
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    const bool flag = key.type == ValueType::kBool;
    const std::string prefix = pathIn(key) + ": expected";
    for (const char* value : {"1979-05-27", "[[1]]", "{a = 1}", flag ? "3" : "true", "[true, true, true]"})
      EXPECT_THAT(messagesWith(key, value), StartsWith(prefix)) << value;
    EXPECT_NE(messagesWith(key, "[]"), "");
    if (key.type != ValueType::kText && key.type != ValueType::kLines) {
      EXPECT_NE(messagesWith(key, "\"no such word\""), "");
    }
  }
}

/// Returns `value` in the form that the key takes, alone or within an array.
std::string shaped(const Key& key, const std::string& value) {
  switch (key.type) {
    case ValueType::kVector:
      return "[" + value + "," + value + "," + value + "]";
    case ValueType::kMatrix:
      return "[[" + value + ", 0, 0], [0, 1, 0], [0, 0, 1]]";
    case ValueType::kQuaternion:
      return "[" + value + ", 0, 0, 0]";
    case ValueType::kPixels:
      return "[" + value + ", 16]";
    case ValueType::kCell:
    case ValueType::kPair:
      return "[" + value + ", 1]";
    case ValueType::kNumbers:
      return "[" + value + "]";
    default:
      return value;
  }
}

bool numeric(const Key& key) {
  return key.type != ValueType::kBool && key.type != ValueType::kText && key.type != ValueType::kWord &&
         key.type != ValueType::kWords && key.type != ValueType::kLines && key.type != ValueType::kColor;
}

bool isWhole(const Key& key) {
  return key.type == ValueType::kInteger || key.type == ValueType::kPixels || key.type == ValueType::kCell;
}

std::string number(const Key& key, double value) {
  const bool whole = isWhole(key);
  std::string text = whole ? std::to_string(std::llround(value)) : nlohmann::json(value).dump();
  return key.range.unit.empty() ? text : "\"" + text + " " + std::string(key.range.unit) + "\"";
}

// Values lie beyond an end by a tenth of a percent, by 1 for whole numbers, or by 2 for pixels.
TEST(EveryKey, RejectsValuesBeyondItsRange) {
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    if (!numeric(key)) continue;
    const double step = key.type == ValueType::kPixels ? 2 : 1;
    const bool whole = isWhole(key);
    const auto beyond = [&](double end, double sign) {
      return whole ? end + sign * step : end + sign * (end == 0 ? 1e-3 : std::abs(end) * 1e-3);
    };
    const std::string prefix = pathIn(key) + ": ";
    for (const double value : {beyond(key.range.most, 1), beyond(key.range.least, -1)})
      EXPECT_THAT(messagesWith(key, shaped(key, number(key, value))), StartsWith(prefix)) << value;
  }
}

TEST(EveryKey, AcceptsTheEndsOfItsRange) {
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    if (!numeric(key)) continue;
    // Only the key's own check runs, because ends of two keys may conflict (an hour of film at 1000 frames a
    // second).
    for (const double value : {key.range.least, key.range.most}) {
      const Source source("test", "v = " + shaped(key, number(key, value)));
      const Node document = parseDocument(source);
      Problems problems;
      EXPECT_TRUE(check(key, key.path, std::get<Node::Table>(document.value)[0].value, problems)) << value;
    }
  }
}

TEST(EveryKey, RejectsValuesThatAreNotFinite) {
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    if (!numeric(key)) continue;
    for (const char* value : {"nan", "inf", "-inf"})
      EXPECT_THAT(messagesWith(key, shaped(key, value)), HasSubstr(pathIn(key) + ": "));
  }
}

TEST(EveryKey, IsInTheSchemaWithHelpDefaultAndAllowedWords) {
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    const nlohmann::json schema = nlohmann::json::parse(schemaJson());
    const nlohmann::json& entry = schemaAt(schema, key.path);
    EXPECT_THAT(entry.at("description").get<std::string>(), StartsWith(std::string(key.help)));
    EXPECT_EQ(entry.contains("default"), !key.fallback.empty());
    for (const std::string_view word : key.words)
      EXPECT_THAT(entry.dump(), HasSubstr("\"" + std::string(word) + "\""));
  }
}

std::string inCell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string headingOf(std::string_view table) {
  if (table.empty()) return "## At the top\n";
  const bool array = table.ends_with("[]");
  const std::string name(table.substr(0, table.size() - (array ? 2 : 0)));
  return array ? "## `[[" + name + "]]`\n" : "## `[" + name + "]`\n";
}

/// Returns whether a view repeats a key of [camera] or [show]; the reference lists such keys once.
bool isRepeatedInViews(const Key& key) { return key.path.starts_with("view[].") && tableOf(key.path) != "view[]"; }

TEST(EveryKey, IsInTheReference) {
  for (const Key& key : keys()) {
    SCOPED_TRACE(key.path);
    if (isRepeatedInViews(key)) continue;
    const std::string reference = referenceMarkdown();
    const std::string heading = headingOf(tableOf(key.path));
    const std::size_t section = reference.find(heading);
    ASSERT_NE(section, std::string::npos);
    const std::size_t row = reference.find("\n| `" + std::string(nameOf(key.path)) + "` |", section);
    ASSERT_NE(row, std::string::npos);
    EXPECT_LT(row, reference.find("\n## ", section + 1));
    EXPECT_THAT(reference.substr(row + 1, reference.find('\n', row + 1) - row), HasSubstr(inCell(key.help)));
  }
}

TEST(Keys, HaveUniquePaths) {
  std::set<std::string_view> paths;
  for (const Key& key : keys()) EXPECT_TRUE(paths.insert(key.path).second) << key.path;
}

TEST(Keys, AreFoundByPath) {
  EXPECT_EQ(findKey("camera.fov")->path, "camera.fov");
  EXPECT_EQ(findKey("camera"), nullptr);
  EXPECT_TRUE(isTable("show") && isTable("show.plane"));
  EXPECT_FALSE(isTable("show.pla") || isTable("camera.fov"));
  EXPECT_THAT(namesBelow("show.plane"), testing::ElementsAre("visible", "opacity", "grid"));
  EXPECT_THAT(namesBelow(""),
              testing::ElementsAre("schema", "body", "motion", "time", "camera", "show", "mark", "view", "label", "vector",
                                   "angle", "plot", "readout", "note", "timeline", "style", "output"));
  EXPECT_EQ(findKey("body.part[12].mass")->path, "body.part[].mass");
  EXPECT_EQ(findKey("body.part.mass"), nullptr);
  EXPECT_EQ(findKey("body.part[x].mass"), nullptr);
  EXPECT_TRUE(isTable("body.part[3]") && isTableArray("body.part"));
  EXPECT_FALSE(isTable("body.part") || isTableArray("body") || isTableArray("body.mass"));
  EXPECT_THAT(namesBelow("body.point_mass[1]"), testing::ElementsAre("mass", "position"));
  EXPECT_EQ(elementOf("body.part[12].mass"), 12u);
  EXPECT_EQ(elementOf("body.mass"), 0u);
  EXPECT_EQ(tableOf("body.part[].mass"), "body.part[]");
  EXPECT_EQ(tableOf("show.plane.grid"), "show.plane");
  EXPECT_EQ(nameOf("show.plane.grid"), "grid");
}

TEST(Keys, TablesThatCanBeHiddenAcceptTrue) {
  for (const Key& key : keys()) {
    if (nameOf(key.path) != "visible") continue;
    EXPECT_EQ(messagesOf(sceneFor(key), {std::string(tableOf(pathIn(key))) + "=true"}), "") << key.path;
  }
}

}  // namespace
}  // namespace poinsot::scene
