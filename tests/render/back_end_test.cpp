// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "mesh_shapes.h"
#include "picture_test.h"
#include "support/back_ends.h"

namespace poinsot::render {
namespace {

draw::DrawList busyList(image::PixelSize size) {
  draw::DrawList list;
  list.camera = draw::lookAt({7, -3, 2}, {0, 0, 0}, {0, 0, 1}, 0.4f, {size.width, size.height});
  list.boxes.push_back({glm::vec3(0), glm::mat3(0.4f, 0.1f, 0, -0.1f, 0.3f, 0.1f, 0, -0.1f, 0.2f), {}});
  list.frustums.push_back({{0, 0, -1}, {0, 0.2f, -1.3f}, 0.1f, 0, {}});
  list.ellipsoids.push_back({{0, 1, 0}, glm::mat3(0.2f), {}});
  draw::Curve curve;
  for (int i = 0; i < 100; ++i)
    curve.points_V.push_back({0.01f * static_cast<float>(i) - 0.5f, 0.9f, 0.004f * static_cast<float>(i)});
  list.curves.push_back(curve);
  curve.radius_V = 0.05f;
  list.curves.push_back(curve);
  draw::Mesh mesh;
  mesh.mesh = torus(0.4f, 24, 12);
  mesh.origin_V = {0.3f, 0.4f, 0.3f};
  mesh.axes_V = glm::mat3(0.4f);
  list.meshes.push_back(mesh);
  mesh.mesh = lPrism();
  mesh.origin_V = {0, -0.9f, 0.3f};
  mesh.axes_V = glm::mat3(0.3f);
  mesh.edge_px = 1.5f;
  list.meshes.push_back(mesh);
  draw::GlassEllipsoid glass;
  glass.graticule = draw::Graticule{};
  list.glassEllipsoids.push_back(glass);
  draw::GridPlane plane;
  plane.centre_V = {0, 0, -0.9f};
  list.planes.push_back(plane);
  list.texts.push_back({"$\\boldsymbol{\\omega}$", {30, 40}, 30, draw::Color(0), 1, draw::Color(1), 3});
  return list;
}

image::Image pictureOf(gl::Backend backend) {
  const image::PixelSize size{320, 240};
  const auto context = gl::openContext(backend);
  return Renderer(*context).render(busyList(size), size);
}

TEST(BackEnds, OsMesaAndEglGiveTheSameBytes) {
  POINSOT_NEEDS_OSMESA();
  gl::pinEnvironment(true);
  EXPECT_EQ(pictureOf(gl::Backend::kOsMesa), pictureOf(gl::Backend::kEgl));
}

TEST(BackEnds, DrawTheSameBytesIfADrawListIsRepeated) {
  gl::pinEnvironment(true);
  const auto context = gl::openContext(gl::Backend::kAuto);
  const image::PixelSize size{320, 240};
  Renderer renderer(*context);
  const image::Image first = renderer.render(busyList(size), size);
  draw::DrawList empty;
  empty.camera = busyList(size).camera;
  renderer.render(empty, size);  // another picture in between
  EXPECT_EQ(renderer.render(busyList(size), size), first);
}

struct Drawing {
  explicit Drawing(gl::Backend backend) : context(gl::openContext(backend)), renderer(new Renderer(*context)) {}
  image::Image picture() const { return renderer->render(busyList(kSize), kSize); }

  static constexpr image::PixelSize kSize{320, 240};
  std::unique_ptr<gl::OffscreenContext> context;
  std::unique_ptr<Renderer> renderer;
};

TEST(Renderer, RefusesToDrawUnlessItsContextIsCurrent) {
  for (const gl::Backend backend : backEnds()) {
    const Drawing outer(backend);
    const image::Image first = outer.picture();
    {
      const Drawing inner(gl::Backend::kAuto);
      EXPECT_THROW(outer.picture(), std::logic_error);
      EXPECT_THROW(Renderer(*outer.context), std::logic_error);
    }
    EXPECT_EQ(outer.picture(), first);
  }
}

// Two contexts give their objects the same names (numbers).
TEST(Renderer, DeletesOnlyObjectsOfItsOwnContext) {
  Drawing outer(gl::Backend::kAuto);
  outer.picture();
  const Drawing inner(gl::Backend::kAuto);
  const image::Image first = inner.picture();
  outer.renderer.reset();
  EXPECT_EQ(inner.picture(), first);
  outer.context.reset();
  EXPECT_EQ(inner.picture(), first);
}

TEST(Renderer, RejectsADrawListForAnotherSize) {
  const auto context = gl::openContext(gl::Backend::kAuto);
  EXPECT_THROW(Renderer(*context).render(busyList({320, 240}), {100, 100}), std::logic_error);
}

}  // namespace
}  // namespace poinsot::render
