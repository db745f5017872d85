// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/text.h"
#include "describe/alt_sections.h"
#include "describe/language.h"
#include "draw/color.h"
#include "scene/state_quantity.h"
#include "stage/palette.h"
#include "stage/picture_motion.h"
#include "text/math_setter.h"

namespace poinsot::describe {
namespace {

/// Returns the hue of an sRGB colour in degrees; red is 0.
double hueOf(double r, double g, double b, double chroma) {
  const double most = std::max({r, g, b});
  if (most == r) return 60 * ((g - b) / chroma + (g < b ? 6 : 0));
  return most == g ? 60 * ((b - r) / chroma + 2) : 60 * ((r - g) / chroma + 4);
}

const char* greyName(double value) {
  if (value < 0.3) return "black";
  return value > 0.9 ? "white" : "grey";
}

const char* hueName(double hue) {
  constexpr struct {
    double below;
    const char* name;
  } kHues[] = {{12, "red"},    {33, "orange-red"}, {50, "orange"}, {75, "yellow"},
               {170, "green"}, {190, "cyan"},      {255, "blue"},  {330, "purple"}};
  for (const auto& hue_ : kHues)
    if (hue < hue_.below) return hue_.name;
  return "red";
}

const char* colorName(const draw::Color& color) {
  const auto srgb = [](float linear) { return draw::srgb8FromLinear(linear) / 255.0; };
  const double r = srgb(color.x), g = srgb(color.y), b = srgb(color.z);
  const double most = std::max({r, g, b}), chroma = most - std::min({r, g, b});
  return chroma < 0.2 * most || most < 0.15 ? greyName(most) : hueName(hueOf(r, g, b, chroma));
}

/// Colour, and a list in words of the things that are drawn in this colour.
struct Family {
  draw::Color color;
  std::string things;
};

using Seen = std::function<bool(const scene::Show&)>;

struct Thing {
  const char* words;
  Seen seen;
};

const std::vector<Thing>& thingsOfL() {
  static const std::vector<Thing> things{
      {"an arrow for L", [](const scene::Show& s) { return s.L.visible; }},
      {"the invariable plane at right angles to it", [](const scene::Show& s) { return s.plane.visible; }},
      {"the plane through L and ω", [](const scene::Show& s) { return s.figures.planeOfL.visible; }},
      {"the two parts of L, head to tail", [](const scene::Show& s) { return s.figures.LParts.visible; }},
      {"the height 2T/L of the centre", [](const scene::Show& s) { return s.plane.visible && s.height.visible; }},
      {"the space cone, which ω traces around L", [](const scene::Show& s) { return s.figures.cones.visible; }},
      {"the angular momentum about the origin, with R × P and L as its parts",
       [](const scene::Show& s) { return s.figures.totalL.visible; }},
      {"the sphere on which the tip of L stays", [](const scene::Show& s) { return s.figures.binet.visible; }}};
  return things;
}

const std::vector<Thing>& thingsOfOmega() {
  static const std::vector<Thing> things{
      {"an arrow for ω", [](const scene::Show& s) { return s.omega.visible; }},
      {"the polhode on the body", [](const scene::Show& s) { return s.polhode.visible; }},
      {"the herpolhode in space", [](const scene::Show& s) { return s.herpolhode.visible; }},
      {"polhodes of other starts, with the separatrix",
       [](const scene::Show& s) { return s.figures.polhodes.visible; }},
      {"the area on the sphere that the polhode encloses",
       [](const scene::Show& s) { return s.figures.binet.visible && s.figures.binet.area; }}};
  return things;
}

const std::vector<Thing>& thingsOfEnergy() {
  static const std::vector<Thing> things{
      {"the energy ellipsoid",
       [](const scene::Show& s) { return s.ellipsoid.visible || s.figures.binet.visible; }},
      {"the parts of ω, as a parallelogram", [](const scene::Show& s) { return s.figures.decomposition.visible; }},
      {"the parts of ω along i and k",
       [](const scene::Show& s) { return s.figures.triad.visible && s.figures.triad.components; }},
      {"the components of ω along the principal axes",
       [](const scene::Show& s) { return s.figures.components.visible; }}};
  return things;
}

const std::vector<Thing>& thingsOfBody() {
  static const std::vector<Thing> things{
      {"the body", [](const scene::Show& s) { return s.body.visible; }},
      {"paler poses of it at other times", [](const scene::Show& s) { return s.figures.ghosts.visible; }},
      {"its principal axes e1, e2 and e3",
       [](const scene::Show& s) { return s.principalAxes.visible && s.principalAxes.axes.size() == 3; }},
      {"some of its principal axes",
       [](const scene::Show& s) { return s.principalAxes.visible && s.principalAxes.axes.size() < 3; }},
      {"the main axis k", [](const scene::Show& s) { return s.figures.mainAxis.visible; }},
      {"the body cone about it", [](const scene::Show& s) { return s.figures.cones.visible; }},
      {"the axes i, j and k, with i in the plane of L and k",
       [](const scene::Show& s) { return s.figures.triad.visible; }},
      {"the path of a point of the body", [](const scene::Show& s) { return s.figures.trace.visible; }}};
  return things;
}

std::vector<std::string> shown(const std::vector<Thing>& things, const std::vector<scene::View>& views) {
  std::vector<std::string> words;
  for (const Thing& thing : things)
    if (std::ranges::any_of(views, [&](const scene::View& view) { return thing.seen(view.show); }))
      words.push_back(say(thing.words));
  return words;
}

std::string shownWords(const std::vector<Thing>& things, const std::vector<scene::View>& views) {
  return listWords(shown(things, views));
}

Sentences colorSentences(const scene::Scene& scene) {
  const stage::Palette colors = stage::palette(scene.style.theme);
  const Family families[] = {{colors.L, shownWords(thingsOfL(), scene.views)},
                             {colors.omega, shownWords(thingsOfOmega(), scene.views)},
                             {colors.ellipsoid, shownWords(thingsOfEnergy(), scene.views)},
                             {colors.body, shownWords(thingsOfBody(), scene.views)}};
  Sentences sentences;
  for (const Family& family : families)
    if (!family.things.empty())
      sentences.push_back(say("In {}: {}.", say(colorName(family.color)), family.things));
  return sentences;
}

/// Lists the drawn things that belong to no colour family, and the things for which the scene chose a colour.
std::string otherWords(const scene::Scene& scene) {
  static const std::vector<Thing> things{
      {"an arrow for the torque", [](const scene::Show& s) { return s.figures.torque.visible; }},
      {"the axes x, y and z of space", [](const scene::Show& s) { return s.figures.spaceAxes.visible; }}};
  static const Thing forces{"an arrow for each force at its point of the body, while it acts",
                            [](const scene::Show& s) { return s.figures.forces.visible; }};
  static const Thing arms{"an arrow r to it from the point that the body turns about",
                          [](const scene::Show& s) { return s.figures.forces.visible && s.figures.forces.arms; }};
  std::vector<std::string> words = shown(things, scene.views);
  if (!scene.motion.forcing.forces.empty())
    for (const std::string& arrows : shown({forces, arms}, scene.views)) words.push_back(arrows);
  const Thing table{"the table on which it rolls",
                    [&](const scene::Show& s) { return scene.motion.rolling && s.figures.table.visible; }};
  for (const std::string& word : shown({table}, scene.views)) words.push_back(word);
  const bool gravity = !scene.motion.forcing.gravity_B.isZero(0) || scene.motion.rolling;
  const Thing theta{gravity ? "the angle θ between k and the vertical" : "the angle θ between L and k",
                    [](const scene::Show& s) { return s.figures.theta.visible; }};
  for (const std::string& angle : shown({theta}, scene.views)) words.push_back(angle);
  const auto add = [&](const char* what, const std::string& tex) {
    const std::string name = text::setTex(tex).plainText;
    words.push_back(name.empty() ? say(what) : say("{} “{}”", say(what), name));
  };
  for (const scene::NamedVector& vector : scene.vectors) add("an arrow", vector.name);
  for (const scene::NamedAngle& angle : scene.angles) add("an angle", angle.name);
  return listWords(words);
}

const char* observerWords(scene::CameraFrame frame) {
  switch (frame) {
    case scene::CameraFrame::kSpace:
      return "as it looks to an observer at rest in space";
    case scene::CameraFrame::kBody:
      return "as it looks to an observer who rides on the body, which stands still while space turns about it";
    case scene::CameraFrame::kPrecession:
      return "as it looks to an observer who goes round L with the axis, so that L, ω and the axis stand still";
  }
  return "";
}

std::string headingWords(const scene::View& view) {
  const std::string title = text::setTex(view.title).plainText, below = text::setTex(view.subtitle).plainText;
  if (title.empty() || below.empty()) return title + below;
  return title + ": " + below;
}

/// Returns ", with the path of its centre of mass, ..." if a thrown body moves through the view. Returns an empty
/// string if the view moves with the body.
std::string flightWords(const scene::Scene& scene, const scene::View& view) {
  if (!scene::movesAlong(scene.motion, view.camera, view.show)) return "";
  std::vector<std::string> things{say("the path of its centre of mass")};
  const auto& flight = view.show.figures.flight;
  const bool byPoint = scene.motion.thrownBy_B.has_value();  // R and V are those of the point
  if (flight.position)
    things.push_back(say(byPoint ? "an arrow from the origin to the point by which it is thrown"
                                 : "an arrow from the origin to where it is"));
  if (flight.velocity)
    things.push_back(say(byPoint ? "an arrow for the velocity of this point" : "an arrow for its velocity"));
  if (flight.weight) things.push_back(say("an arrow for its weight"));
  return say(", with {}", listWords(things));
}

Sentences viewSentences(const scene::Scene& scene) {
  const auto words = [&](const scene::View& view) {
    return say(observerWords(view.camera.frame)) + flightWords(scene, view);
  };
  if (scene.views.size() == 1) return {say("The picture shows the motion {}.", words(scene.views.front()))};
  Sentences sentences{say("The picture has {} panels, all at the same instant.", scene.views.size())};
  for (std::size_t i = 0; i < scene.views.size(); ++i) {
    const std::string heading = headingWords(scene.views[i]);
    sentences.push_back(
        say("Panel {}{}: {}.", i + 1, heading.empty() ? "" : say(", “{}”", heading), words(scene.views[i])));
  }
  return sentences;
}

std::string quantityWords(const scene::Scene& scene, const std::vector<int>& quantities) {
  std::string words;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const std::string between = i == 0 ? "" : i + 1 == quantities.size() ? say(" and ") : ", ";
    words += between + text::setTex("$" + scene::quantityTex(quantities[i], scene.motion.forcing) + "$").plainText;
  }
  return words;
}

std::string plotSentence(const scene::Scene& scene, const scene::Plot& plot) {
  const std::string across = plot.x                                ? quantityWords(scene, {*plot.x})
                             : plot.time == scene::PlotTime::kFilm ? say("the time of the film")
                                                                   : say("time");
  const std::string title = text::setTex(plot.title).plainText;
  return say("A plot{} shows {} against {}, with a cursor at the instant of the picture.",
             title.empty() ? "" : say(", “{}”,", title), quantityWords(scene, plot.quantities), across);
}

std::string readoutSentence(const scene::Scene& scene) {
  std::vector<int> quantities;
  for (const scene::Readout& readout : scene.readouts) quantities.push_back(readout.quantity);
  return say("At the edge of the picture, {} written in numbers.",
             quantityWords(scene, quantities) + say(quantities.size() == 1 ? " is" : " are"));
}

std::string noteSentence(const scene::Note& note) {
  std::vector<std::string> lines;
  for (const std::string& line : note.lines)
    if (!line.empty()) lines.push_back(text::setTex(line).plainText);
  return say("Written in the picture: “{}”.", core::joined(lines, " "));
}

std::string exaggerationSentence(double factor) {
  return say(
      "The angles between ω, L and the axis are drawn as if the part of ω across the axis were {} times larger.",
      numberWords(factor));
}

/// Returns words for the ratio of motion time to film time, such as "at 0.7 of the true pace".
std::string paceWords(double pace) {
  if (pace == 1) return say("at the true pace");
  if (pace > 1) return say("{} times faster than in reality", numberWords(pace));
  return pace < 0.5 ? say("{} times slower than in reality", numberWords(1 / pace))
                    : say("at {} of the true pace", numberWords(pace));
}

std::string filmSentence(const scene::Scene& scene) {
  const scene::FilmClock clock = stage::filmClock(scene);
  const double speed = clock.speed(), length_s = scene.time.duration_s;
  const double shown_s = std::abs(speed) * clock.played_s(length_s);
  const std::string length = timeWords(length_s);
  if (speed == 0) return say("The film lasts {}; the motion stands still.", length);
  return say("The film lasts {} and shows {} of motion{}, {}{}.", length, timeWords(shown_s),
             speed < 0 ? say(" backwards") : "",
             clock.changes() ? say("at a pace that changes") : paceWords(std::abs(speed)),
             scene.time.loop ? say("; then it repeats without a jump") : "");
}

}  // namespace

Sentences pictureSentences(const scene::Scene& scene) {
  Sentences sentences = viewSentences(scene);
  for (const std::string& sentence : colorSentences(scene)) sentences.push_back(sentence);
  if (const std::string others = otherWords(scene); !others.empty())
    sentences.push_back(say("Also shown: {}.", others));
  for (const scene::Plot& plot : scene.plots) sentences.push_back(plotSentence(scene, plot));
  if (!scene.readouts.empty()) sentences.push_back(readoutSentence(scene));
  for (const scene::Note& note : scene.notes) sentences.push_back(noteSentence(note));
  if (scene.show.exaggerateAngles > 1) sentences.push_back(exaggerationSentence(scene.show.exaggerateAngles));
  sentences.push_back(filmSentence(scene));
  return sentences;
}

}  // namespace poinsot::describe
