// SPDX-License-Identifier: Apache-2.0
// Things that come and go: their presence over a film, and its effect on the draw list.
#include "stage/figures/presence.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene_samples.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {
namespace {

constexpr glm::ivec2 kSize(480, 270);

scene::Scene shownFrom(const std::string& thing, const std::string& more = "") {
  return sample("[[timeline]]\nat = 4\nover = 2\nshow = [\"" + thing + "\"]\n" + more);
}

TEST(PresencePlan, AlwaysShowsObjectsWithoutEntries) {
  const PresencePlan none({});
  EXPECT_EQ(none.at("plane", 3), 1);
  const PresencePlan other(shownFrom("plane").timeline);
  EXPECT_EQ(other.at("ellipsoid", 0), 1);
  EXPECT_EQ(other.at("no such thing", 0), 1);
}

TEST(PresencePlan, FadesInAnObjectThatIsShownLater) {
  const PresencePlan plan(shownFrom("plane").timeline);
  EXPECT_EQ(plan.at("plane", 0), 0);
  EXPECT_EQ(plan.at("plane", 4), 0);
  EXPECT_DOUBLE_EQ(plan.at("plane", 5), 0.5);
  EXPECT_EQ(plan.at("plane", 6), 1);
  EXPECT_EQ(plan.at("plane", 9), 1);
}

TEST(PresencePlan, FadesOutAnObjectThatIsHiddenLater) {
  const PresencePlan plan(
      sample("[[timeline]]\nat = 3\nhide = [\"body\"]\n[[timeline]]\nat = 6\nshow = [\"body\"]\n").timeline);
  EXPECT_EQ(plan.at("body", 0), 1);
  EXPECT_EQ(plan.at("body", 5), 0);
  EXPECT_EQ(plan.at("body", 7), 1);
}

// ---- the draw list

draw::Curve line(const std::vector<glm::vec3>& points_W, float width_px) {
  draw::Curve curve;
  curve.points_V = points_W;
  curve.width_px = width_px;
  return curve;
}

/// Draw list and labels to which each call of add() adds one thing of every kind.
struct Sample {
  draw::DrawList list;
  std::vector<Label> labels;

  void add() {
    list.ellipsoids.emplace_back().centre_V = {2, 0, 0};
    draw::Frustum& frustum = list.frustums.emplace_back();
    frustum.to_V = {0, 0, 2};
    frustum.fromRadius = 0.5f;
    frustum.toRadius = 0.25f;
    list.boxes.push_back({});
    list.meshes.push_back({});
    list.curves.push_back(line({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, 2));
    list.curves.push_back(line({{0, 0, 0}, {0, 0, 1}}, 4));
    list.glassEllipsoids.emplace_back().graticule = draw::Graticule();
    list.glassCones.push_back({});
    list.glassPolygons.push_back({});
    list.planes.push_back({});
    labels.push_back({});
  }
};

TEST(DrawMark, LeavesEarlierObjectsUnchanged) {
  Sample faded, whole;
  faded.add();
  whole.add();
  const DrawMark mark(faded.list, faded.labels);
  faded.add();
  mark.fade(faded.list, faded.labels, {0, 0, 0}, 0.5);
  EXPECT_EQ(faded.list.ellipsoids[0].centre_V, whole.list.ellipsoids[0].centre_V);
  EXPECT_EQ(faded.list.frustums[0].to_V, whole.list.frustums[0].to_V);
  EXPECT_EQ(faded.list.boxes[0].halfAxes_V, whole.list.boxes[0].halfAxes_V);
  EXPECT_EQ(faded.list.meshes[0].axes_V, whole.list.meshes[0].axes_V);
  EXPECT_EQ(faded.list.curves[0].points_V, whole.list.curves[0].points_V);
  EXPECT_EQ(faded.list.glassEllipsoids[0].farOpacity, whole.list.glassEllipsoids[0].farOpacity);
  EXPECT_EQ(faded.list.glassCones[0].rimOpacity, whole.list.glassCones[0].rimOpacity);
  EXPECT_EQ(faded.list.glassPolygons[0].opacity, whole.list.glassPolygons[0].opacity);
  EXPECT_EQ(faded.list.planes[0].lineOpacity, whole.list.planes[0].lineOpacity);
  EXPECT_EQ(faded.labels[0].opacity, 1);
}

Sample faded(double presence, const Eigen::Vector3d& pivot_V = {0, 0, 0}) {
  Sample sample;
  const DrawMark mark(sample.list, sample.labels);
  sample.add();
  mark.fade(sample.list, sample.labels, pivot_V, presence);
  return sample;
}

TEST(DrawMark, GrowsSolidsOutOfThePivot) {
  const draw::DrawList list = faded(0.25, {4, 0, 0}).list;
  EXPECT_EQ(list.ellipsoids[0].centre_V, glm::vec3(3.5f, 0, 0));  // a quarter of the way from the pivot
  EXPECT_EQ(list.ellipsoids[0].semiAxes_V, glm::mat3(0.25f));
  EXPECT_EQ(list.frustums[0].to_V, glm::vec3(3, 0, 0.5f));
  EXPECT_EQ(list.frustums[0].fromRadius, 0.125f);
  EXPECT_EQ(list.boxes[0].halfAxes_V, glm::mat3(0.25f));
  EXPECT_EQ(list.meshes[0].axes_V, glm::mat3(0.25f));
  EXPECT_EQ(list.meshes[0].origin_V, glm::vec3(3, 0, 0));
}

TEST(DrawMark, DrawsLinesOneAfterAnother) {
  const draw::DrawList half = faded(0.5).list;  // two of four lengths: the first line's first two thirds
  ASSERT_EQ(half.curves.size(), 1u);
  EXPECT_EQ(half.curves[0].points_V, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(half.curves[0].width_px, 2);
  const draw::DrawList more = faded(0.875).list;  // half of the second line
  ASSERT_EQ(more.curves.size(), 2u);
  EXPECT_EQ(more.curves[1].points_V, (std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 0.5f}}));
  EXPECT_FLOAT_EQ(faded(0.1).list.curves[0].width_px, 0.6f);  // a line begins with a smaller width
}

TEST(DrawMark, OpensAClosedLineWhileItIsDrawn) {
  draw::DrawList list;
  std::vector<Label> labels;
  const DrawMark mark(list, labels);
  list.curves.push_back(line({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 2));
  list.curves[0].closed = true;
  mark.fade(list, labels, {0, 0, 0}, 0.875);
  EXPECT_FALSE(list.curves[0].closed);
  EXPECT_EQ(list.curves[0].points_V.back(), glm::vec3(0, 0.5f, 0));
}

TEST(DrawMark, FadesGlassAndLabels) {
  const Sample sample = faded(0.5);
  const draw::GlassEllipsoid glass;
  const draw::Graticule lines;
  EXPECT_FLOAT_EQ(sample.list.glassEllipsoids[0].nearOpacity, 0.5f * glass.nearOpacity);
  EXPECT_FLOAT_EQ(sample.list.glassEllipsoids[0].graticule->farOpacity, 0.5f * lines.farOpacity);
  EXPECT_FLOAT_EQ(sample.list.glassCones[0].lineOpacity, 0.5f);
  EXPECT_FLOAT_EQ(sample.list.glassPolygons[0].lineOpacity, 0.5f);
  EXPECT_FLOAT_EQ(sample.list.planes[0].opacity, 0.5f * draw::GridPlane().opacity);
  EXPECT_FLOAT_EQ(sample.labels[0].opacity, 0.5f);
}

// ---- the whole picture

TEST(TimelinePicture, OmitsObjectsBeforeTheyAreShown) {
  const Stage stage(shownFrom("plane"));
  EXPECT_TRUE(onlyList(stage, 3.9, kSize).planes.empty());
  ASSERT_EQ(onlyList(stage, 5, kSize).planes.size(), 1u);
  const float half = onlyList(stage, 5, kSize).planes[0].opacity,
              whole = onlyList(stage, 6, kSize).planes[0].opacity;
  EXPECT_FLOAT_EQ(half, 0.5f * whole);
}

TEST(TimelinePicture, GrowsTheContactPointWithoutMovingIt) {
  const Stage stage(shownFrom("contact")), whole(sample());
  const draw::Ellipsoid dot = onlyList(stage, 5, kSize).ellipsoids.back();
  const draw::Ellipsoid full = onlyList(whole, 5, kSize).ellipsoids.back();
  EXPECT_EQ(dot.centre_V, full.centre_V);
  EXPECT_FLOAT_EQ(dot.semiAxes_V[0][0], 0.5f * full.semiAxes_V[0][0]);
}

TEST(TimelinePicture, HidesLabelsAndTitle) {
  const Stage stage(sample("[show]\ntitle = \"A\"\n[[timeline]]\nat = 2\nhide = [\"labels\", \"title\"]\n"));
  EXPECT_FALSE(onlyList(stage, 1, kSize).texts.empty());
  EXPECT_TRUE(onlyList(stage, 3, kSize).texts.empty());
  EXPECT_EQ(stage.compose(1, kSize).texts.at(0).opacity, 1);
  EXPECT_EQ(stage.compose(3, kSize).texts.at(0).opacity, 0);
}

/// Returns the numbers of a picture, which tell two pictures apart to the bit.
std::vector<float> numbersOf(const draw::Picture& picture) {
  std::vector<float> numbers;
  const draw::DrawList& list = picture.panels.at(0).list;
  const auto add = [&](const glm::vec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); };
  add(list.camera.eye_V);
  for (const draw::Frustum& f : list.frustums) add(f.to_V);
  for (const draw::Curve& c : list.curves)
    for (const glm::vec3& p : c.points_V) add(p);
  for (const draw::GridPlane& p : list.planes) numbers.push_back(p.opacity);
  for (const draw::Text& t : list.texts)
    numbers.insert(numbers.end(), {t.baseline_px.x, t.baseline_px.y, t.opacity});
  for (const draw::Text& t : picture.texts)
    numbers.insert(numbers.end(), {t.baseline_px.x, t.baseline_px.y, t.opacity});
  return numbers;
}

TEST(TimelinePicture, IsAPureFunctionOfTheTime) {
  const scene::Scene scene = shownFrom(
      "polhode",
      "speed = 0.3\ncaption = \"Slowly\"\ncamera.turn = 2\n[[timeline]]\nat = 7\nhold = 1\nhide = [\"body\"]\n");
  const Stage one(scene), other(scene);
  const std::vector<double> times = {0, 4.2, 5, 6.6, 7.9, 9.5};
  std::vector<std::vector<float>> forwards;
  for (const double t : times) forwards.push_back(numbersOf(one.compose(t, kSize)));
  for (std::size_t i = times.size(); i-- > 0;) EXPECT_EQ(numbersOf(other.compose(times[i], kSize)), forwards[i]);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(numbersOf(one.compose(times[i], kSize)), forwards[i]);
}

// ---- speed

TEST(TimelineMotion, ShowsTheSameMotionAtAnotherSpeed) {
  const scene::Scene scene = shownFrom("plane", "speed = 0.25\n"), plain = sample();
  const PictureMotion slow(scene, drawnMotion(scene)), steady(plain, drawnMotion(plain));
  for (const double t : {1.0, 4.5, 6.0, 9.0}) {
    const double played = slow.played_s(t);
    EXPECT_EQ(slow.at(t).omega_P, steady.at(played).omega_P);
    EXPECT_EQ(slow.at(t).R_VB, steady.at(played).R_VB);
  }
  EXPECT_NEAR(slow.played_s(9), 4 + 2 * 0.625 + 3 * 0.25, 1e-14);
}

// A path whose points are the same in every picture cannot crawl, at any speed.
TEST(TimelineMotion, KeepsThePointsOfItsPaths) {
  const scene::Scene scene = shownFrom("plane", "speed = 0.25\n");
  const PictureMotion motion(scene, drawnMotion(scene));
  const auto early = motion.path(0, motion.played_s(5)), late = motion.path(0, motion.played_s(8));
  ASSERT_GT(late.size(), early.size());
  for (std::size_t i = 0; i + 1 < early.size(); ++i) EXPECT_EQ(early[i].omega_W, late[i].omega_W);
}

TEST(TimelineMotion, DrawsNoMorePathDuringAHold) {
  const Stage stage(sample("[[timeline]]\nat = 2\nover = 0.5\nhold = 3\n"));
  const auto points = [&](double t) {
    std::size_t sum = 0;
    for (const draw::Curve& c : onlyList(stage, t, kSize).curves) sum += c.points_V.size();
    return sum;
  };
  // The bright end of the path, 0.9 s of film, has gone; the rest stands still.
  EXPECT_EQ(points(4), points(5));
}

}  // namespace
}  // namespace poinsot::stage
