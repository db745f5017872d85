// SPDX-License-Identifier: Apache-2.0
// Tests the effect of a user's defaults.toml on `new` and on `info`, and that nothing else changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "support/program_run.h"
#include "support/sanitized.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Defaults : public testing::Test {
 protected:
  Defaults() { std::filesystem::create_directories(folder_ / "config/poinsot"); }

  RunResult run(const std::vector<std::string>& words) const {
    return poinsot::run(folder_, words, Stdout::kFile,
                        {"XDG_CONFIG_HOME=" + (folder_ / "config").string(),
                         std::string("POINSOT_SCENES=") + POINSOT_SOURCE_DIR "/scenes"});
  }
  std::string said(const std::vector<std::string>& words) const {
    const auto result = run(words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.out;
  }
  void give(const std::string& defaults) const { folder_.put("config/poinsot/defaults.toml", defaults); }
  std::string made(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"new", "a", "--force"};
    words.insert(words.end(), more.begin(), more.end());
    said(words);
    said({"check", "a.toml"});
    return bytesOf(folder_ / "a.toml");
  }

  ScratchFolder folder_;
};

TEST_F(Defaults, AreWrittenIntoANewScene) {
  give(
      "[units]\nlength = \"mm\"\nangular_velocity = \"rpm\"\n"
      "[scene]\nstyle.theme = \"dark\"\ntime.duration = 8\nlabel.omega = '\\Omega \"'\ncamera.fov = \"20 deg\"\n"
      "output.size = [640, 360]\nstyle = { decimal = \",\" }\n");
  // Computed by hand: 24 cm are 240 mm, 3.2 rad/s are 30.56 rpm.
  EXPECT_EQ(run({"new", "a"}).exitCode, 2) << "a table is given twice";
  give(
      "[units]\nlength = \"mm\"\nangular_velocity = \"rpm\"\n"
      "[scene]\nstyle.theme = \"dark\"\ntime.duration = 8\nlabel.omega = '$\\Omega$'\ncamera.fov = \"20 deg\"\n"
      "output.size = [640, 360]\n");
  const std::string scene = made();
  EXPECT_THAT(scene, AllOf(HasSubstr("size = [\"240 mm\", \"170 mm\", \"30 mm\"]"),
                           HasSubstr("omega_body = [\"0.382 rpm\", \"30.6 rpm\", \"0.382 rpm\"]"),
                           HasSubstr("mass = \"1.2 kg\"")));
  EXPECT_THAT(scene, AllOf(HasSubstr("\n[style]\ntheme = \"dark\"\n"), HasSubstr("\n[time]\nduration = 8\n"),
                           HasSubstr("\n[camera]\nfov = \"20 deg\"\n"), HasSubstr("\nsize = [640, 360]\n"),
                           HasSubstr("\n[label]\nomega = \"$\\\\Omega$\"\n"), Not(HasSubstr("duration = 12"))));
}

TEST_F(Defaults, RoundNumbersAndAlignCommentsOfANewScene) {
  give("[units]\nlength = \"mm\"\nmass = \"g\"\nangular_velocity = \"rpm\"\nangle = \"rad\"\n");
  const std::string scene = made();
  EXPECT_THAT(scene, AllOf(HasSubstr("\nmass = \"1200 g\"\n"), HasSubstr("\nazimuth = \"0.349 rad\"\n")));
  EXPECT_THAT(scene, HasSubstr("\nsize = [\"240 mm\", \"170 mm\", \"30 mm\"]  # along"));  // over 37 columns
  give("");
  std::istringstream lines(made());
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.find("  # ") == line.npos || line.find("# ", 1) == 38) << line;
}

TEST_F(Defaults, DoNotOverrideKeysOfAGalleryScene) {
  give("[scene]\nstyle.theme = \"dark\"\ncamera.azimuth = \"77 deg\"\nshow.ellipsoid.opacity = 0.5\n");
  const std::string scene = made({"--from", "football"});  // this scene sets an azimuth and `ellipsoid = false`
  EXPECT_THAT(scene, AllOf(HasSubstr("\n[style]\ntheme = \"dark\"\n"), HasSubstr("azimuth = \"20 deg\""),
                           Not(HasSubstr("77 deg")), Not(HasSubstr("opacity = 0.5"))));
  for (const auto& entry : std::filesystem::directory_iterator(POINSOT_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".toml") made({"--from", entry.path().stem()});  // every scene stays valid
}

TEST_F(Defaults, SetTheUnitsOfInfoButNotOfItsJson) {
  folder_.put("s.toml",
              "[body]\nshape = \"box\"\nsize = [3, 2, 1]\nmass = 12\n[motion]\nomega_body = [0, 0, \"30 rpm\"]\n");
  const std::string json = said({"info", "s.toml", "--json"});
  EXPECT_THAT(said({"info", "s.toml"}),
              AllOf(HasSubstr("(0, 0, 3.14159) rad/s"), HasSubstr("(5, 10, 13) kg m^2")));
  give("[units]\nangular_velocity = \"rpm\"\nmoment_of_inertia = \"t cm^2\"\nenergy = \"mJ\"\n");
  // Computed by hand: I3 = 12 kg (3² + 2²) m² / 12 = 13 kg m² = 130 t cm²; T = I3 ω²/2 = 6.5 π² J.
  std::vector<std::vector<std::string>> ways{{"info", "s.toml"}};
  // The sandbox limits the address space, and valgrind does not support the sandbox's system calls.
  if (!kSanitized && !std::getenv("POINSOT_RUN_UNDER")) ways.push_back({"info", "--untrusted", "s.toml"});
  for (const std::vector<std::string>& words : ways)
    EXPECT_THAT(said(words), AllOf(HasSubstr("(0, 0, 30) rpm"), HasSubstr("(50, 100, 130) t cm^2"),
                                   HasSubstr("64152.4 mJ"), HasSubstr(" 12 kg\n")));
  EXPECT_EQ(said({"info", "s.toml", "--json"}), json);
}

TEST_F(Defaults, ChangeNoTrajectoryAndNoPicture) {
  said({"new", "a"});
  const auto numbers = said({"trajectory", "a.toml", "--at", "0,1"});
  const auto digest = said({"still", "a.toml", "--size", "64x36", "-o", "a.png", "-q", "preview"});
  const std::string picture = bytesOf(folder_ / "a.png");
  give("[units]\nlength = \"mm\"\n[scene]\nstyle.theme = \"dark\"\n");
  EXPECT_EQ(said({"trajectory", "a.toml", "--at", "0,1"}), numbers);
  said({"still", "a.toml", "--size", "64x36", "-o", "b.png", "-q", "preview"});
  EXPECT_EQ(bytesOf(folder_ / "b.png"), picture);
}

TEST_F(Defaults, ReportLineAndColumnOfMistakes) {
  const auto says = [&](const std::string& defaults) {
    give(defaults);
    const auto result = run({"new", "a", "--force"});
    EXPECT_EQ(result.exitCode, 2) << defaults;
    return result.err;
  };
  EXPECT_THAT(says("units = 3\n"), HasSubstr("defaults.toml:1:1: error: units: unknown key; this file may contain "
                                             "only the tables [units] and [scene]"));
  EXPECT_THAT(says("[units]\nlenght = \"m\"\n"),
              HasSubstr("defaults.toml:2:1: error: units.lenght: unknown quantity; did you mean length?"));
  EXPECT_THAT(says("[units]\nlength = \"kg\"\n"),
              HasSubstr("defaults.toml:2:10: error: units.length: expected a unit such as m, km, cm, mm"));
  EXPECT_THAT(says("[units]\nlength = 3\n"), HasSubstr("got 3\n"));
  EXPECT_THAT(says("[scene]\nstyle.them = \"dark\"\nstyle.theme = \"drak\"\n"),
              AllOf(HasSubstr("defaults.toml:2:7: error: style.them: unknown key; did you mean style.theme?"),
                    HasSubstr("defaults.toml:3:7: error: style.theme: ")));
  EXPECT_THAT(says("[scene]\nmotion.omega_body = [1, 2, 3]\n"), HasSubstr("cannot have a default"));
  EXPECT_THAT(says("[scene]\ntime.duration = 2020-01-01\n"),
              HasSubstr("defaults.toml:2:6: error: time.duration: "));
  EXPECT_THAT(says("[scene\n"), HasSubstr("defaults.toml:1:"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.toml"));
}

}  // namespace
}  // namespace poinsot
