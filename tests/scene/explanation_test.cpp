// SPDX-License-Identifier: Apache-2.0
// Explanations of names must agree with the table of keys. Each key of the table is looked up.
#include "scene/keys/explanation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "scene/keys/keys.h"
#include "scene/shapes.h"

namespace poinsot::scene {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using Row = Explanation::Row;

std::string rowOf(const Explanation& explanation, const std::string& name) {
  const auto row = std::ranges::find(explanation.rows, name, &Row::name);
  return row == explanation.rows.end() ? "no row " + name : row->text;
}

TEST(Explanation, FindsATableByTheLastPartOfItsPath) {
  for (const char* name : {"cones", "trace", "theta", "plane", "torque", "colors", "part"}) {
    const auto found = explain(name);
    EXPECT_TRUE(std::ranges::any_of(found,
                                    [&](const Explanation& one) {
                                      return one.title.find(std::string(".") + name + "]") != std::string::npos;
                                    }))
        << name << ": " << found.front().title;
  }
}

TEST(Explain, FindsEveryKeyByItsPath) {
  for (const Key& key : keys()) {
    const auto found = explain(key.path);
    ASSERT_EQ(found.size(), 1u) << key.path;
    EXPECT_EQ(found[0].title, key.path);
    EXPECT_EQ(found[0].help, key.help);
    EXPECT_EQ(rowOf(found[0], "default"), key.fallback.empty() ? "none" : key.fallback) << key.path;
    EXPECT_THAT(rowOf(found[0], "example"),
                HasSubstr(std::string(nameOf(key.path)) + " = " + std::string(key.example)));
    EXPECT_EQ(rowOf(found[0], "takes").find("]("), std::string::npos) << "a link: " << rowOf(found[0], "takes");
  }
}

TEST(Explain, FindsEveryKeyByItsName) {
  for (const Key& key : keys()) {
    if (repeatsInView(key)) continue;
    EXPECT_THAT(explain(nameOf(key.path)), Contains(Field(&Explanation::title, key.path))) << key.path;
  }
}

TEST(Explain, ListsEveryKeyInItsTable) {
  for (const Key& key : keys()) {
    if (repeatsInView(key) || tableOf(key.path).empty()) continue;
    const auto found = explain(tableOf(key.path));
    EXPECT_EQ(rowOf(found[0], std::string(nameOf(key.path))), key.help) << key.path;
  }
}

TEST(Explain, ListsUnitsAndRanges) {
  const auto fov = explain("camera.fov").front();
  EXPECT_THAT(rowOf(fov, "takes"), HasSubstr("an angle, from "));
  EXPECT_THAT(rowOf(fov, "units"), HasSubstr("deg"));
  EXPECT_THAT(rowOf(fov, "units"), HasSubstr("a bare number is in rad"));
  EXPECT_EQ(rowOf(explain("show.title").front(), "units"), "no row units");
  EXPECT_EQ(explain("body.part.density").at(0).title, "body.part[].density");
  EXPECT_EQ(explain("body.part.color").at(0).title, "[style.colors]");
  EXPECT_EQ(explain("rpm").at(0).help, "1 rpm is 0.10471975511966 rad/s.");
  EXPECT_EQ(rowOf(explain("units").at(0), "lengths").substr(0, 5), "m: m,");
}

// Every unit of the table has its value, even forces, which no key takes.
TEST(Explain, ListsEveryUnitOfTheTable) {
  const auto found = explain("units");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1].title, "names of units");
  for (const UnitText& unit : unitTexts()) EXPECT_THAT(rowOf(found[1], unit.symbol), HasSubstr(unit.value));
  EXPECT_EQ(rowOf(found[1], "g"), "0.001 kg; with a prefix Mg, kg, mg, ug; also gm, gram");
  EXPECT_EQ(rowOf(found[1], "lbf"), "4.4482216152605 N");
  EXPECT_EQ(explain("lbf").at(0).help, "1 lbf is 4.4482216152605 N.");
  EXPECT_THAT(rowOf(explain("body.inertia").front(), "units"), HasSubstr("(poinsot explain units lists all)"));
}

TEST(Explain, ShowsLayoutAndSignOfInertia) {
  const auto inertia = explain("body.inertia").front();
  EXPECT_THAT(rowOf(inertia, "takes"), HasSubstr("[[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]"));
  EXPECT_THAT(inertia.help, HasSubstr("-(sum of m x y)"));
  EXPECT_THAT(inertia.help, HasSubstr("Aerospace tables and many CAD sheets print +(sum of m x y)"));
}

TEST(Explain, FindsTablesAsWrittenInScenes) {
  EXPECT_EQ(explain("[camera]").front().title, "[camera]");
  for (const char* word : {"body.part", "[[body.part]]", "body.part[]", "body.part[3]"})
    EXPECT_EQ(explain(word).front().title, "[[body.part]]") << word;
  EXPECT_EQ(explain("body.part[3].mass").front().title, "body.part[].mass");
  EXPECT_EQ(explain("").front().title, "tables");
}

TEST(Explain, FindsShapesBodiesAndQuantities) {
  EXPECT_EQ(explain("racket").size(), 2u) << "the shape and the body of the catalogue";
  EXPECT_THAT(explain("torus").front().title, HasSubstr("shape"));
  EXPECT_THAT(explain("omega_1").back().title, HasSubstr("quantity"));
}

TEST(Explain, RejectsUnknownNamesAndSuggestsTheNearest) {
  const auto refusal = [](const std::string& word) -> std::string {
    try {
      explain(word);
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
      return error.message();
    }
    return "none";
  };
  EXPECT_EQ(refusal("camera.fovv"),
            "camera.fovv: no key, table, shape or quantity of a scene has this name; did you mean camera.fov?");
  for (const auto& [word, key] : {std::pair{"show.V", "show.flight.velocity"}, std::pair{"stand", "body.pivot"},
                                  std::pair{"path", "show.trace.visible"}})
    EXPECT_THAT(refusal(word), testing::EndsWith(std::string("did you mean ") + key + "?"));
  EXPECT_EQ(explain("support").back().title, "body.pivot");
  EXPECT_EQ(refusal("\x1b[2J"), "\\x1b[2J: no key, table, shape or quantity of a scene has this name");
  EXPECT_THAT(refusal(std::string(5000, 'x')), HasSubstr("has this name"));
  for (const char* word : {"[", "]", "[]", "[[]]", ".", "..", "body.part[", "body.part[]]"})
    EXPECT_THAT(refusal(word), HasSubstr("has this name"));
}

// A user may know a value but not its key.
TEST(Explain, NamesTheKeyThatAcceptsAValue) {
  const auto found = explain("dark");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].title, "\"dark\", a value of style.theme");
  EXPECT_EQ(found[0].help, findKey("style.theme")->help);
}

TEST(Explain, DescribesTheTableOfEachFigure) {
  EXPECT_EQ(rowOf(explain("show").at(0), "[show.plane]"), findKey("show.plane.visible")->help);
}

}  // namespace
}  // namespace poinsot::scene
