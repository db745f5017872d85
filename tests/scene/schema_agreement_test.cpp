// SPDX-License-Identifier: Apache-2.0
// An editor with the schema must mark exactly the values that the program refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "scene/keys/check.h"
#include "scene/keys/reference.h"
#include "scene/unit_names.h"
#include "scene_testing.h"
#include "schema_testing.h"

namespace poinsot::scene {
namespace {

using nlohmann::json;

bool hasType(const std::string& type, const json& value) {
  if (type == "string") return value.is_string();
  if (type == "number") return value.is_number();
  if (type == "integer") return value.is_number_integer();
  if (type == "boolean") return value.is_boolean();
  return type == "array" && value.is_array();
}

bool valid(const json& schema, const json& value);

bool anyValid(const json& schemas, const json& value) {
  return std::any_of(schemas.begin(), schemas.end(), [&](const json& s) { return valid(s, value); });
}

bool allValid(const json& schema, const json& values) {
  return std::all_of(values.begin(), values.end(), [&](const json& v) { return valid(schema, v); });
}

/// Evaluates one word of JSON Schema (draft 4), of those that schemaJson() uses; any other word fails the test.
bool satisfies(const std::string& word, const json& wanted, const json& value) {
  if (word == "description" || word == "default") return true;
  if (word == "type") return hasType(wanted, value);
  if (word == "anyOf") return anyValid(wanted, value);
  if (word == "enum") return std::find(wanted.begin(), wanted.end(), value) != wanted.end();
  if (word == "pattern") return std::regex_search(value.get<std::string>(), std::regex(wanted.get<std::string>()));
  if (word == "maxLength") return characterCount(value.get<std::string>()) <= wanted.get<std::size_t>();
  if (word == "minimum") return value >= wanted;
  if (word == "maximum") return value <= wanted;
  if (word == "multipleOf") return value.get<int>() % wanted.get<int>() == 0;
  if (word == "items") return allValid(wanted, value);
  if (word == "minItems") return value.size() >= wanted.get<std::size_t>();
  if (word == "maxItems") return value.size() <= wanted.get<std::size_t>();
  if (word == "uniqueItems") return std::set<json>(value.begin(), value.end()).size() == value.size();
  ADD_FAILURE() << "the evaluator does not know " << word;
  return false;
}

bool valid(const json& schema, const json& value) {
  if (schema.contains("type") && !hasType(schema["type"], value)) return false;
  for (const auto& [word, wanted] : schema.items())
    if (!satisfies(word, wanted, value)) return false;
  return true;
}

bool schemaAccepts(const std::string& path, const std::string& value) {
  static const json schema = json::parse(schemaJson());
  return valid(schemaAt(schema, path), json::parse(value));
}

bool programAccepts(const std::string& path, const std::string& value) {
  const Source source("test", "v = " + value);
  const Node document = parseDocument(source);
  Problems problems;
  return check(*findKey(path), path, std::get<Node::Table>(document.value)[0].value, problems).has_value();
}

/// Sample values of a key, in a notation that is both JSON and TOML.
struct Samples {
  const char* path;
  std::vector<const char*> accepted, refused;
};

// A person derived these samples from docs/scene.md.
const Samples kSamples[] = {
    {"time.speed",
     {"1", "-0.5", "\"auto\"", "\"13 %\"", "\" -2e1% \""},
     {"\"fast\"", "\"13\"", "\"13 s\"", "true"}},
    {"camera.zoom", {"1.5", "\"150 %\""}, {"\"1.5\"", "\"1.5 m\"", "\"%\"", "0", "21", "[1]"}},
    {"time.duration",
     {"3", "0.5", "\"3 s\"", "\"3s\"", "\".5 min\"", "\"+1. h\"", "\"2e3 ms\"", "\"5 sec\"", "\"5 seconds\"",
      "\"7000 µs\""},
     {"\"3 kg\"", "\"3\"", "\"3 parsecs\"", "\"3,5 s\"", "\"s\"", "\"+-3 s\"", "\"3 s s\"", "\"inf s\"",
      "\"3 s;\""}},
    {"time.start", {"-20", "\"-2 d\"", "\"1 yr\""}, {"1e21", "-1e21", "\"1 S\""}},
    {"time.fps",
     {"30", "29.97", "\"30000/1001\"", "\"30\"", "\"29.97\"", "\"1000\"", "\"0.001\"", "\"0.05\"", "\"24/1\"",
      "\"030\""},
     {"0", "-30", "1000.5", "\"30/0\"", "\"0/1\"", "\"0\"", "\"3000\"", "\"0.0\"", "\"0.0009\"", "\"30/\"",
      "\"-30\"", "\"30 Hz\"", "\"30.\"", "\"1001\"", "\"1000.1\"", "\" 30\"", "true"}},
    {"motion.orientation",
     {"[1, 0, 0, 0]", "[0.5, -0.5, 0.5, 0.5]"},
     {"[\"100 %\", 0, 0, 0]", "[1, 0, 0]", "[1, 0, 0, 0, 0]", "1", "[true, 0, 0, 0]"}},
    {"motion.omega_body",
     {"[0, 1, -2.5]", "[\"3 rpm\", \"-60 deg/s\", \"0.5 Hz\"]",
      "[\"1 rev / d\", \"360 deg s^-1\", \"1 rad*s^-1\"]", "[\"3 degrees/sec\", \"1°/s\", 0]",
      "[\"3 RPM\", \"15 deg/hr\", \"2 dps\"]", "[\"1 kHz\", \"1 MHz\", \"1 gigahertz\"]",
      "[\"2 rad s-1\", \"2 rad s⁻¹\", \"2 rad-s**-1\"]", "[\"2 revolutions/min\", \"1 mdeg/s\", \"1 krpm\"]"},
     {"[0, 1]", "[\"3 deg\", 0, 0]", "[\"3 s/deg\", 0, 0]", "[\"3 rpm/s\", 0, 0]", "[\"3 degs\", 0, 0]",
      "[\"3 Rpm\", 0, 0]", "[\"3 mhz\", 0, 0]", "\"3 rpm\"", "[1e41, 0, 0]"}},
    {"body.principal_moments",
     {"[1, 2, 2.5]", "[\"1 kg m^2\", \"1.5 kg·m²\", \"2.5e4 g cm^2\"]",
      "[\"1 m^2 kg\", \"1.5 m*m*kg\", \"2 lb * ft^2\"]", "[\"1 slug ft^2\", \"1 slug-ft2\", \"1 lbm in^2\"]",
      "[\"1 lbf in s^2\", \"1 in-lbf-s**2\", \"1 lbf s^2 in\"]", "[\"1 kg-m^2\", \"1 kg.m^2\", \"1 kg*m**2\"]",
      "[\"1 kg·m**2\", \"1 kg×m²\", \"1 kg⋅m2\"]", "[\"1 gm cm^2\", \"1 gram centimetre^2\", \"1 Mg m^2\"]",
      "[\"1 u Å^2\", \"1 amu \u212b²\", \"1 Da angstroms^2\"]", "[\"1 N m s^2\", \"1 kgf m s²\", \"1 Nm s^2\"]"},
     {"[\"1 kg m22\", 1, 1]", "[\"1 kgm^2\", 1, 1]", "[\"1 kg m\", 1, 1]", "[\"1 kg m^3\", 1, 1]", "[-1, 1, 1]",
      "[\"1 MM^2 kg\", 1, 1]", "[\"1 lb in s^2\", 1, 1]", "[\"1 kg--m^2\", 1, 1]", "[\"1 kg m**22\", 1, 1]",
      "[0, 1, 1]", "[2e60, 1, 1]"}},
    {"body.mass", {"1", "\"320 g\"", "\"1t\""}, {"0", "\"3 m\"", "\"3 kg^2\"", "2e60"}},
    {"body.size",
     {"0.3", "\"20 cm\"", "[0.3, \"12 in\", 1]", "[1, \"2 m\"]"},
     {"[1]", "[1, 2, 3, 4]", "0", "\"20 cm^2\"", "\"20 Cm\""}},
    {"body.inertia",
     {"[[2, -0.5, 0], [-0.5, 3, 0], [0, 0, \"4 kg m^2\"]]"},
     {"[2, 3, 4]", "[[2, 0], [0, 3]]", "[[2, 0, 0], [0, 3, 0], [0, 0, true]]", "[[2, 0, 0], [0, 3, 0]]", "2"}},
    {"body.density",
     {"2700", "\"2.7 g/cm^3\"", "\"2.7 g cm^-3\"", "\"2700 kg / m³\""},
     {"0", "\"2.7 g/cm\"", "\"2.7 g\"", "\"2.7 cm^3/g\""}},
    {"body.part[].angle", {"0.5", "\"30 deg\""}, {"400", "30", "\"30 m\""}},
    {"motion.L_space",
     {"[0, 0, 2]", "[\"2 kg m^2/s\", \"2 N m s\", \"3 J s\"]", "[\"2 kg m^2 s^-1\", 0, 0]",
      "[\"2 Nms\", \"1 slug ft^2/s\", \"1 lbf ft s\"]"},
     {"2", "[0, 2]", "[\"2 J\", 0, 0]", "[\"2 kg m/s\", 0, 0]"}},
    {"motion.energy",
     {"4.5", "\"3 J\"", "\"2 mJ\"", "\"1 N m\"", "\"1 kg m^2/s^2\""},
     {"0", "-1", "\"3 W\"", "\"3 J s\""}},
    {"motion.torque.body",
     {"[1, -2, 0]", "[\"5 mN m\", \"1 N*cm\", \"2 J\"]", "[\"1 lbf-ft\", \"2 in lbf\", \"3 ozf in\"]",
      "[\"5 mNm\", \"1 Ncm\", \"2 kilonewton metres\"]"},
     {"[\"5 N\", 0, 0]", "5", "[\"1 N/m\", 0, 0]"}},
    {"motion.drag.rate",
     {"0.1", "[0.1, 0, \"2 1/min\"]", "\"2 /h\"", "\"2 yr^-1\""},
     {"-0.1", "[1, 2]", "\"2 s\"", "\"2 Hz\"", "\"2 1/m\""}},
    {"motion.dissipation.alpha",
     {"0", "0.02", "\"2 s/kg/m^2\"", "\"2 h / g / cm²\""},
     {"-1", "\"2 s\"", "\"2 kg/s/m^2\""}},
    {"motion.flight.velocity",
     {"[1, \"-10 km/h\", \"3 ft s^-1\"]", "[\"3 mph\", \"2 knots\", \"1 kph\"]"},
     {"[\"3 m\", 0, 0]", "3", "[\"3 s/m\", 0, 0]"}},
    {"motion.gravity.g",
     {"9.81", "0", "\"981 cm/s^2\"", "\"9.81 m s^-2\""},
     {"-9.81", "\"9.81 m/s\"", "\"9.81 N\""}},
    {"motion.spin_axis", {"\"1\"", "2", "\"middle\""}, {"4", "0", "\"x\"", "true"}},
    {"camera.azimuth",
     {"0.5", "\"-120 deg\"", "\"90°\"", "\"1 rev\""},
     {"\"3 rad/s\"", "\"90\"", "90", "\"90 Grad\""}},
    {"camera.frame", {"\"space\"", "\"body\"", "\"precession\""}, {"\"Space\"", "1", "[\"space\"]"}},
    {"camera.frames",
     {"[\"space\", \"body\"]", "[\"precession\"]"},
     {"[]", "\"space\"", "[\"space\", \"space\"]", "[\"Space\"]", "[1]", "[[\"space\"]]"}},
    {"camera.preset", {"\"front\"", "\"three_quarter\""}, {"\"Front\"", "1"}},
    {"camera.elevation", {"\"90 deg\"", "\"-90 deg\""}, {"1.6", "\"90 m\""}},
    {"view[].at", {"[0, 0]", "[7, 1]"}, {"[8, 0]", "[-1, 0]", "[1]", "[1, 0, 0]", "1", "[1.5, 0]", "[\"1\", 0]"}},
    {"view[].span", {"[1, 1]", "[8, 2]"}, {"[0, 1]", "[9, 1]", "2", "[true, 1]"}},
    {"view[].camera.frame", {"\"body\""}, {"\"Body\"", "2"}},
    {"view[].show.plane.opacity", {"0.5", "\"30 %\""}, {"2", "\"30 cm\""}},
    {"plot[].quantities",
     {"[\"omega_1\", \"omega_2\"]", "[\"t\"]"},
     {"[]", "\"omega_1\"", "[\"omega_1\", \"omega_1\"]", "[\"omega_4\"]", "[1]"}},
    {"plot[].x", {"\"theta\""}, {"\"Theta\"", "[\"theta\"]", "1"}},
    {"plot[].range", {"[-1, 2.5]", "[0, \"150 %\"]"}, {"[1]", "[1, 2, 3]", "1", "[\"1 s\", 2]", "[true, 1]"}},
    {"readout[].at", {"\"top left\"", "\"centre\""}, {"\"center\"", "\"left top\"", "1"}},
    {"note[].text",
     {"\"a\"", "\"two\\nlines\"", "[\"two\", \"lines\"]"},
     {"[]", "[\"one\", 2]", "1", "{}", "[[\"a\"]]"}},
    {"note[].size", {"1.5", "\"80 %\""}, {"0", "11", "\"1.5\""}},
    {"style.decimal_sign", {"\"comma\""}, {"\",\"", "1"}},
    {"show.title", {"\"\"", "\"a word\""}, {"1", "true"}},
    {"show.labels", {"true", "false"}, {"1", "\"yes\""}},
    {"output.size", {"[640, 360]"}, {"[641, 360]", "[640.0, 360]", "[640]", "[14, 16]", "\"640x360\""}},
    {"output.crf", {"0", "51"}, {"-1", "52", "18.5", "\"18\""}},
    {"output.colors", {"2", "255"}, {"1", "256", "63.5", "\"64\""}},
};

TEST(Schema, AcceptsWhatTheProgramAccepts) {
  for (const Samples& samples : kSamples)
    for (const char* value : samples.accepted) {
      EXPECT_TRUE(programAccepts(samples.path, value)) << samples.path << " = " << value;
      EXPECT_TRUE(schemaAccepts(samples.path, value)) << samples.path << " = " << value;
    }
}

TEST(Schema, RefusesWhatTheProgramRefuses) {
  for (const Samples& samples : kSamples)
    for (const char* value : samples.refused) {
      EXPECT_FALSE(programAccepts(samples.path, value)) << samples.path << " = " << value;
      EXPECT_FALSE(schemaAccepts(samples.path, value)) << samples.path << " = " << value;
    }
}

/// Expects, for each name of the table between `before` and `after`, a unit if and only if it has these exponents.
void expectEveryName(Dimension dimension, const Exponents& exponents, const std::string& before,
                     const std::string& after) {
  const std::regex pattern("^" + unitPattern(dimension) + "$");
  for (const NamedUnit& known : namedUnits()) {
    const std::string unit = before + known.name + after;
    const bool fits = known.unit.exponents == exponents;
    EXPECT_EQ(parseQuantity("1 " + unit, dimension).ok(), fits) << unit;
    EXPECT_EQ(std::regex_match(unit, pattern), fits) << unit;
  }
}

// Pattern and parser are derived from one table in two independent ways.
TEST(Schema, AgreesWithTheParserOnEveryNameOfAUnit) {
  expectEveryName(Dimension::kLength, kL, "", "");
  expectEveryName(Dimension::kMomentOfInertia, kM, "", "-m^2");
  expectEveryName(Dimension::kMomentOfInertia, kL, "kg.", "**2");
  expectEveryName(Dimension::kMomentOfInertia, kForce, "", " in s^2");
  expectEveryName(Dimension::kMomentOfInertia, kWork, "", "·s²");
  expectEveryName(Dimension::kAngularVelocity, kA, "", "/hr");
  expectEveryName(Dimension::kAngularVelocity, kSpin, "", "");
  expectEveryName(Dimension::kAngularVelocity, kT, "deg ", "-1");
  expectEveryName(Dimension::kTorque, kForce, "ft-", "");
  expectEveryName(Dimension::kEnergy, kWork, "", "");
  expectEveryName(Dimension::kVelocity, kSpeed, "", "");
  expectEveryName(Dimension::kAngularMomentum, kAction, "", "");
}

TEST(Schema, AgreesWithTheParserOnSignsAndPowersOfUnits) {
  const std::regex pattern("^" + unitPattern(Dimension::kMomentOfInertia) + "$");
  const char* signs[] = {" ", "*", "·", "⋅", "×", ".", "-", " * ", " - ", "", "--", "..", "**", "+", "_", ","};
  const char* powers[] = {"^2", "**2", "2", "²", "", "^^2", "***2", "^ 2", "²2", "22", "^-2", "-2", "⁻²"};
  for (const std::string sign : signs)
    for (const std::string power : powers) {
      const std::string unit = "kg" + sign + "m" + power;
      EXPECT_EQ(parseQuantity("1 " + unit, Dimension::kMomentOfInertia).ok(), std::regex_match(unit, pattern))
          << unit;
    }
}

TEST(Schema, AcceptsEveryDefaultAndExample) {
  for (const Key& key : keys()) {
    for (const std::string_view value : {std::string_view(key.example), std::string_view(key.fallback)}) {
      const bool literal = value.find('\'') != std::string_view::npos;  // TOML, but not JSON
      if (value.empty() || literal) continue;
      EXPECT_TRUE(schemaAccepts(std::string(key.path), std::string(value))) << key.path;
    }
  }
}

}  // namespace
}  // namespace poinsot::scene
