// SPDX-License-Identifier: Apache-2.0
// Checks every picture of every film in scenes/ on its draw lists: no GL, no pixels. The rules are those of a
// page: type is apart and inside, everything is in its frame, and what stands still in space stands still in the
// picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "ink.h"
#include "scene_samples.h"
#include "support/gallery_scenes.h"

namespace poinsot::stage {
namespace {

using draw::DrawList;
using glm::vec2;
using glm::vec3;

constexpr glm::ivec2 kSize{1920, 1080};
constexpr int kInstants = 40;
constexpr float kSeen = 0.3f;  // type of lower opacity is fading out

template <class F>
std::vector<std::string> namesWhere(F holds) {
  std::vector<std::string> names = galleryNames();
  std::erase_if(names, [&](const std::string& name) { return !holds(galleryScene(name)); });
  return names;
}

bool looksCloser(const scene::Scene& scene) {
  return std::ranges::any_of(scene.views, [](const scene::View& view) { return view.camera.zoom > 1; }) ||
         std::ranges::any_of(scene.timeline.entries, [](const auto& entry) { return entry.zoom.has_value(); });
}
bool keepsLUpright(const scene::Scene& scene) {
  return (scene.motion.forcing.none() || scene.motion.forcing.dissipation > 0) && !scene.motion.flight;
}
bool showsConstructionAllTheTime(const scene::Scene& scene) {
  return scene.show.plane.visible && scene.show.ellipsoid.visible && scene.timeline.entries.empty();
}

class GalleryPictures : public testing::TestWithParam<std::string> {
 protected:
  Stage stage_{galleryScene(GetParam())};

  template <class F>
  void atEachInstant(F check) {
    for (int i = 0; i < kInstants; ++i) {
      const double t = stage_.scene().time.duration_s * i / kInstants;
      SCOPED_TRACE(testing::Message() << GetParam() << " at " << t << " s");
      check(stage_.compose(t, kSize));
    }
  }
};

struct SeenText {
  std::string tex;
  PixelBox ink, within;
};

std::vector<SeenText> textsOf(const draw::Picture& picture) {
  std::vector<SeenText> all;
  const PixelBox page{0, 0, static_cast<double>(picture.size_px.x), static_cast<double>(picture.size_px.y)};
  for (const draw::Text& text : picture.texts)
    if (text.opacity >= kSeen) all.push_back({text.tex, inkOf(text), page});
  for (const draw::Panel& panel : picture.panels) {
    const glm::dvec2 low(panel.origin_px), high = low + glm::dvec2(panel.list.camera.size_px);
    for (const draw::Text& text : panel.list.texts)
      if (text.opacity >= kSeen)
        all.push_back({text.tex, inkOf(text, panel.origin_px), {low.x, low.y, high.x, high.y}});
  }
  return all;
}

TEST_P(GalleryPictures, TextsAreInsideTheirPanelsAndDoNotOverlap) {
  atEachInstant([](const draw::Picture& picture) {
    const std::vector<SeenText> all = textsOf(picture);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto& [tex, ink, within] = all[i];
      EXPECT_TRUE(ink.left >= within.left && ink.top >= within.top && ink.right <= within.right &&
                  ink.bottom <= within.bottom)
          << tex << " leaves its panel";
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(near(ink, all[j].ink)) << tex << " lies on " << all[j].tex;
    }
  });
}

/// Returns points of the outermost surfaces and lines of a list.
std::vector<vec3> outermost_W(const DrawList& list) {
  std::vector<vec3> points;
  const auto addBox = [&](const vec3& centre, const glm::mat3& axes) {
    for (int corner = 0; corner < 8; ++corner)
      points.push_back(
          centre + axes * vec3(corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f));
  };
  const auto addBall = [&](const vec3& centre, const glm::mat3& axes) {
    for (int i = 0; i < 24; ++i)
      for (int k = 1; k < 12; ++k) {
        const float a = 0.2618f * static_cast<float>(i), b = 0.2618f * static_cast<float>(k);
        points.push_back(centre + axes * vec3(std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b)));
      }
  };
  for (const draw::Ellipsoid& e : list.ellipsoids) addBall(e.centre_V, e.semiAxes_V);
  for (const draw::GlassEllipsoid& e : list.glassEllipsoids) addBall(e.centre_V, e.semiAxes_V);
  for (const draw::Box& b : list.boxes) addBox(b.centre_V, b.halfAxes_V);
  for (const draw::Frustum& f : list.frustums) points.insert(points.end(), {f.from_V, f.to_V});
  for (const draw::Curve& c : list.curves) points.insert(points.end(), c.points_V.begin(), c.points_V.end());
  for (const draw::GlassPolygon& p : list.glassPolygons)
    points.insert(points.end(), p.corners_V.begin(), p.corners_V.end());
  for (const draw::Mesh& m : list.meshes)
    for (const vec3& p : m.mesh->vertices_M) points.push_back(m.origin_V + m.axes_V * p);
  for (const draw::GridPlane& p : list.planes)
    for (const float a : {-1.0f, 1.0f})
      for (const float b : {-1.0f, 1.0f}) points.push_back(p.centre_V + a * p.u_V + b * p.v_V);
  return points;
}

class WholePictures : public GalleryPictures {};

TEST_P(WholePictures, ShowEverythingInsideTheFrame) {
  atEachInstant([](const draw::Picture& picture) {
    for (const draw::Panel& panel : picture.panels) {
      const vec2 size = panel.list.camera.size_px;
      for (const vec3& p : outermost_W(panel.list)) {
        const vec2 q = project(panel.list.camera, p);
        ASSERT_TRUE(q.x >= 0 && q.y >= 0 && q.x <= size.x && q.y <= size.y)
            << p.x << ", " << p.y << ", " << p.z << " at " << q.x << ", " << q.y;
      }
    }
  });
}

struct Shaft {
  vec2 foot_px, tip_px;
};

std::optional<Shaft> shaftOfL(const DrawList& list, const draw::Color& color) {
  for (const draw::Frustum& f : list.frustums)
    if (f.material.color == color && f.toRadius == 0)
      return Shaft{project(list.camera, vec3(0)), project(list.camera, f.to_V)};
  return {};
}

class PicturesOfL : public GalleryPictures {};

// L stands still in space, and points up or down the page here.
TEST_P(PicturesOfL, LIsUprightAndFixedInSpace) {
  const scene::Scene& scene = stage_.scene();
  const draw::Color blue = palette(scene.style).L;
  std::vector<std::optional<Shaft>> first(scene.views.size());
  const bool moves = !scene.timeline.entries.empty() || scene.camera.orbit_rad != 0;
  atEachInstant([&](const draw::Picture& picture) {
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
      if (scene.views[i].camera.frame == scene::CameraFrame::kBody) continue;
      const auto shaft = shaftOfL(picture.panels.at(i).list, blue);
      if (!shaft) continue;
      EXPECT_NEAR(shaft->foot_px.x, shaft->tip_px.x, 0.5);
      if (first[i] && !moves) {
        EXPECT_LT(glm::distance(shaft->tip_px, first[i]->tip_px), 0.5f);
      }
      first[i] = first[i] ? first[i] : shaft;
    }
  });
}

class ConstructionPictures : public GalleryPictures {};

/// The plane touches the ellipsoid at the tip of omega, which lies on both.
TEST_P(ConstructionPictures, TheContactPointIsOnThePlaneAndTheEllipsoid) {
  const draw::Color red = palette(stage_.scene().style).omega;
  atEachInstant([&](const draw::Picture& picture) {
    const DrawList& list = picture.panels.at(0).list;
    ASSERT_FALSE(list.planes.empty() || list.glassEllipsoids.empty());
    const auto tip = std::ranges::find_if(
        list.frustums, [&](const draw::Frustum& f) { return f.material.color == red && f.toRadius == 0; });
    ASSERT_NE(tip, list.frustums.end());
    const draw::GridPlane& plane = list.planes[0];
    EXPECT_NEAR(glm::dot(tip->to_V - plane.centre_V, glm::normalize(glm::cross(plane.u_V, plane.v_V))), 0, 1e-6);
    EXPECT_NEAR(glm::length(glm::inverse(list.glassEllipsoids[0].semiAxes_V) * tip->to_V), 1, 2e-6);
  });
}

/// Returns points of the outline of an arrow's head: on its axis, and left and right of the axis in the picture.
std::vector<vec2> outlineOf(const draw::Frustum& head, const draw::Camera& camera) {
  std::vector<vec2> points;
  for (int i = 0; i <= 10; ++i) {
    const float share = 0.1f * static_cast<float>(i);
    const vec3 middle_W = head.from_V + share * (head.to_V - head.from_V);
    const float radius_px = (1 - share) * head.fromRadius * camera.scale_px(depthOf(camera, middle_W));
    for (const float side : {-1.0f, 0.0f, 1.0f})
      points.push_back(project(camera, middle_W) + vec2(side * radius_px, 0));
  }
  return points;
}

TEST_P(ConstructionPictures, TheLabelOfOmegaIsClearOfTheArrowHead) {
  const draw::Color red = palette(stage_.scene().style).omega;
  atEachInstant([&](const draw::Picture& picture) {
    const DrawList& list = picture.panels.at(0).list;
    const auto head = std::ranges::find_if(
        list.frustums, [&](const draw::Frustum& f) { return f.material.color == red && f.toRadius == 0; });
    const auto name =
        std::ranges::find(list.texts, stage_.scene().labels[scene::LabelName::kOmega], &draw::Text::tex);
    ASSERT_TRUE(head != list.frustums.end() && name != list.texts.end());
    const PixelBox ink = inkOf(*name);
    for (const vec2& p : outlineOf(*head, list.camera)) {
      const glm::dvec2 q(p);
      EXPECT_FALSE(q.x > ink.left && q.x < ink.right && q.y > ink.top && q.y < ink.bottom);
    }
  });
}

std::string nameOf(const testing::TestParamInfo<std::string>& name) { return name.param; }

INSTANTIATE_TEST_SUITE_P(Scenes, GalleryPictures, testing::ValuesIn(namesWhere([](const auto&) { return true; })),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, WholePictures, testing::ValuesIn(namesWhere(std::not_fn(looksCloser))), nameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, PicturesOfL, testing::ValuesIn(namesWhere(keepsLUpright)), nameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, ConstructionPictures, testing::ValuesIn(namesWhere(showsConstructionAllTheTime)),
                         nameOf);

}  // namespace
}  // namespace poinsot::stage
