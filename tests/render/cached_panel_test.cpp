// SPDX-License-Identifier: Apache-2.0
// Checks that a renderer's caches affect its speed alone: after any earlier picture, the bytes equal those of a
// new renderer.
#include <functional>

#include "core/error.h"
#include "glass_over_plane.h"
#include "picture_test.h"
#include "random.h"

namespace poinsot::render {
namespace {

using draw::Color;
using draw::Picture;

constexpr glm::ivec2 kWide(520, 390);  // some tiles are whole, some cut

draw::DrawList standing() {
  draw::DrawList list = glassOverPlane(kWide, 0.3f);
  list.background = draw::fromSrgb(0xF4F6F8);
  list.frustums.push_back({glm::vec3(0), {0, 0.3f, 0.5f}, 0.05f, 0, {}});
  list.glassEllipsoids[0].graticule = draw::Graticule{};
  draw::GridPlane& plane = list.planes[0];
  plane.shadowCentre_V = plane.centre_V;
  plane.shadowRadius_V = 0.15f;
  plane.shadowOpacity = 0.4f;
  list.texts = {{"$L$", {40, 60}, 24, Color(0), 1, Color(1), 3}};
  return list;
}

Picture inOnePanel(const draw::DrawList& list) {
  Picture picture;
  picture.size_px = kWide;
  picture.background = list.background;
  picture.panels = {{{0, 0}, list}};
  draw::Stroke line;
  line.points_px = {{5, 350}, {300, 340}};
  picture.strokes = {line};
  picture.texts = {{"title", {300, 30}, 20, Color(0), 1, std::nullopt, 0}};
  return picture;
}

struct Request {
  Picture picture = inOnePanel(standing());
  int bits = 8;
  RenderOptions options = {};

  draw::DrawList& list() { return picture.panels[0].list; }
};

class CachedPanelTest : public PictureTest {
 protected:
  /// Returns the picture that a new renderer, whose caches are empty, draws.
  image::AnyImage fresh(const Request& r) {
    return Renderer(*context_).frame(r.picture, r.bits, r.options).picture;
  }
  const image::AnyImage& next(const Request& r) {
    const image::Frame frame = renderer_.frame(r.picture, r.bits, r.options);
    if (number_ > 0 && frame.number == number_ + 1) expectSameBeside(frame);
    told_ += frame.number > 0 ? 1 : 0;
    number_ = frame.number;
    before_ = frame.picture;
    return frame.picture;
  }

  /// Checks that a frame equals the previous one outside the parts that it reports as changed.
  void expectSameBeside(const image::Frame& frame) {
    if (frame.picture.index() != before_.index()) return;
    std::visit(
        [&](const auto& now) {
          auto then = std::get<std::decay_t<decltype(now)>>(before_);
          if (then.size != now.size || then.channels != now.channels) return;
          for (const image::PixelRect& part : frame.changed)
            for (int y = part.top; y < part.bottom; ++y)
              std::copy(now.at(part.left, y), now.at(part.left, y) + now.channels * (part.right - part.left),
                        then.at(part.left, y));
          EXPECT_EQ(then, now);
        },
        frame.picture);
  }

  std::uint64_t number_ = 0;
  image::AnyImage before_;
  int told_ = 0;  // number of frames that reported what changed
};

/// Changes of every kind that are possible between two pictures.
const std::vector<std::function<void(Request&)>> kChanges{
    [](Request&) {},
    [](Request& r) { r.list().frustums[0].to_V.x += 0.2f; },
    [](Request& r) { r.list().frustums.clear(); },
    [](Request& r) { r.list().glassEllipsoids[0].centre_V.y += 0.1f; },
    [](Request& r) { r.list().glassEllipsoids.clear(); },
    [](Request& r) { r.list().planes[0].shadowCentre_V.x += 0.3f; },
    [](Request& r) { r.list().planes[0].shadowRadius_V = 0; },
    [](Request& r) { r.list().planes[0].lineWidth_px = 2.5f; },
    [](Request& r) { r.list().planes[0].color = Color(0.9f, 0.3f, 0.2f); },
    [](Request& r) { r.list().planes.push_back(r.list().planes[0]); },
    [](Request& r) { std::swap(r.list().planes[0].u_V, r.list().planes[0].v_V); },
    [](Request& r) { r.list().background = Color(0.2f); },
    [](Request& r) { r.list().camera.eye_V.z += 0.05f; },
    [](Request& r) {
      r.list().lightDirection_C = {1, 0, 0.2f};
    },
    [](Request& r) { r.list().texts[0].baseline_px.x += 100; },
    [](Request& r) { r.list().texts.clear(); },
    [](Request& r) { r.picture.texts[0].tex = "another title"; },
    [](Request& r) { r.picture.texts.clear(); },
    [](Request& r) {
      r.picture.strokes[0].points_px[1] = {500, 20};
    },
    [](Request& r) {
      r.picture.areas = {{{{0, 0}, {200, 0}, {100, 200}}, Color(0.5f), 0.5f}};
    },
    [](Request& r) { r.options.transparent = true; },
    [](Request& r) { r.bits = 16; },
    [](Request& r) { r.picture.panels.clear(); },
    [](Request& r) { r.picture.size_px.x += 20; },  // a panel beside paper
    [](Request& r) {
      r.picture.size_px.x *= 2;
      r.picture.panels.push_back({{kWide.x, 0}, standing()});
      r.picture.panels[1].list.planes.clear();
    }};

TEST_F(CachedPanelTest, DrawsTheSameBytesAfterAnyOtherPicture) {
  const image::AnyImage first = fresh({});
  for (std::size_t i = 0; i < kChanges.size(); ++i) {
    Request changed;
    kChanges[i](changed);
    EXPECT_EQ(next({}), first) << "before change " << i;
    EXPECT_EQ(next(changed), fresh(changed)) << "change " << i;
  }
  EXPECT_EQ(next({}), first);
}

TEST_F(CachedPanelTest, DrawsTheSameBytesAfterRandomChanges) {
  Random random;
  const auto some = [&] {
    Request r;
    for (int i = 0; i < 2; ++i) {
      const auto& change = kChanges[static_cast<std::size_t>(random.in(0, 22))];  // changes of one panel
      const draw::DrawList& list = r.list();
      if (list.planes.empty() || list.glassEllipsoids.empty() || list.texts.empty() || list.frustums.empty())
        break;
      if (r.picture.texts.empty()) break;
      change(r);
      if (r.picture.panels.empty()) break;
    }
    return r;
  };
  for (int i = 0; i < 40; ++i) {
    const Request r = some();
    EXPECT_EQ(next(r), fresh(r)) << i;
  }
  EXPECT_GT(told_, 30);
}

TEST_F(CachedPanelTest, DrawsTheSameBytesAfterAPictureThatFailed) {
  Request broken;
  broken.list().texts.push_back({"$\\omgea$", {200, 200}, 20, Color(0), 1, std::nullopt, 0});
  broken.list().frustums.clear();
  next({});
  EXPECT_THROW(next(broken), core::Error);
  EXPECT_EQ(next({}), fresh({}));
}

/// Returns rods within glass that leave the picture on the right and below, by one pixel more from row to row. If
/// `another` is set, adds a rod far away from them, at the top left.
Request leaving(glm::ivec2 size_px, bool another) {
  draw::DrawList list;
  list.camera = draw::lookAt({10, 0, 0}, {0, 0, 0}, {0, 0, 1}, 1.0f, size_px);
  list.camera.tanHalfFovY = 0.15f;
  list.camera.near = 5;
  list.camera.far = 15;
  list.glassEllipsoids = {{}};
  list.glassEllipsoids[0].semiAxes_V = glm::mat3(3.5f);
  list.frustums = {{{0, 2.45f, -1.2f}, {0, 2.55f, 0.3f}, 0.05f, 0.05f, {}},
                   {{0, -1, -1.45f}, {0, 2, -1.55f}, 0.05f, 0.05f, {}}};
  if (another) list.frustums.push_back({{0, -2.4f, 1.4f}, {0, -2.3f, 1.3f}, 0.03f, 0.03f, {}});
  Request r;
  r.picture = {};
  r.picture.size_px = size_px;
  r.picture.panels = {{{0, 0}, list}};
  return r;
}

// The layers of the solids end with the picture at one size, and reach beyond it at the other.
TEST_F(CachedPanelTest, DrawsTheSameBytesAtTheBorderAfterAnotherSize) {
  for (const glm::ivec2 size : {glm::ivec2(640, 384), glm::ivec2(639, 383)}) {
    const Request wanted = leaving(size, false);
    const image::AnyImage alone = fresh(wanted);
    next(leaving(size, true));
    EXPECT_EQ(next(wanted), alone);
  }
}

}  // namespace
}  // namespace poinsot::render
