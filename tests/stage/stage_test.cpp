// SPDX-License-Identifier: Apache-2.0
// Contents of a picture, checked on the draw list: no GL, no pixels.
#include "stage/stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <numbers>

#include "core/error.h"
#include "scene_samples.h"

namespace poinsot::stage {
namespace {

using draw::DrawList;
using glm::vec2;
using glm::vec3;

constexpr glm::ivec2 kSize{960, 540};
const double kTimes[] = {0, 0.7, 3.3, 5, 9.9};

// Returns the point of contact, which is the only solid ellipsoid of these scenes.
vec3 contact(const DrawList& list) { return list.ellipsoids.at(0).centre_V; }

TEST(Stage, ContactPointLiesOnThePlaneAndOnTheEllipsoid) {
  const Stage stage(sample());
  for (const double t : kTimes) {
    const DrawList list = onlyList(stage, t, kSize);
    const auto& plane = list.planes.at(0);
    const vec3 normal = glm::normalize(glm::cross(plane.u_V, plane.v_V));
    EXPECT_NEAR(glm::dot(contact(list) - plane.centre_V, normal), 0, 2e-7) << t;  // measured 6e-8: one float
    const vec3 onSphere = glm::inverse(list.glassEllipsoids.at(0).semiAxes_V) * contact(list);
    EXPECT_NEAR(glm::length(onSphere), 1, 1e-6) << t;  // measured 2e-7
  }
}

// L is normal to the ellipsoid at the point of contact (eq 39), so that the plane touches there and nowhere else.
TEST(Stage, ThePlaneIsTangentToTheEllipsoid) {
  const Stage stage(sample());
  for (const double t : kTimes) {
    const DrawList list = onlyList(stage, t, kSize);
    const glm::mat3 A = list.glassEllipsoids.at(0).semiAxes_V;
    const glm::mat3 toSphere = glm::inverse(A);
    const vec3 normal = glm::normalize(glm::transpose(toSphere) * (toSphere * contact(list)));
    EXPECT_NEAR(normal.z, -1, 1e-6) << t;
  }
}

TEST(Stage, LPointsStraightDownWhereThePlaneIsShownAndUpElsewhere) {
  const auto direction = [](const DrawList& list) {
    // The arrow of L is the only frustum of its colour.
    for (const auto& f : list.frustums)
      if (f.material.color == palette(scene::Theme::kLight).L) return glm::normalize(f.to_V - f.from_V);
    return vec3(0);
  };
  EXPECT_NEAR(direction(onlyList(Stage(sample()), 2, kSize)).z, -1, 1e-6);
  EXPECT_NEAR(direction(onlyList(Stage(sample("[show]\nplane = false\n")), 2, kSize)).z, 1, 1e-6);
  EXPECT_NEAR(direction(onlyList(Stage(sample("L_points = \"up\"\n")), 2, kSize)).z, 1, 1e-6);
}

TEST(Stage, TheArrowOfOmegaEndsAtThePointOfContact) {
  const Stage stage(sample());
  for (const double t : kTimes) {
    const DrawList list = onlyList(stage, t, kSize);
    float nearest = 1;
    for (const auto& f : list.frustums) nearest = std::min(nearest, glm::distance(f.to_V, contact(list)));
    EXPECT_LT(nearest, 1e-6);
  }
}

TEST(Stage, APictureDependsOnlyOnItsTime) {
  const Stage stage(sample());
  const DrawList first = onlyList(stage, 4, kSize);
  onlyList(stage, 9, kSize);
  const DrawList again = onlyList(stage, 4, kSize);
  EXPECT_EQ(first.glassEllipsoids[0].semiAxes_V, again.glassEllipsoids[0].semiAxes_V);
  ASSERT_EQ(first.curves.size(), again.curves.size());
  for (std::size_t i = 0; i < first.curves.size(); ++i)
    EXPECT_EQ(first.curves[i].points_V, again.curves[i].points_V);
  ASSERT_EQ(first.texts.size(), again.texts.size());
  for (std::size_t i = 0; i < first.texts.size(); ++i)
    EXPECT_EQ(first.texts[i].baseline_px, again.texts[i].baseline_px);
}

TEST(Stage, TheCameraIsFixed) {
  const Stage stage(sample());
  const auto camera = onlyList(stage, 0, kSize).camera;
  for (const double t : kTimes) {
    EXPECT_EQ(onlyList(stage, t, kSize).camera.eye_V, camera.eye_V);
    EXPECT_EQ(onlyList(stage, t, kSize).camera.R_VC, camera.R_VC);
  }
}

bool insideFrame(const DrawList& list, vec3 p) {
  const vec2 q = project(list.camera, p);
  return q.x >= 0 && q.y >= 0 && q.x <= kSize.x && q.y <= kSize.y;
}

TEST(Stage, EverythingIsInsideTheFrameAllTheTime) {
  for (const char* extra : {"", "[show]\nplane = false\nellipsoid = false\n", "[camera]\nframe = \"body\"\n"}) {
    const Stage stage(sample(extra));
    for (double t = 0; t < 10; t += 0.5) {
      const DrawList list = onlyList(stage, t, kSize);
      for (const auto& f : list.frustums) EXPECT_TRUE(insideFrame(list, f.to_V)) << extra << " at " << t;
      for (const auto& c : list.curves)
        for (const vec3& p : c.points_V) ASSERT_TRUE(insideFrame(list, p)) << extra << " at " << t;
      for (const auto& p : list.planes)
        for (const float a : {-1.0f, 1.0f})
          for (const float b : {-1.0f, 1.0f})
            EXPECT_TRUE(insideFrame(list, p.centre_V + a * p.u_V + b * p.v_V)) << extra << " at " << t;
      for (const auto& e : list.glassEllipsoids)
        for (int i = 0; i < 3; ++i)
          for (const float s : {-1.0f, 1.0f})
            EXPECT_TRUE(insideFrame(list, s * e.semiAxes_V[i])) << extra << " at " << t;
    }
  }
}

// The same motion in other units gives the same picture: moments a million times larger, time ten times slower.
TEST(Stage, UnitsDoNotChangeThePicture) {
  const auto scaled = scene::parseScene(
      "[body]\nprincipal_moments = [2e6, 3e6, 4e6]\n[motion]\nomega_body = [0.1, 0.05, 0.16]\n[time]\nspeed = "
      "10\n",
      "scaled.toml");
  const DrawList a = onlyList(Stage(sample("[time]\nspeed = 1\n")), 3, kSize),
                 b = onlyList(Stage(scaled), 3, kSize);
  EXPECT_LT(glm::distance(contact(a), contact(b)), 1e-6f);
  EXPECT_LT(glm::distance(a.camera.eye_V, b.camera.eye_V), 1e-5f);
  ASSERT_EQ(a.boxes.size(), 1u);
  for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(a.boxes[0].halfAxes_V[i], b.boxes[0].halfAxes_V[i]), 1e-6f);
}

TEST(Stage, AutomaticSpeedIsOneUnlessTheMotionIsTooSlow) {
  EXPECT_EQ(Stage(sample()).speed(), 1);
  const auto earth = scene::parseScene(
      "[body]\nprincipal_moments = [8.0e37, 8.0e37, 8.03e37]\n[motion]\nomega_body = [1e-10, 0, 7.3e-5]\n",
      "e.toml");
  EXPECT_NEAR(Stage(earth).speed() * 7.3e-5, 2.1, 1e-3);
}

TEST(Stage, TheBodyIsFixedInTheBodyFrame) {
  const Stage stage(sample("[camera]\nframe = \"body\"\n"));
  const glm::mat3 start = onlyList(stage, 0, kSize).boxes.at(0).halfAxes_V;
  for (const double t : kTimes) {
    const glm::mat3 now = onlyList(stage, t, kSize).boxes.at(0).halfAxes_V;
    for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(start[i], now[i]), 1e-6f) << t;
  }
}

TEST(Stage, ExaggerationIsDrawnAndStatedInThePicture) {
  const std::string wobble =
      "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.001, 0, 1]\n[show]\nexaggerate_angles = "
      "100\n"
      "plane = false\n";
  const draw::Picture picture = Stage(scene::parseScene(wobble, "w.toml")).compose(0, kSize);
  const DrawList& list = picture.panels.at(0).list;
  bool said = false;
  for (const auto& text : picture.texts) said |= text.tex.find("100 times larger") != std::string::npos;
  EXPECT_TRUE(said);
  // The drawn omega is (0.1, 0, 1); the third column of the body's axes is e3.
  const vec3 axis = glm::normalize(list.boxes.at(0).halfAxes_V[2]);
  const float cosine = glm::dot(glm::normalize(contact(list)), axis);
  EXPECT_NEAR(std::acos(cosine), std::atan(0.1), 1e-4);
}

TEST(Stage, ExaggerationIntoAnotherKindOfMotionIsRefused) {
  // Ten times the transverse part of (0.3, 0, 1) would be larger than the part along the axis.
  const auto scene = scene::parseScene(
      "[body]\nprincipal_moments = [2, 2, 3]\n[motion]\nomega_body = [0.3, 0, 1]\n[show]\nexaggerate_angles = "
      "10\n",
      "e.toml");
  EXPECT_THROW(Stage{scene}, core::Error);
}

// A film lasts an hour at a turn a second: the curves show the turns around the present, and stay smooth. Edges of
// the body are curves of few points.
TEST(Stage, LongFilmsDrawOnlyTheTurnsAroundThePresent) {
  const Stage stage(sample("[time]\nduration = 3600\nfps = 10\nspeed = 3\n"));
  for (const auto& curve : onlyList(stage, 1800, kSize).curves)
    for (std::size_t i = 0; i + 1 < curve.points_V.size(); ++i)
      ASSERT_LT(glm::distance(curve.points_V[i], curve.points_V[i + 1]), curve.points_V.size() > 8 ? 0.1f : 10.0f);
}

// Labels glide from frame to frame. The fastest are the labels of the racket's axes, which swing by 8 degrees a
// frame.
TEST(Stage, LabelsDoNotJumpInAnyFilmOfTheGallery) {
  for (const char* name : {"tennis_racket", "poinsot_rolling", "football", "chandler_wobble"}) {
    const Stage stage(scene::loadScene(std::string(POINSOT_SOURCE_DIR "/scenes/") + name + ".toml"));
    std::map<std::string, draw::Text> before;
    for (int k = 0; k < 360; ++k) {
      std::map<std::string, draw::Text> now;
      for (const auto& text : onlyList(stage, k / 30.0, kSize).texts) {
        now[text.tex] = text;
        // A label that changes places fades from one to the other.
        if (!before.count(text.tex) || std::min(text.opacity, before[text.tex].opacity) < 0.4f) continue;
        const float most = text.tex.find("omega") != std::string::npos ? 0.04f : 0.12f;
        const float step = glm::distance(before[text.tex].baseline_px, text.baseline_px) / kSize.y;
        EXPECT_LT(step, most) << name << " frame " << k << " " << text.tex;
      }
      before = now;
    }
  }
}

// In a film, a label may be faint for a while, on its way to another place or behind the body. A still has no such
// half-tones.
TEST(Stage, LabelsOfAStillAreOpaqueOrAbsent) {
  int faint = 0, hidden = 0;
  for (const char* name : {"tennis_racket", "poinsot_rolling", "football"}) {
    const Stage stage(scene::loadScene(std::string(POINSOT_SOURCE_DIR "/scenes/") + name + ".toml"));
    for (double t_s = 0; t_s < 12; t_s += 0.05) {
      std::map<std::string, float> film, still;
      for (const auto& text : onlyList(stage, t_s, kSize).texts) film[text.tex] = text.opacity;
      for (const auto& text : onlyList(stage, {t_s, true}, kSize).texts) still[text.tex] = text.opacity;
      for (const auto& [tex, opacity] : film) {
        const bool omega = tex.find("omega") != std::string::npos;  // omega is never hidden
        faint += omega && opacity < 0.9f;
        hidden += !omega && opacity < 0.5f;
        ASSERT_EQ(still.count(tex), omega || opacity >= 0.5f)
            << name << " " << t_s << " " << tex << " " << opacity;
        ASSERT_TRUE(still.count(tex) == 0 || still[tex] == 1) << name << " " << t_s << " " << tex;
      }
    }
  }
  EXPECT_GT(faint, 0);
  EXPECT_GT(hidden, 0);
}

TEST(Stage, HidingLabelsChangesNothingElse) {
  for (const char* name : {"tennis_racket", "poinsot_rolling", "football", "thrown_baton"}) {
    const std::string file = std::string(POINSOT_SOURCE_DIR "/scenes/") + name + ".toml";
    const Stage with(scene::loadScene(file)), without(scene::loadScene(file, {"show.labels=false"}));
    for (const double time_s : kTimes) {
      const double t = std::min(time_s, with.scene().time.duration_s);
      const DrawList bare = onlyList(without, t, kSize);
      EXPECT_TRUE(bare.texts.empty()) << name;
      EXPECT_EQ(bare.frustums.size(), onlyList(with, t, kSize).frustums.size()) << name;
    }
  }
}

TEST(Stage, HiddenObjectsAreNotDrawn) {
  const DrawList list =
      onlyList(Stage(sample("[show]\nbody = false\nprincipal_axes = false\nL = false\nomega = false\n"
                            "ellipsoid = false\nplane = false\npolhode = false\nherpolhode = false\n"
                            "contact = false\nheight = false\nlabels = false\n")),
               1, kSize);
  EXPECT_TRUE(list.boxes.empty() && list.frustums.empty() && list.curves.empty() && list.ellipsoids.empty());
  EXPECT_TRUE(list.glassEllipsoids.empty() && list.planes.empty() && list.texts.empty());
}

// Half-way through the film, the travelled part of the herpolhode ends at the point of contact, and the faint part
// begins there.
TEST(Stage, TheHerpolhodeIsSplitAtTheContactPoint) {
  const DrawList list = onlyList(Stage(sample()), 5, kSize);
  int ends = 0, starts = 0;
  for (const auto& c : list.curves) {
    if (c.radius_V > 0 || c.points_V.empty()) continue;
    ends += glm::distance(c.points_V.back(), contact(list)) < 1e-6f;
    starts += glm::distance(c.points_V.front(), contact(list)) < 1e-6f;
  }
  EXPECT_EQ(ends, 1);
  EXPECT_EQ(starts, 1);
}

}  // namespace
}  // namespace poinsot::stage
