// SPDX-License-Identifier: Apache-2.0
// Each file of tests/scene/data is wrong in its own way. Lines and columns were counted by hand.
#include <gmock/gmock.h>

#include "scene/document/document.h"
#include "scene/document/problem.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

struct Spot {
  int line, column, caretLength;
};

class BadScene : public testing::Test {
 protected:
  void load(const std::string& name) {
    try {
      loadScene(dataPath(name));
      ADD_FAILURE() << name << " was accepted";
    } catch (const SceneErrors& errors) {
      EXPECT_EQ(errors.kind(), core::ErrorKind::kScene);
      problems_ = errors.problems();
      report_ = errors.what();
    }
  }

  /// Expects that the next problem is at `place` and has exactly this message.
  void expectNext(const Spot& place, const std::string& message) {
    ASSERT_LT(next_, problems_.size());
    const Problem& problem = problems_[next_++];
    EXPECT_EQ(problem.where.line, place.line);
    EXPECT_EQ(problem.where.column, place.column);
    EXPECT_EQ(problem.caretLength, place.caretLength);
    EXPECT_EQ(problem.message, message);
  }

  void expectNoMore() { EXPECT_EQ(next_, problems_.size()) << report_; }

  void expectOnly(const std::string& name, const Spot& place, const std::string& message) {
    load(name);
    expectNext(place, message);
    expectNoMore();
  }

  std::vector<Problem> problems_;
  std::size_t next_ = 0;
  std::string report_;
};

TEST_F(BadScene, IsRejectedForAnUnknownKey) {
  expectOnly("unknown_key.toml", {5, 1, 10}, "motion.omega_bdoy: unknown key; did you mean motion.omega_body?");
}

TEST_F(BadScene, IsRejectedForAnUnknownTable) {
  expectOnly("unknown_table.toml", {5, 2, 5}, "camra: unknown key; did you mean camera?");
}

TEST_F(BadScene, IsRejectedForAKeyInTheWrongTable) {
  expectOnly(
      "misplaced_key.toml", {5, 1, 3},
      "motion.fps: unknown key; did you mean time.fps? For example, at the end of the file:\n    [time]\n    "
      "fps = 25");
}

TEST_F(BadScene, IsRejectedForAValueOfTheWrongType) {
  expectOnly("wrong_type.toml", {6, 12, 4},
             "time.duration: expected a time, a number in s or text with a unit such as s, ms, us, min, h, d, yr "
             "(poinsot explain units lists all), got true");
}

TEST_F(BadScene, IsRejectedForAValueOutOfRange) {
  expectOnly("out_of_range.toml", {6, 7, 9}, "camera.fov: must be from 1 to 120 deg, got \"200 deg\"");
}

TEST_F(BadScene, IsRejectedForImpossibleInertia) {
  expectOnly(
      "impossible_inertia.toml", {2, 21, 15},
      "body.principal_moments: I3 must not exceed I1 + I2, got (0.1, 0.2, 0.9) kg·m²; a solid body cannot have "
      "these values; the nearest possible moments in kg·m² are [0.3, 0.4, 0.7]");
}

TEST_F(BadScene, IsRejectedForNumbersThatAreNotFinite) {
  load("not_finite.toml");
  expectNext({2, 27, 3}, "body.principal_moments: must be a finite number, got nan");
  expectNext({4, 21, 3}, "motion.omega_body: must be a finite number, got inf");
  expectNoMore();
}

TEST_F(BadScene, IsRejectedAtRestIfLNeedsADirection) {
  expectOnly(
      "zero_omega.toml", {4, 14, 11},
      "motion.omega_body: must not be zero, got (0, 0, 0) rad/s: without rotation L has no direction to turn "
      "onto the vertical; give a rotation, or motion.orientation");
}

TEST_F(BadScene, IsRejectedAtRestIfArrowsAreShown) {
  expectOnly(
      "zero_omega_oriented.toml", {4, 14, 9},
      "motion.omega_body: must not be zero, got (0, 0, 0) rad/s: without rotation there is nothing to draw for "
      "show.L, show.omega; give a rotation, or set these to false");
}

TEST_F(BadScene, IsRejectedForAZeroQuaternion) {
  expectOnly("zero_quaternion.toml", {5, 15, 12},
             "motion.orientation: must not be zero, got [0, 0, 0, 0]: a zero quaternion is not an orientation");
}

TEST_F(BadScene, IsRejectedForAnOddPictureSize) {
  expectOnly(
      "odd_size.toml", {6, 9, 3},
      "output.size: each side must be even (video stores colour for pairs of pixels), got 641; the nearest even "
      "size is 642");
}

TEST_F(BadScene, IsRejectedForWrongAndUnknownUnits) {
  load("bad_unit.toml");
  expectNext(
      {6, 12, 6},
      "time.duration: expected a time in one of s, ms, us, min, h, d, yr (poinsot explain units lists all), "
      "got \"3 kg\"");
  expectNext({7, 9, 11},
             "time.start: \"parsecs\" is not a known unit; expected a time in one of s, ms, us, min, h, d, yr "
             "(poinsot explain units lists all)");
  expectNoMore();
}

TEST_F(BadScene, IsRejectedForAnUnknownWord) {
  expectOnly("bad_word.toml", {6, 9, 6},
             "style.theme: expected one of \"light\", \"dark\", \"print\", got \"drak\"; did you mean \"dark\"?");
}

TEST_F(BadScene, ReportsBothOfTwoErrors) {
  load("two_problems.toml");
  expectNext({2, 27, 4},
             "body.principal_moments: must be positive, from 1e-60 to 1e+60 kg·m², got -2 kg·m²; "
             "the nearest possible moments in kg·m² are [1.75, 1.75e-06, 1.75]");
  expectNext({4, 14, 6}, "motion.omega_body: expected an array of three angular velocities, got \"fast\"");
  expectNoMore();
}

TEST_F(BadScene, IsRejectedForADuplicateKey) {
  load("duplicate_key.toml");
  ASSERT_EQ(problems_.size(), 1u);
  EXPECT_EQ(problems_[0].where.line, 3);
  EXPECT_EQ(problems_[0].where.column, 1);
  EXPECT_EQ(problems_[0].caretLength, 17);
  EXPECT_THAT(problems_[0].message, StartsWith("this key or table is given twice"));
}

TEST_F(BadScene, IsRejectedForASyntaxError) {
  load("syntax_error.toml");
  ASSERT_EQ(problems_.size(), 1u);
  EXPECT_EQ(problems_[0].where.line, 2);
  EXPECT_EQ(problems_[0].where.column, 21);
  EXPECT_THAT(problems_[0].message, StartsWith("not TOML: "));
}

TEST_F(BadScene, IsRejectedForAUnitOutsideQuotes) {
  load("unquoted_unit.toml");
  ASSERT_EQ(problems_.size(), 1u);
  EXPECT_EQ(problems_[0].where.line, 6);
  EXPECT_EQ(problems_[0].where.column, 14);
  EXPECT_THAT(problems_[0].message, HasSubstr("write a number with a unit, or a fraction, in quotes: \"3 rpm\""));
}

TEST_F(BadScene, IsRejectedForAnotherSchemaVersion) {
  expectOnly("wrong_schema.toml", {1, 10, 1}, "schema: must be 1, got 2");
}

TEST_F(BadScene, IsAnsweredWithAnExampleIfEmpty) {
  load("empty.toml");
  ASSERT_EQ(problems_.size(), 1u);
  EXPECT_EQ(problems_[0].where.line, 1);
  EXPECT_EQ(problems_[0].where.column, 1);
  const std::string& message = problems_[0].message;
  EXPECT_THAT(message, StartsWith("a body and a start are required, for example:\n"));
  EXPECT_NO_THROW(parseScene(message.substr(message.find('\n')), "example.toml"));  // the example is a scene
}

TEST_F(BadScene, IsRejectedForBothMomentsAndAShape) {
  expectOnly(
      "both.toml", {3, 9, 5},
      "body.shape: body.principal_moments is given too; the moments come from it, or from shape, size and mass, "
      "not from both (to draw a shape that does not set the moments, use show.body.shape)");
}

TEST_F(BadScene, IsRejectedForAShapeWithoutAMass) {
  expectOnly("half_a_shape.toml", {2, 9, 5},
             "body.shape: body.mass is missing: a shape and its mass (or density) set the moments together. "
             "For example:\n    mass = 1");
}

TEST_F(BadScene, IsRejectedWithoutAnInitialRotation) {
  expectOnly("no_start.toml", {1, 1, 0},
             "motion.omega_body: a start is required: give the angular velocity. For example, in [motion]:\n"
             "    omega_body = [0.01, 3.0, 0.0]");
}

TEST_F(BadScene, IsRejectedForANegativeMass) {
  expectOnly("negative_mass.toml", {4, 8, 2}, "body.mass: must be positive, from 1e-60 to 1e+60 kg, got -2 kg");
}

TEST_F(BadScene, IsRejectedForTooManyFrames) {
  expectOnly("too_many_frames.toml", {6, 12, 5},
             "time.duration: 3600 s at 60/1 frames per second are 216000 frames; a film may have at most 36000; "
             "--limit frames=N raises the limit");
}

TEST(ErrorReport, ShowsTheLineAndPointsAtTheValue) {
  const auto problems =
      problemsOf("[body]\nprincipal_moments = [0.1, 0.2, 0.9]\n[motion]\nomega_body = [1, 0, 0]\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(
      toString(problems[0]),
      "test.toml:2:21: error: body.principal_moments: I3 must not exceed I1 + I2, got (0.1, 0.2, 0.9) kg·m²; a "
      "solid body cannot have these values; the nearest possible moments in kg·m² are [0.3, 0.4, 0.7]\n"
      "   2 | principal_moments = [0.1, 0.2, 0.9]\n"
      "     |                     ^^^^^^^^^^^^^^^");
}

TEST(ErrorReport, RejectsARangeForASingleValue) {
  for (const char* value : {"1..3:3", "1|2"})
    EXPECT_EQ(messagesOf(kMinimal, {std::string("time.speed=") + value}),
              "time.speed: expected one value; only sweep, preview and submit take ranges\n");
}

std::string atMessage(const std::string& text) {
  const auto problems = problemsOf(text);
  for (const Problem& problem : problems)  // the scenes lack a body, which is reported too
    if (problem.message.find("TOML") != std::string::npos)
      return core::toString(problem.where) + ": " + problem.message;
  return problems.empty() ? "" : core::toString(problems[0].where) + ": " + problems[0].message;
}

TEST(ErrorReport, PointsAtAnUnclosedArray) {
  const std::string unclosed = "not TOML: the array that begins here has no closing ]";
  EXPECT_EQ(atMessage("[motion]\nomega_body = [1, 0, 0\n\n[time]\nduration = 3\n"), "test.toml:2:14: " + unclosed);
  EXPECT_EQ(atMessage("[motion]\nomega_body = [1, 0, 0 # ]\n[[view]]\n"), "test.toml:2:14: " + unclosed);
  EXPECT_EQ(atMessage("[motion]\nomega_body = [1, 0,\n\nphase = 3\n"), "test.toml:2:14: " + unclosed);
  EXPECT_EQ(atMessage("[body]\ninertia = [\n  [1, 0, 0],\n  [0, 1, 0"), "test.toml:4:3: " + unclosed);
  // A missing comma is reported where it is missing.
  EXPECT_THAT(atMessage("[body]\ninertia = [\n  [1, 0, 0],\n  [0, 1, 0]\n  [0, 0, 1]\n]\n"),
              AllOf(HasSubstr("test.toml:5:3: not TOML"), HasSubstr("expected comma")));
  EXPECT_THAT(atMessage("[motion]\nomega_body = [1, 0 0]\n"),
              AllOf(HasSubstr("test.toml:2:20: not TOML"), HasSubstr("expected comma")));
}

TEST(ErrorReport, NamesAMisspeltKeyOnlyOnce) {
  // Each scene lacks the key that the misspelt name should have given. The first message already says so.
  const auto only = [](const std::string& text) { return messagesOf(text); };
  const std::string body = "[body]\nprincipal_moments = [1, 2, 3]\n",
                    motion = "[motion]\nomega_body = [1, 0, 0]\n";
  EXPECT_EQ(only("[body]\nprinciple_moments = [1, 2, 3]\n" + motion),
            "body.principle_moments: unknown key; did you mean body.principal_moments?\n");
  EXPECT_EQ(only("[bdy]\nprincipal_moments = [1, 2, 3]\n" + motion), "bdy: unknown key; did you mean body?\n");
  EXPECT_EQ(only(body + "[motoin]\nomega_body = [1, 0, 0]\n"), "motoin: unknown key; did you mean motion?\n");
  EXPECT_EQ(only(body + "[motion]\nomega_bod = [1, 0, 0]\n"),
            "motion.omega_bod: unknown key; did you mean motion.omega_body?\n");
  EXPECT_EQ(only(body + "[motion]\nspin = 1\nspinaxis = 2\n"),
            "motion.spinaxis: unknown key; did you mean motion.spin_axis?\n");
  EXPECT_EQ(only("[body]\nshape = \"box\"\nsize = 1\ndensty = 2\n" + motion),
            "body.densty: unknown key; did you mean body.density?\n");
  EXPECT_EQ(only("[body]\nshpe = \"box\"\nsize = 1\nmass = 2\n" + motion),
            "body.shpe: unknown key; did you mean body.shape?\n");
  EXPECT_EQ(only("[body]\nshape = \"box\"\nsze = 1\nmass = 2\n" + motion),
            "body.sze: unknown key; did you mean body.size?\n");
  EXPECT_EQ(only("[[body.part]]\nshape = \"box\"\nsize = 1\nmass = 2\naxis = [1, 0, 0]\nangel = 2\n" + motion),
            "body.part[0].angel: unknown key; did you mean body.part[0].angle?\n");
  EXPECT_EQ(only("[[body.point_mass]]\nmas = 1\nposition = [1, 0, 0]\n" + motion),
            "body.point_mass[0].mas: unknown key; did you mean body.point_mass[0].mass?\n");
  EXPECT_EQ(only(body + motion + "[[motion.torque.step]]\nfrm = 1\nbody = [1, 0, 0]\n"),
            "motion.torque.step[0].frm: unknown key; did you mean motion.torque.step[0].from?\n");
  // A misspelt name that resembles another key does not explain the missing key.
  EXPECT_THAT(only("[[body.part]]\nshape = \"box\"\nsize = 1\nofset = [1, 0, 0]\n" + motion),
              AllOf(HasSubstr("body.part[0].mass is missing"), HasSubstr("did you mean body.part[0].offset?")));
}

TEST(ErrorReport, SuggestsKeysForNamesOfOtherPrograms) {
  EXPECT_EQ(messagesOf(kMinimal, {"show.body.color=red"}),
            "show.body.color: unknown key; did you mean style.colors.body?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"show.polhode.colour=red"}),
            "show.polhode.colour: unknown key; did you mean style.colors.polhode?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"camera.color=red"}),
            "camera.color: unknown key; did you mean [style.colors]?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"style.background=white"}),
            "style.background: unknown key; did you mean style.colors.paper?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"output.width=640"}), "output.width: unknown key; did you mean output.size?\n");
}

TEST(ErrorReport, ExplainsCommonMistakesInToml) {
  const std::string motion = "[motion]\nomega_body = [1, 0, 0]\n";
  EXPECT_EQ(atMessage("[body]\nshape = \"box\n" + motion),
            "test.toml:2:13: not TOML: this text has no closing quote");
  EXPECT_THAT(atMessage("[body]\ncatalogue = \u201cbook\u201d\n" + motion),
              HasSubstr("write text in straight quotes"));
  for (const char* value : {"duration = 10s", "fps = 24000/1001", "duration = 1.5 s"})
    EXPECT_THAT(atMessage(std::string("[time]\n") + value + "\n"), HasSubstr("or a fraction, in quotes")) << value;
  EXPECT_THAT(atMessage("[show]\ncones = true\ncones.opacity = 0.5\n"),
              HasSubstr("already given as true or false; remove that line"));
  EXPECT_EQ(
      atMessage("[body]\nshape = torus\n"),
      "test.toml:2:10: not a TOML value; write text in quotes: \"...\". For example:\n    shape = \"torus\"");
  EXPECT_THAT(atMessage("[motion.gravity]\ng = 9,81\n"), HasSubstr("(write decimals with a point: 9.81)"));
  EXPECT_THAT(atMessage("[motion]\nomega_body = 0, 0, 5\n"), HasSubstr("(write several values in brackets: "));
  EXPECT_THAT(messagesOf(kMinimal, {"motion.omega_body=[0, 0, 5 rpm]"}), HasSubstr("in quotes: \"3 rpm\""));
  EXPECT_THAT(messagesOf(kMinimal, {"show.title=\"$\\theta$\""}), HasSubstr("write mathematics in single quotes"));
}

TEST(ErrorReport, NamesTheFirstLineOfADuplicateKey) {
  const std::string minimal(kMinimal);  // [motion] is on line 3
  EXPECT_THAT(atMessage(minimal + "[motion]\n"), EndsWith("'motion'; first on line 3"));
  EXPECT_THAT(atMessage("[time]\nfps = 25\nspeed = 1\nfps = 30\n"), EndsWith("'fps'; first on line 2"));
  EXPECT_THAT(atMessage("[time]\nfps = 25\n[time]\nfps = 30\n"), EndsWith("'time'; first on line 1"));
  EXPECT_EQ(atMessage("[plot]\nquantities = [\"t\"]\n[[plot]]\n"),
            "test.toml:3:1: line 1 has single brackets; each element of an array of tables begins with [[plot]]");
  EXPECT_THAT(atMessage("[\"a\xe2\x80\xae\"]\n[\n[[\n =\n"), Not(HasSubstr("\xe2\x80\xae")));
  EXPECT_EQ(atMessage("[ plot ]\n  [[ \"\xe2\x80\xae\" ]]\n[[plot]]\n").find("\xe2\x80\xae"), std::string::npos);
}

// The search for the first line looks at all 30 000 lines above, far faster than the allowed tenth of a second.
TEST(ErrorReport, IsQuickForALongFile) {
  std::string text = "[a]\n";
  for (int i = 0; i < 30000; ++i) text += "[a" + std::to_string(i) + "]\n";
  text += "[a]\n";
  const Source source("test.toml", text);
  try {
    parseDocument(source);
    FAIL();
  } catch (const SceneErrors& errors) {
    EXPECT_THAT(errors.problems().front().message, EndsWith("'a'; first on line 1"));
  }
}

TEST(ErrorReport, SuggestsTheNearestFigureOrQuantity) {
  EXPECT_EQ(messagesOf(kMinimal, {"output.theta=true"}), "output.theta: unknown key; did you mean show.theta?\n");
  EXPECT_EQ(messagesOf(std::string(kMinimal) + "[[plot]]\nquantities = [\"theta_vert\"]\n"),
            "plot[0].quantities: expected one of the quantities, got \"theta_vert\"; did you mean "
            "\"theta_vertical\"?\n");
}

TEST(ErrorReport, SuggestsKeysOfDeeperTablesAndPlurals) {
  EXPECT_EQ(messagesOf(kMinimal, {"view=[{plane=false}]"}),
            "view[0].plane: unknown key; did you mean view[0].show.plane?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"fov=0.3"}), "fov: unknown key; did you mean camera.fov?\n");
  EXPECT_EQ(messagesOf(kMinimal, {"style.L=red"}), "style.L: unknown key; did you mean style.colors.L?\n");
  EXPECT_EQ(
      messagesOf(std::string(kMinimal) + "[[plot]]\nquantity = [\"t\"]\n"),
      "plot[0].quantity: unknown key; did you mean plot[0].quantities? For example:\n    quantities = [\"t\"]\n");
}

TEST(ErrorReport, NamesAWrongFormOfATableOnlyOnce) {
  const std::string motion = "[motion]\nomega_body = [1, 0, 0]\n";
  EXPECT_THAT(messagesOf("[body.part]\nshape = \"box\"\n" + motion),
              StartsWith("body.part: expected an array of tables, each begun with [[body.part]]"));
  EXPECT_THAT(messagesOf("body = \"book\"\n" + motion), StartsWith("body: expected a table [body]"));
  EXPECT_EQ(messagesOf("[Body]\nprincipal_moments = [1, 2, 3]\n[Motion]\nomega_body = [1, 0, 0]\n"),
            "Body: unknown key; did you mean body?\nMotion: unknown key; did you mean motion?\n");
}

TEST(ErrorReport, SuggestsTheIntendedValue) {
  EXPECT_THAT(messagesOf(kMinimal, {"style.colors.L=\"#c00\""}), HasSubstr("did you mean \"#cc0000\"?"));
  EXPECT_THAT(messagesOf(kMinimal, {"style.colors.L=\"336699\""}), HasSubstr("did you mean \"#336699\"?"));
  EXPECT_THAT(messagesOf(kMinimal, {"style.colors.L=ivory"}), Not(HasSubstr("did you mean")));
  EXPECT_THAT(messagesOf(kMinimal, {"motion.omega_body=[0, 6, 0,1]"}),
              HasSubstr("write decimals with a point: 0.1"));
  EXPECT_THAT(messagesOf(kMinimal, {"motion.omega_body=[0, 6, \"3 Rpm\"]"}), HasSubstr("did you mean \"rpm\"?"));
  EXPECT_THAT(messagesOf(kMinimal, {"camera.fov=\"24\""}),
              HasSubstr("\"24\" has no unit, such as rad, mrad, deg"));
  EXPECT_EQ(messagesOf(kMinimal, {"show.decomposition=true"}),
            "show.decomposition: only a symmetric body precesses steadily; all three moments differ here: (1, 2, "
            "2.5) kg·m²; "
            "leave it out\n");
}

TEST(ErrorReport, PointsAtTheTableThatLacksAKey) {
  const auto body = problemsOf("[motion]\nomega_body = [1, 0, 0]\n[body]\n");
  ASSERT_EQ(body.size(), 1u);
  EXPECT_EQ(
      body[0].message,
      "body: the body is missing; give principal_moments, inertia, shape, catalogue, or parts and point masses. "
      "For example, in [body]:\n    shape = \"box\"\n    size = [0.3, 0.2, 0.05]\n    mass = 1");
  EXPECT_EQ(core::toString(body[0].where), "test.toml:3:2");
  const auto motion = problemsOf("[body]\nprincipal_moments = [1, 1, 1]\n  [motion]\n");
  ASSERT_EQ(motion.size(), 1u);
  EXPECT_EQ(core::toString(motion[0].where), "test.toml:3:4");
}

TEST(ErrorReport, ListsErrorsOfTheFileBeforeThoseOfOverrides) {
  const auto problems = problemsOf("z = 1\na = 1\n" + std::string(kMinimal), {"b=1"});
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0].where.line, 1);
  EXPECT_EQ(problems[1].where.line, 2);
  EXPECT_EQ(problems[2].where.file, "-D b=1");
}

TEST(ErrorReport, PlacesTheMarkByCharactersNotBytes) {
  const auto problems = problemsOf(std::string(kMinimal) + "[show]\ntitle = { \"ωω\" = 1 }\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_THAT(toString(problems[0]), EndsWith("\n   6 | title = { \"ωω\" = 1 }\n     |         ^^^^^^^^^^^^"));
}

TEST(ErrorReport, ShowsOnlyAPartOfALongLine) {
  const std::string padding(1000, ' ');
  const auto problems =
      problemsOf(std::string(kMinimal) + "[time]\nduration =" + padding + "true" + padding + "# end\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].where.column, 1011);
  EXPECT_LE(problems[0].sourceLine.size(), 120u);
  EXPECT_EQ(problems[0].sourceLine.substr(static_cast<std::size_t>(problems[0].caret), 4), "true");
}

TEST(ErrorReport, EscapesTerminalControlCharacters) {
  const std::string text =
      std::string(kMinimal) +
      "[show]\ntitle = \"\\u001b[31m\"\n\"\\u202e\" = 1\nlabels = \"\xc2\x9b\"\n[\"\\n\\u0007\"]\n";
  try {
    parseScene(text, "a\x1b.toml", {"\x1b=\x07", "style.theme=\r"});
    FAIL();
  } catch (const SceneErrors& errors) {
    const std::string report = errors.what();
    EXPECT_EQ(errors.problems().size(), 6u) << report;
    for (const char c : report) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << report;
    EXPECT_EQ(report.find("\xc2\x9b"), std::string::npos);
    EXPECT_EQ(report.find("\xe2\x80\xae"), std::string::npos);
    EXPECT_EQ(report.find('\x7f'), std::string::npos);
  }
}

TEST(ErrorReport, ListsAtMostFiftyProblems) {
  std::string text = kMinimal;
  for (int i = 0; i < 1000; ++i) text += "key" + std::to_string(i) + " = 1\n";
  try {
    parseScene(text, "test.toml");
    FAIL();
  } catch (const SceneErrors& errors) {
    EXPECT_EQ(errors.problems().size(), 50u);
    EXPECT_EQ(errors.omitted(), 950);
    EXPECT_THAT(errors.what(), EndsWith("\nand 950 more"));
  }
}

TEST(Tables, RejectValuesThatAreNotTables) {
  EXPECT_THAT(messagesOf("body = 3\n"), HasSubstr("body: expected a table [body], got 3"));
  EXPECT_THAT(messagesOf("[[body]]\n"), HasSubstr("body: expected a table [body], got an array of 1"));
  EXPECT_THAT(messagesOf(std::string(kMinimal) + "[show]\nplane = 3\n"),
              HasSubstr("show.plane: expected a table [show.plane], true or false, got 3"));
}

TEST(Shapes, RejectSizesThatDoNotFitTheShape) {
  const std::string body = "motion.omega_body = [1, 0, 0]\n[body]\nmass = 1\n";
  EXPECT_THAT(messagesOf(body + "shape = \"cylinder\"\nsize = [1, 2, 3]\n"),
              HasSubstr("body.size: the x and y extents of a cylinder must be equal, got (1, 2, 3) m"));
  EXPECT_THAT(messagesOf(body + "shape = \"racket\"\nsize = [1, 2, 3]\n"),
              HasSubstr("body.size: a racket must be longer (x) than wide (y), got (1, 2, 3) m"));
  EXPECT_THAT(messagesOf(kMinimal, {"show.body.size=[1, 2, 3]"}),
              HasSubstr("show.body.size: show.body.shape is missing; this key describes a shape"));
}

}  // namespace
}  // namespace poinsot::scene
