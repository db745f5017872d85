// SPDX-License-Identifier: Apache-2.0
// The alternative text contains the numbers of the report, which other tests compare with worked values. Here a
// stream rounds them independently.
#include "describe/alt_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <sstream>

#include "describe/report.h"
#include "request/scene_request.h"

namespace poinsot::describe {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kScenes = POINSOT_SOURCE_DIR "/scenes";

scene::Scene sceneOf(const std::string& text) {
  return request::loadRequested({"made.toml", text, {}, std::nullopt});
}

scene::Scene galleryScene(const std::string& name) {
  return request::loadRequested(request::readSceneRequest(kScenes + "/" + name + ".toml", {}));
}

json numbersOf(const scene::Scene& scene) { return json::parse(reportJson(sceneReport(scene))); }

/// Returns a value to three digits, rounded by a standard stream.
std::string rounded(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

std::string inDegrees(const json& value) { return rounded(value.get<double>() * 180 / std::numbers::pi) + "°"; }

std::vector<std::string> galleryNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  return names;
}

TEST(AltText, DescribesASymmetricTop) {
  const scene::Scene scene = galleryScene("football");
  const json info = numbersOf(scene);
  const std::string text = altText(scene);
  EXPECT_THAT(text, HasSubstr("It turns at " + rounded(info["omega"]) + " rad/s, one turn in " +
                              rounded(2 * std::numbers::pi / info["omega"].get<double>()) + " s"));
  EXPECT_THAT(text, HasSubstr("the symmetry axis e3 leans from L by " + inDegrees(info["tilt"])));
  EXPECT_THAT(text, HasSubstr("goes round L once in " +
                              rounded(2 * std::numbers::pi / info["precession_rate"].get<double>()) + " s"));
  EXPECT_THAT(text, HasSubstr("which makes " + inDegrees(info["body_cone_half_angle"]) + " with the axis"));
  EXPECT_THAT(text, HasSubstr("once in " + rounded(info["wobble_period"]) +
                              " s, in the sense opposite to the spin"));  // prolate: Omega_p < 0
  EXPECT_LT(info["body_precession_rate"], 0);
  EXPECT_THAT(text, HasSubstr("In blue: an arrow for L and the plane through L and ω."));  // show.plane_of_L
}

TEST(AltText, NamesTheTriadAndThePartsOfL) {
  const std::string triad = altText(galleryScene("precession_frame"));
  EXPECT_THAT(triad, HasSubstr("the axes i, j and k, with i in the plane of L and k"));
  EXPECT_THAT(triad, HasSubstr("the parts of ω along i and k"));
  EXPECT_THAT(altText(galleryScene("momentum_parts")), HasSubstr("the two parts of L, head to tail"));
}

TEST(AltText, DescribesFlips) {
  const scene::Scene scene = galleryScene("tennis_racket");
  const json info = numbersOf(scene);
  const std::string text = altText(scene);
  EXPECT_THAT(text,
              HasSubstr("Every " + rounded(info["flip_interval"]) + " s the body flips: its middle axis e2"));
  EXPECT_THAT(text, HasSubstr("once in " + rounded(info["polhode_period"]) + " s its tip runs along the polhode"));
  EXPECT_THAT(text, HasSubstr("between " + rounded(info["herpolhode_smallest_radius"]) + " rad/s and " +
                              rounded(info["herpolhode_largest_radius"]) + " rad/s"));
}

TEST(AltText, DescribesAWobbleWithoutFlips) {
  const std::string text = altText(galleryScene("poinsot_rolling"));
  EXPECT_THAT(text, Not(HasSubstr("flip")));
  EXPECT_THAT(text, HasSubstr("it closes after 5 swings, in 8 turns about L and 18.4 s"));  // docs/physics.md
  EXPECT_THAT(text, HasSubstr("points straight down"));
  EXPECT_THAT(text, HasSubstr("In blue: an arrow for L, the invariable plane"));
}

TEST(AltText, DescribesAHeavyTop) {
  const std::string body = "[body]\nprincipal_moments = [1.40625, 1.40625, 0.65625]\n[motion]\n";
  const scene::Scene scene = sceneOf(body +
                                     "omega_body = [0, 0, 9.15625]\norientation = [0.9659258262890683, "
                                     "0.25881904510252074, 0, 0]\n[motion.gravity]\nmgr_body = [0, 0, 2.84375]\n");
  const std::string text = altText(scene);
  // Worked to 15 digits: 30 to 38.840183490757 deg, 1.83064120697989845 s, 0.958047879275758037 rad = 54.892 deg.
  EXPECT_THAT(text, HasSubstr("nods between 30° and 38.8° from the vertical, once in 1.83 s"));
  EXPECT_THAT(text, HasSubstr("goes round the vertical by 54.9° each time"));
  EXPECT_THAT(text, Not(HasSubstr("never changes")));  // gravity turns L
  const std::string gravity = "omega_body = [0, 0, 9]\n[motion.gravity]\nmgr_body = [0, 0, 2]\n";
  EXPECT_THAT(altText(sceneOf(body + gravity + "[show]\ntheta = true\n")),
              HasSubstr("Also shown: the angle θ between k and the vertical."));
}

TEST(AltText, DescribesMeasuredMomentsWithAMass) {
  const std::string text =
      altText(sceneOf("[body]\nprincipal_moments = [1, 1, 0.5]\nmass = 2\npivot = [0, 0, -0.5]\n[motion]\n"
                      "omega_body = [0, 0, 9]\n[motion.gravity]\ng = 9.81\n"));
  EXPECT_THAT(text,
              HasSubstr("The body is given by its moments of inertia, of 2 kg, and is drawn as the uniform box "
                        "that has them, and turns about a point that is held fixed."));
}

// The pace halves at 4 s at once, so that the 10 s of film show 4 s + 6 s/2 of motion.
TEST(AltText, DescribesAPaceThatChanges) {
  const std::string text =
      altText(sceneOf("[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 0, 2]\n"
                      "[time]\nduration = 10\nspeed = 1\n[[timeline]]\nat = 4\nover = 0\n"
                      "speed = 0.5\n"));
  EXPECT_THAT(text, HasSubstr("The film lasts 10 s and shows 7 s of motion, at a pace that changes."));
}

TEST(AltText, DescribesTorquesAndPlots) {
  const std::string text = altText(sceneOf(
      "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0, 0, 2]\n[[motion.torque.step]]\nfrom = 1\n"
      "body = [0, 0, 0.5]\n[[plot]]\nquantities = [\"omega_1\", \"omega_2\"]\ntitle = 'All'\n"
      "[[plot]]\nquantities = [\"omega_2\"]\nx = \"omega_1\"\n"));
  EXPECT_THAT(text, HasSubstr("A torque that changes with time acts on it, fixed in the body."));
  EXPECT_THAT(text, Not(HasSubstr("fixed in space")));
  EXPECT_THAT(text, HasSubstr("A plot, “All”, shows ω₁ and ω₂ against time, with a cursor"));
  EXPECT_THAT(text, HasSubstr("A plot shows ω₂ against ω₁, with a cursor at the instant of the picture."));
}

TEST(AltText, DescribesForcesAtPoints) {
  const std::string body = "body.principal_moments=[1, 2, 2.5]\nbody.mass=3\nmotion.omega_body=[1, 2, 3]\n";
  const std::string forces =
      "[[motion.force]]\nat=[1, 0, 0]\nspace=[0, 3, 4]\nfrom=1\nto=2\n[[motion.force]]\nat=[0, 1, 0]\n"
      "body=[0, 0, '20 mN']\n";
  const std::string text = altText(sceneOf(body + forces));
  EXPECT_THAT(text, HasSubstr("A force of 5 N, fixed in space, acts at a point of the body from 1 s until 2 s."));
  EXPECT_THAT(text, HasSubstr("A force of 0.02 N, fixed in the body, acts at a point of the body."));
  EXPECT_THAT(text, HasSubstr("an arrow for each force at its point of the body, while it acts"));
  EXPECT_THAT(altText(sceneOf(body + forces + "[show.forces]\narms=true\n")),
              HasSubstr("while it acts and an arrow r to it from the point that the body turns about."));
  EXPECT_THAT(altText(sceneOf(body + forces + "[show]\nforces=false\n")),
              Not(HasSubstr("an arrow for each force")));
  EXPECT_THAT(
      altText(sceneOf(body + "[motion.flight]\nvelocity=[3, 0, 4]\n" + forces)),
      HasSubstr("Its centre of mass moves at 5 m/s at the start, and the forces and its weight change this "
                "velocity."));
}

// Worked by hand: the speed is 5 m/s; 4 m/s upward against 9.80665 m/s² last 0.408 s and reach 0.816 m.
TEST(AltText, DescribesAThrownBody) {
  const std::string top =
      "body.shape='box'\nbody.size=[3, 2, 1]\nbody.mass=1\nmotion.omega_body=[1, 2, 3]\n[motion.flight]\n";
  const std::string thrown = altText(sceneOf(top + "velocity=[3, 0, 4]\n"));
  EXPECT_THAT(thrown,
              HasSubstr("Only its weight acts on the body, at the centre of mass, so its angular momentum L "
                        "about that point, "));
  EXPECT_THAT(thrown, HasSubstr("It is thrown at 5 m/s: its centre of mass flies on a parabola, which rises "
                                "0.816 m in 0.408 s, while"));
  EXPECT_THAT(thrown,
              HasSubstr("at rest in space, with the path of its centre of mass, an arrow from the origin to "
                        "where it is and an arrow for its velocity."));
  EXPECT_THAT(
      altText(sceneOf(top + "point=[1, 0, 0]\nvelocity=[3, 0, 4]\n")),
      HasSubstr("an arrow from the origin to the point by which it is thrown and an arrow for the velocity of "
                "this point."));
  const std::string drifts =
      altText(sceneOf(top + "velocity=[0, 3, 4]\ngravity=[0, 0, 0]\n[show]\nflight=false\n"));
  EXPECT_THAT(drifts, HasSubstr("Nothing acts on the body, so"));
  EXPECT_THAT(drifts, HasSubstr("Its centre of mass flies straight on at 5 m/s."));
  EXPECT_THAT(drifts, HasSubstr("at rest in space."));
}

TEST(AltText, DescribesGhostsVectorsReadoutsAndNotes) {
  const std::string text = altText(sceneOf(
      "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.5, 0, 2]\n[show]\nghosts = true\ntheta = "
      "true\n[[vector]]\nname = '$\\mathbf{r}$'\nposition_of = [1, 0, 0]\n[[readout]]\nquantity = \"omega\"\n"
      "[[readout]]\nquantity = \"t\"\n[[note]]\ntext = ['One line', '', 'and $E = T$']\n"));
  EXPECT_THAT(text, HasSubstr("the body, paler poses of it at other times and its principal axes e1, e2 and e3."));
  EXPECT_THAT(text, HasSubstr("Also shown: the angle θ between L and k and an arrow “r”."));
  EXPECT_THAT(text, HasSubstr("At the edge of the picture, |ω| and t are written in numbers."));
  EXPECT_THAT(text, HasSubstr("Written in the picture: “One line and E = T”."));
}

TEST(AltText, DescribesALossOfEnergy) {
  const scene::Scene scene = galleryScene("explorer_1");
  const json info = numbersOf(scene);
  const std::string text = altText(scene);
  EXPECT_THAT(text,
              HasSubstr("tends to a steady spin about an axis across e3, at " + rounded(info["final_omega"]) +
                        " rad/s, one turn in 9.55 s"));  // 60/6.28094923721 rpm
  EXPECT_THAT(text, HasSubstr("12.5 turns a second"));   // 750 rpm
}

TEST(AltText, DescribesASteadySpin) {
  for (const char* moments : {"[2, 2, 2]", "[1, 2, 3]", "[2, 2, 3]"}) {
    const std::string text = altText(
        sceneOf(std::string("[body]\nprincipal_moments = ") + moments + "\n[motion]\nomega_body = [0, 0, 2]\n"));
    EXPECT_THAT(text, HasSubstr("It spins steadily at 2 rad/s, one turn in 3.14 s")) << moments;
    EXPECT_THAT(text, Not(HasSubstr("wobble"))) << moments;
  }
}

TEST(AltText, NamesTheColoursInBothThemes) {
  const std::string start = "[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [1, 1, 1]\n";
  for (const char* theme : {"light", "dark"}) {
    const std::string text = altText(sceneOf(start + "[style]\ntheme = \"" + theme + "\"\n"));
    EXPECT_THAT(text, HasSubstr("In blue: an arrow for L")) << theme;
    EXPECT_THAT(text, HasSubstr("In orange-red: an arrow for ω")) << theme;
    EXPECT_THAT(text, HasSubstr("In orange: the energy ellipsoid")) << theme;
    EXPECT_THAT(text, HasSubstr("In green: the body")) << theme;
  }
}

/// Returns the absolute values of all numbers of the report and the film, in SI units.
std::vector<double> knownNumbers(const scene::Scene& scene, const json& info) {
  std::vector<double> numbers{scene.time.duration_s, scene.show.exaggerateAngles};
  const std::function<void(const json&)> collect = [&](const json& value) {
    if (value.is_number()) numbers.push_back(std::abs(value.get<double>()));
    if (value.is_structured())
      for (const json& element : value) collect(element);
  };
  collect(info);
  numbers.push_back(std::abs(info["motion_to"].get<double>() - info["motion_from"].get<double>()));
  numbers.push_back(numbers.back() / scene.time.duration_s);
  numbers.push_back(scene.motion.forcing.torque_B.norm());
  return numbers;
}

/// Returns the size in SI units of the unit with which `after` begins; 1 if there is no such unit.
double unitOf(const std::string& after) {
  const std::pair<const char*, double> units[] = {{"°", std::numbers::pi / 180},
                                                  {" ms", 1e-3},
                                                  {" minutes", 60},
                                                  {" hours", 3600},
                                                  {" days", 86400},
                                                  {" turns a second", 2 * std::numbers::pi}};
  for (const auto& [unit, size] : units)
    if (after.starts_with(unit)) return size;
  return 1;
}

/// Returns the exponent at the start of a text in raised digits.
int exponentOf(const std::string& raised) {
  const std::pair<const char*, char> digits[] = {{"⁰", '0'}, {"¹", '1'}, {"²", '2'}, {"³", '3'},
                                                 {"⁴", '4'}, {"⁵", '5'}, {"⁶", '6'}, {"⁷", '7'},
                                                 {"⁸", '8'}, {"⁹", '9'}, {"⁻", '-'}};
  std::string text;
  for (std::size_t at = 0; at < raised.size();) {
    const auto* digit = std::ranges::find_if(
        digits, [&](const auto& d) { return raised.compare(at, std::strlen(d.first), d.first) == 0; });
    if (digit == std::end(digits)) break;
    text += digit->second;
    at += std::strlen(digit->first);
  }
  return std::stoi(text);
}

struct SaidNumber {
  double value;
  std::string near;
};

/// Returns the numbers of a text in SI units, with the words near each. Skips everything before the moments of
/// inertia, because the report has neither title nor sizes.
std::vector<SaidNumber> saidNumbers(const std::string& text) {
  std::vector<SaidNumber> said;
  const std::string rest = text.substr(text.find(" of inertia "));
  const std::regex number(
      "(^|[ (])([0-9]+[.]?[0-9]*)( × 10((?:[^ 0-9.a-z\xC2]|\xC2[^\xB0])+))?");  // raised digits, not degrees
  for (std::sregex_iterator at(rest.begin(), rest.end(), number), end; at != end; ++at) {
    const std::string after = at->suffix().str().substr(0, 20);
    const double power = (*at)[3].matched ? std::pow(10.0, exponentOf((*at)[4])) : 1;
    said.push_back({std::stod((*at)[2]) * power * unitOf(after), at->str() + after});
  }
  return said;
}

/// Returns whether a value, to three digits, is a known number, the period of a known rate or the inverse of a
/// known pace.
bool isKnown(double value, const std::vector<double>& known) {
  return std::ranges::any_of(known, [&](double k) {
    const auto near = [&](double x) { return std::abs(x - value) <= 0.0051 * std::abs(value); };
    return near(k) || near(2 * std::numbers::pi / k) || near(1 / k);
  });
}

/// Removes the author's notes and the titles of panels, which may contain any number.
std::string withoutNotes(const std::string& text) {
  return std::regex_replace(text, std::regex("Written in the picture: “.*?”\\.|Panel [0-9]+, “.*?”"), "");
}

TEST(AltText, ContainsOnlyNumbersOfTheReport) {
  const std::regex counted("^ ?[0-9]+ (panels|swings|turns about).*| ?[0-9]+, “.*| ?2T/L.*");
  for (const std::string& name : galleryNames()) {
    const scene::Scene scene = galleryScene(name);
    const std::vector<double> known = knownNumbers(scene, numbersOf(scene));
    const auto said = saidNumbers(withoutNotes(altText(scene)));
    EXPECT_GE(said.size(), 5u) << name;
    for (const SaidNumber& number : said) {
      if (std::regex_match(number.near, counted)) continue;
      EXPECT_TRUE(isKnown(number.value, known)) << name << ": " << number.near;
    }
  }
}

TEST(AltText, IsPlainTextForEveryGalleryScene) {
  for (const std::string& name : galleryNames()) {
    SCOPED_TRACE(name);
    const std::string text = altText(galleryScene(name));
    EXPECT_GT(text.size(), 300u);
    EXPECT_EQ(text.find_first_of("\\$\n{}"), text.npos) << text;
    EXPECT_EQ(text.find("nan"), text.npos) << text;
    EXPECT_EQ(text.find("inf"), text.npos) << text;
    EXPECT_EQ(text.find("  "), text.npos) << text;
    EXPECT_EQ(text.back(), '.');
  }
}

}  // namespace
}  // namespace poinsot::describe
