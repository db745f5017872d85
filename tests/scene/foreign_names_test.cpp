// SPDX-License-Identifier: Apache-2.0
// Names of textbooks and of other programs in a scene. A test pastes the example of each message and loads the
// result.
#include "scene/keys/foreign_names.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <vector>

#include "pasting.h"
#include "scene/keys/keys.h"
#include "scene/shapes.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using Lines = std::vector<std::string>;

const std::string kMoments = "[body]\nprincipal_moments = [1.0, 2.0, 2.5]\n";
const std::string kStart = "[motion]\nomega_body = [0.01, 3.0, 0.0]\n";

/// Returns the scene that results from the first message; "" if this message has no example.
std::string pasted(const std::string& text, const Problem& problem) {
  return problem.message.find(" For example") == std::string::npos ? "" : mended(text, {problem});
}

/// Values that a user may give for each key, one for each name of a list.
const std::map<std::string_view, Lines>& values() {
  static const std::map<std::string_view, Lines> all = {
      {"body.principal_moments", {"1", "2", "2.5"}},
      {"body.inertia", {"2", "0.1", "0", "3", "0", "4"}},
      {"body.mass", {"2"}},
      {"body.density", {"500"}},
      {"body.radius", {"0.1"}},
      {"body.size", {"0.3", "0.2", "0.1"}},
      {"body.edge", {"0.1"}},
      {"body.inner_radius", {"0.05"}},
      {"body.wall", {"0.01"}},
      {"body.part[].offset", {"0", "0", "0.1"}},
      {"body.part[].rotation", {"1", "0", "0", "1"}},
      {"body.point_mass[].position", {"0", "0", "0.1"}},
      {"body.point_mass[].mass", {"[1, 2, 1]", "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]"}},
      {"body.height", {"0.3"}},
      {"body.shape", {"\"cylinder\""}},
      {"body.catalogue", {"\"phone\""}},
      {"body.pivot", {"0", "0", "-0.05"}},
      {"body.centre_of_mass", {"0", "0", "0.01"}},
      {"motion.omega_body", {"0", "0.5", "3"}},
      {"motion.omega_space", {"0", "0.5", "3"}},
      {"motion.spin", {"3"}},
      {"motion.spin_axis", {"\"3\""}},
      {"motion.tilt", {"0.1"}},
      {"motion.precession", {"true"}},
      {"motion.energy", {"4.5"}},
      {"motion.L", {"4.2"}},
      {"motion.P_phi", {"\"60 h\""}},
      {"motion.L_body", {"0", "0.5", "2"}},
      {"motion.L_space", {"0", "0.5", "2"}},
      {"motion.euler.precession", {"0.5"}},
      {"motion.euler.nutation", {"0.3"}},
      {"motion.euler.spin", {"0.2"}},
      {"motion.euler_rates.precession", {"0.5"}},
      {"motion.euler_rates.nutation", {"0.3"}},
      {"motion.euler_rates.spin", {"0.2"}},
      {"motion.lean", {"0.4"}},
      {"motion.roll_pitch_yaw", {"0.1", "0.2", "0.3"}},
      {"motion.orientation", {"0.5", "0.5", "0.5", "0.5"}},
      {"motion.tolerance", {"\"rk4\""}},
      {"motion.torque.body", {"0", "0", "0.1"}},
      {"motion.torque.space", {"0", "0", "0.1"}},
      {"motion.gravity.g", {"9.81"}},
      {"motion.gravity.mgr_body", {"0", "0", "0.4"}},
      {"motion.drag.rate", {"0.01"}},
      {"motion.dissipation.alpha", {"0.02"}},
      {"motion.flight.velocity", {"1", "0", "4"}},
      {"motion.flight.gravity", {"0", "0", "-1.62"}},
      {"motion.flight.position", {"0", "0", "1.5"}},
      {"time.duration", {"5"}},
      {"time.fps", {"25"}},
      {"time.start", {"1"}},
      {"time.speed", {"0.5"}},
      {"output.size", {"640", "480"}},
      {"output.crf", {"5000"}},
      {"output.codec", {"\"hevc\""}},
      {"camera.azimuth", {"3", "4", "5"}},
      {"camera.elevation", {"20"}},
      {"camera.fov", {"0.5"}},
      {"camera.preset", {"\"front\""}},
      {"camera.zoom", {"10"}},
      {"camera.orbit", {"0", "360"}},
      {"camera.frame", {"true"}},
      {"camera.follow", {"true"}},
      {"camera.projection", {"\"orthographic\""}},
      {"output.quality", {"\"4k\""}},
      {"style.line_width", {"2"}},
      {"style.colors.omega", {"\"red\""}},
      {"style.colors.L", {"\"red\""}},
      {"style.colors.ink", {"\"black\""}},
      {"show.ellipsoid.opacity", {"0.5"}},
      {"show.space_axes.visible", {"true"}},
      {"show.cones.visible", {"false"}},
      {"show.ghosts.visible", {"true"}},
      {"plot[].quantities", {"\"omega_1\""}},
      {"plot[].range", {"-1", "1"}},
      {"readout[].quantity", {"\"t\""}},
      {"note[].text", {"\"A note\""}},
      {"timeline[].at", {"1"}},
      {"timeline[].caption", {"\"A caption\""}},
      {"vector[].components", {"0", "0", "1"}},
      {"vector[].name", {"\"v\""}},
      {"vector[].color", {"\"vector\""}},
      {"style.colors.paper", {"\"white\""}},
      {"style.colors.body", {"\"#336699\""}},
      {"style.text_size", {"12"}},
      {"style.theme", {"\"dark\""}},
      {"show.title", {"\"A top\""}},
      {"show.L.visible", {"true"}},
      {"show.omega.visible", {"true"}},
      {"show.principal_axes.visible", {"true"}},
      {"show.ellipsoid.visible", {"true"}},
      {"show.plane.visible", {"true"}},
      {"show.flight.velocity", {"true"}},
      {"show.flight.position", {"true"}},
      {"show.flight.weight", {"true"}},
      {"show.trace.visible", {"true"}},
  };
  return all;
}

std::string arrayOf(const Lines& elements) {
  std::string text;
  for (const std::string& element : elements) text += (text.empty() ? "[" : ", ") + element;
  return text + "]";
}

std::string valueFor(std::string_view key) {
  if (key == "body.inertia") return "[[2, 0.1, 0], [0.1, 3, 0], [0, 0, 4]]";
  const Lines& elements = values().at(key);
  return elements.size() == 1 && findKey(key)->type != ValueType::kVector ? elements[0] : arrayOf(elements);
}

/// Returns a value for each name of a row, as other programs write it.
Lines valuesFor(const ForeignNames& row) {
  if (row.carry == Carry::kSymmetric) return {"2", "1"};
  if (row.carry == Carry::kEllipticity) return {"\"1/305\""};
  if (row.carry == Carry::kLaunch) return {"6", "\"60 deg\""};
  if (row.carry == Carry::kDirected) return {"3", "[0, 0, 1]"};
  if (row.carry == Carry::kReversed) return {"[0.1, 0.2, 0.3]"};
  if (row.carry == Carry::kEuler) return {"[0.1, 0.2, 0.3]"};
  if (row.carry == Carry::kEither) return {"false", "false"};
  if (row.carry == Carry::kSpan) return {"[0, 5]"};
  if (row.carry == Carry::kShown) return {"[\"L\"]"};
  if (row.carry == Carry::kList || row.carry == Carry::kTensor || row.carry == Carry::kPoints)
    return values().at(row.key);
  return {valueFor(row.key)};
}

/// Returns the lines of a scene that give the names of a row.
std::string linesFor(const ForeignNames& row, std::string_view name) {
  const Lines values = valuesFor(row);
  if (values.size() == 1) return std::string(nameOf(name)) + " = " + values[0] + "\n";
  std::string lines;
  const auto names = namesIn(row);
  for (std::size_t i = 0; i < names.size(); ++i)
    lines += std::string(nameOf(names[i])) + " = " + values.at(i) + "\n";
  return lines;
}

/// Returns a scene that is complete except for the foreign lines, which are at the top or in a table.
std::string sceneWith(const std::string& table, const std::string& lines, std::string_view key) {
  const bool start = key.starts_with("motion.omega") || key.starts_with("motion.spin") ||
                     key.starts_with("motion.L") || key.starts_with("motion.euler_rates") ||
                     key == "motion.tilt" || key == "motion.energy" || key == "motion.P_phi";
  const bool moments = key == "body.mass" || key == "body.pivot" || key == "body.centre_of_mass";
  std::map<std::string, std::string> tables;
  if (!key.starts_with("body.") || moments) tables["body"] = "principal_moments = [1.0, 2.0, 2.5]\n";
  if (key == "motion.gravity.g")
    tables["body"] = "shape = \"box\"\nsize = [3, 2, 1]\nmass = 1\npivot = [0, 0, -1]\n";
  if (!start) tables["motion"] = "omega_body = [0.01, 3.0, 0.0]\n";
  std::string text = table.empty() ? lines : "";
  if (!table.empty()) tables[table] = lines + tables[table];
  for (const auto& [name, content] : tables) text += "[" + name + "]\n" + content;
  return text;
}

TEST(ForeignNames, HaveKeysAndExamples) {
  for (const ForeignNames& row : foreignNames()) {
    if (row.carry == Carry::kRemove) continue;
    ASSERT_NE(findKey(row.key), nullptr) << row.key;
    EXPECT_TRUE(values().contains(row.key)) << row.key;
  }
}

TEST(ForeignNames, LeadToLinesThatCanBePasted) {
  int checked = 0;
  for (const ForeignNames& row : foreignNames())
    for (const std::string_view name : namesIn(row))
      for (const std::string& table : {std::string(), std::string(row.key.substr(0, row.key.find('.')))}) {
        const std::string path = pathBelow(table, name);
        if (name.find('.') != std::string_view::npos || findKey(path) || isTable(path) || isTableArray(path) ||
            row.own || row.key.empty() || row.key.find('[') != std::string_view::npos ||
            row.key == "motion.precession")
          continue;
        if (path == "name" && row.key.starts_with("body.")) continue;  // outside [body], a name is a title
        const std::string text = sceneWith(table, linesFor(row, name), row.key);
        const auto problems = problemsOf(text);
        ASSERT_EQ(problems.size(), 1u) << text << messagesOf(text);
        const std::string scene = pasted(text, problems[0]);
        EXPECT_NE(scene, "") << path << ": " << problems[0].message;
        EXPECT_EQ(messagesOf(scene), "") << text << problems[0].message << "\n" << scene;
        ++checked;
      }
  EXPECT_GT(checked, 400);
}

TEST(ForeignNames, KeepTheGivenValue) {
  EXPECT_EQ(messagesOf(kMoments + "[motion]\nw = [0, 0, \"3 rpm\"]\n"),
            "motion.w: unknown key; did you mean motion.omega_body? Its components are along the body's axes; "
            "motion.omega_space takes those along the world's axes. For example:\n"
            "    omega_body = [0, 0, \"3 rpm\"]\n");
  EXPECT_EQ(messagesOf("[body]\nI1 = 1.5\nI2 = 2\nI3 = \"3 kg m^2\"\n" + kStart),
            "body.I1, I2, I3: unknown keys; did you mean body.principal_moments? For example:\n"
            "    principal_moments = [1.5, 2, \"3 kg m^2\"]\n");
  EXPECT_EQ(messagesOf("[body]\nIxx = 2\nIyy = 3\nIzz = 4\nIxy = 0.1\n" + kStart),
            "body.Ixx, Ixy, Iyy, Izz: unknown keys; did you mean body.inertia? For example:\n"
            "    inertia = [[2, 0.1, 0], [0.1, 3, 0], [0, 0, 4]]\n");
  EXPECT_THAT(messagesOf("t_end = 5\n" + kMoments + kStart),
              EndsWith(" at the end of the file:\n    [time]\n    duration = 5\n"));
  EXPECT_THAT(messagesOf(kMoments + kStart + "[output]\nwidth = 640\nheight = 480\n"),
              EndsWith("For example:\n    size = [640, 480]\n"));
  EXPECT_THAT(messagesOf(kMoments + kStart + "[output]\nresolution = \"640x480\"\n"),
              EndsWith("For example:\n    size = [640, 480]\n"));
  // atan2(4, 3) is 53.13 deg, atan2(5, 5) is 45 deg
  EXPECT_THAT(messagesOf("camera_position = [3, 4, 5]\n" + kMoments + kStart),
              EndsWith("    azimuth = \"53.13 deg\"\n    elevation = \"45 deg\"\n"));
}

TEST(ForeignNames, TakeTheFormOfTheKey) {
  EXPECT_THAT(messagesOf(kMoments + "[motion]\nangular_velocity = 3\n"), EndsWith("    omega_body = [0, 0, 3]\n"));
  EXPECT_THAT(messagesOf("[body]\nI = 3\n" + kStart), EndsWith("    principal_moments = [3, 3, 3]\n"));
  EXPECT_THAT(messagesOf(kMoments + kStart + "quat_xyzw = [1, 2, 3, 4]\n"),
              EndsWith("    orientation = [4, 1, 2, 3]\n"));
  EXPECT_THAT(messagesOf(kMoments + kStart + "gravity = [0, 0, -9.81]\n"),
              EndsWith("    flight.gravity = [0, 0, -9.81]\n"));
  EXPECT_THAT(messagesOf(kMoments + kStart + "M = [0, 0, 1]\n"), EndsWith("    torque.body = [0, 0, 1]\n"));
  EXPECT_THAT(messagesOf("background = \"white\"\n" + kMoments + kStart), EndsWith("    paper = \"#ffffff\"\n"));
  // A dot in quat_xyzw or a date does not fit; the example of the key replaces it.
  EXPECT_THAT(messagesOf(kMoments + "[motion]\nw = 2020-01-01\n"),
              EndsWith("    omega_body = [0.01, \"3 rpm\", 0]\n"));
}

TEST(ForeignNames, KeepTheUnitOfAName) {
  EXPECT_THAT(messagesOf(kMoments + kStart + "[body.x]\n", {}), HasSubstr("body.x"));
  EXPECT_THAT(messagesOf(kMoments + "mass_kg = 2\n" + kStart), EndsWith("    mass = 2\n"));
  EXPECT_THAT(messagesOf(kMoments + "mass_g = 200\n" + kStart), EndsWith("    mass = \"200 g\"\n"));
  EXPECT_THAT(messagesOf(kMoments + "[motion]\nomega_rpm = [0, 0, 30]\n"),
              EndsWith("    omega_body = [\"0 rpm\", \"0 rpm\", \"30 rpm\"]\n"));
  EXPECT_THAT(messagesOf(kMoments + "[motion]\nomega_deg_s = [0, 0, 90]\n"),
              EndsWith("    omega_body = [\"0 deg/s\", \"0 deg/s\", \"90 deg/s\"]\n"));
  EXPECT_THAT(messagesOf("[body]\nshape = \"cube\"\nedge = 1\ndensity_kg_m3 = 500\n" + kStart),
              EndsWith("unknown key; did you mean body.density? For example:\n    density = 500\n"));
}

TEST(ForeignNames, BringTheOtherKeysOfAShapeOnce) {
  EXPECT_EQ(
      messagesOf("[body]\nr = 0.1\nm = 2\n" + kStart),
      "body.r: unknown key; did you mean body.radius? For example:\n    shape = \"sphere\"\n    radius = 0.1\n"
      "body.m: unknown key; did you mean body.mass? For example:\n    mass = 2\n");
  EXPECT_THAT(messagesOf("[body]\ntype = \"cuboid\"\ndimensions = [0.3, 0.2, 0.1]\nm = 2\n" + kStart),
              HasSubstr("body.shape? For example:\n    shape = \"box\"\n"));
}

TEST(ForeignNames, BringTheKeysOfEachShape) {
  for (const std::string_view word : shapeWords()) {
    if (word == "rod" || word == "mesh")
      continue;  // a rod alone has no moment about its line; a mesh needs a file
    const std::string text = "[body]\ntype = \"" + std::string(word) + "\"\n" + kStart;
    EXPECT_EQ(messagesOf(pasted(text, problemsOf(text).at(0))), "") << word;
  }
  for (const char* name : {"box", "cylinder", "cuboid", "Sphere"}) {
    const std::string text = kStart + "[body]\n" + name + " = 1\n";
    EXPECT_EQ(messagesOf(pasted(text, problemsOf(text).at(0))), "") << name;
  }
}

TEST(ForeignNames, LeadAnglesToEulerAnglesWithTheirValues) {
  const std::string text = kMoments + kStart + "theta = \"20 deg\"\nphi = 0.1\nrpy = [0.1, 0.2, 0.3]\n";
  EXPECT_EQ(
      messagesOf(text),
      "motion.theta: unknown key; did you mean motion.euler.nutation? The Euler angles follow the order z, x, "
      "z, where the z axis of the body leans by the nutation. For example:\n    euler.nutation = \"20 "
      "deg\"\n"
      "motion.phi: unknown key; did you mean motion.euler.precession? The Euler angles follow the order z, x, "
      "z, where the z axis of the body leans by the nutation. For example:\n    euler.precession = 0.1\n"
      "motion.rpy: unknown key; did you mean motion.roll_pitch_yaw? For example:\n    roll_pitch_yaw = [0.1, "
      "0.2, 0.3]\n");
}

TEST(ForeignNames, AreFoundInTablesOfOtherPrograms) {
  EXPECT_EQ(messagesOf(kMoments + "[initial_conditions]\nomega0 = [0, 0, 2]\n"),
            "initial_conditions.omega0: unknown key; did you mean motion.omega_body? Its components are along the "
            "body's axes; motion.omega_space takes those along the world's axes. For example, at the end of the "
            "file:\n    [motion]\n    omega_body = [0, 0, 2]\n");
  EXPECT_THAT(messagesOf(kMoments + kStart + "[simulation]\nt_end = 20\n"),
              EndsWith("    [time]\n    duration = 20\n"));
}

TEST(ForeignNames, ChangeValuesByTheirFactor) {
  const std::string disc = "[body]\nshape = \"disc\"\nmass = 2\n";
  EXPECT_THAT(messagesOf(disc + "diameter = \"30 cm\"\n" + kStart), EndsWith("    radius = \"15 cm\"\n"));
  EXPECT_THAT(messagesOf(disc + "diameter_cm = 30\n" + kStart), EndsWith("    radius = \"15 cm\"\n"));
  EXPECT_THAT(messagesOf("[body]\nshape = \"ellipsoid\"\nmass = 5\nsemiaxes = [3, 2, 1]\n" + kStart),
              EndsWith("    size = [6, 4, 2]\n"));
  EXPECT_THAT(messagesOf("[body]\nprincipal_moments = [1, 1, 2]\nmass = 1\nl = 0.04\n" + kStart),
              EndsWith("    pivot = [0, 0, -0.04]\n"));
}

TEST(ForeignNames, IncludeKeysOfOtherTables) {
  for (const char* line :
       {"color = \"red\"", "colour = \"#ff0000\"", "fps = 25", "duration = 5", "azimuth = 0.5", "theme = \"dark\"",
        "codec = \"hevc\"", "tolerance = 1e-9", "initial_orientation = [1, 0, 0, 0]", "angularDamping = 0.1"})
    for (const std::string& text :
         {line + ("\n" + kMoments) + kStart, kMoments + line + "\n" + kStart, kMoments + kStart + line + "\n"}) {
      if (messagesOf(text).empty()) continue;                               // the key's own table
      if (messagesOf(text).find("[style.colors]?") != text.npos) continue;  // a motion has no colour
      EXPECT_EQ(messagesOf(pasted(text, problemsOf(text).at(0))), "") << text << messagesOf(text);
    }
  EXPECT_THAT(messagesOf(kMoments + "color = \"red\"\n" + kStart),
              EndsWith("at the end of the file:\n    [style.colors]\n    body = \"#ff0000\"\n"));
}

TEST(ForeignNames, SuitTheFormOfTheTable) {
  const std::string gravity =
      "shape = \"box\"\nsize = [3, 2, 1]\nmass = 1\npivot = [0, 0, -1]\n[motion.gravity]\ng = 9.81\n";
  for (const std::string& text :
       {"w = [0, 0, 3]\n[body]\n" + gravity, "w = [0, 0, 3]\nmotion.L_points = \"up\"\n" + kMoments,
        "w = [0, 0, 3]\nq = [1, 0, 0, 0]\n" + kMoments,
        "w = [0, 0, 3]\n" + kMoments + "[motion]\nL_points = \"up\"\n"}) {
    const std::string scene = mended(text, problemsOf(text));
    EXPECT_EQ(messagesOf(scene), "") << text << messagesOf(text) << scene;
  }
}

TEST(ForeignNames, StayInTheirTables) {
  EXPECT_THAT(messagesOf("[[body.part]]\nshape = \"cube\"\nedge = 1\nm = 2\n" + kStart),
              EndsWith("did you mean body.part[0].mass? For example:\n    mass = 2\n"));
  EXPECT_THAT(messagesOf(kMoments + kStart + "[output]\ntheta = true\n"), HasSubstr("did you mean show.theta?"));
}

TEST(ForeignNames, AreKnownForValuesOfAnotherForm) {
  EXPECT_THAT(messagesOf(kMoments + "[motion]\nL = [0, 0, 2]\n"),
              EndsWith("For example:\n    L_body = [0, 0, 2]\n"));
  EXPECT_THAT(messagesOf(kMoments + "[motion]\nspin = [0, 0, 2]\n"),
              EndsWith("For example:\n    omega_body = [0, 0, 2]\n"));
  EXPECT_THAT(messagesOf(kMoments + kStart + "drag = 0.1\n"),
              HasSubstr("motion.drag: expected a table [motion.drag], got 0.1; did you mean motion.drag.rate?"));
}

TEST(ForeignNames, AreNotFollowedByAMissingKey) {
  for (const char* name : {"w", "omega_bdy", "angular_velocity", "L0", "spin_rate"})
    EXPECT_EQ(problemsOf(kMoments + "[motion]\n" + name + " = [0, 0, 3]\n").size(), 1u) << name;
  EXPECT_EQ(problemsOf("w = [0, 0, 3]\n" + kMoments).size(), 1u);
  EXPECT_EQ(messagesOf(kMoments + "[motion]\nomega_bdy = [0, 0, 3]\n"),
            "motion.omega_bdy: unknown key; did you mean motion.omega_body?\n");
}

TEST(ForeignNames, HaveNoLinesInAnOverride) {
  EXPECT_EQ(messagesOf(kMinimal, {"time.t_end=3"}), "time.t_end: unknown key; did you mean time.duration?\n");
}

}  // namespace
}  // namespace poinsot::scene
