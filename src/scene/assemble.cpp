// SPDX-License-Identifier: Apache-2.0
#include "scene/assemble.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/error.h"
#include "physics/shape_inertia.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;

std::string vectorText(const Vector3d& v) { return fmt::format("({}, {}, {})", v[0], v[1], v[2]); }

/// "I3 must not exceed I1 + I2, got (0.1, 0.2, 0.9) kg·m²; ..."
std::string triangleMessage(const Vector3d& moments) {
  int largest = 0;
  moments.maxCoeff(&largest);
  const int other = largest == 0 ? 2 : 1, another = largest == 2 ? 2 : 3;
  return fmt::format("I{} must not exceed I{} + I{}, got {} kg·m²; a solid body cannot have these values",
                     largest + 1, other, another, vectorText(moments));
}

/// What physics could not solve, or empty. Bare moments were checked for their range before, a shape's were not.
std::string outOfReach(const Vector3d& moments) {
  const double least = moments.minCoeff(), most = moments.maxCoeff();
  if (least < kLeastMoment || most > kMostMoment)
    return fmt::format("with this mass the moments are {} kg·m²; they must be from {:g} to {:g} kg·m²",
                       vectorText(moments), kLeastMoment, kMostMoment);
  if (least * kMostRatioOfMoments < most)
    return fmt::format("the largest moment may be at most {:g} times the smallest, got {} kg·m²",
                       kMostRatioOfMoments, vectorText(moments));
  return "";
}

physics::PrincipalMoments momentsOf(const Shape& shape, double mass_kg) {
  const Vector3d& size = shape.size_m;
  switch (shape.kind) {
    case ShapeKind::kBox:
      return physics::solidBoxMoments(mass_kg, size);
    case ShapeKind::kEllipsoid:
      return physics::solidEllipsoidMoments(mass_kg, size / 2);
    case ShapeKind::kCylinder:
      return physics::solidCylinderMoments(mass_kg, size[0] / 2, size[2]);
    case ShapeKind::kRacket:
      break;
  }
  return physics::racketMoments(mass_kg, size[0], size[1]);
}

/// What a shape looks like when no size is given: a book, an egg, a can, a tennis racket (ITF: 0.737 m x 0.317 m
/// at most).
Vector3d usualSize(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kBox:
      return {0.24, 0.16, 0.04};
    case ShapeKind::kEllipsoid:
      return {0.30, 0.20, 0.16};
    case ShapeKind::kCylinder:
      return {0.066, 0.066, 0.115};
    case ShapeKind::kRacket:
      break;
  }
  return {0.685, 0.26, 0.024};
}

class Assembly {
 public:
  Assembly(Draft draft, const Leaves& given, const Origins& origins, Problems& problems)
      : draft_(std::move(draft)), scene_(draft_.scene), given_(given), origins_(origins), problems_(problems) {}

  Scene run() {
    if (!givesBelow("body") && !givesBelow("motion"))
      problems_.add(origins_.file, nothingMessage());
    else
      bodyAndStart();
    drawnShape();
    frames();
    output();
    return std::move(scene_);
  }

 private:
  bool has(std::string_view path) const { return given_.contains(path); }

  bool givesBelow(std::string_view table) const {
    const auto next = given_.lower_bound(std::string(table) + ".");
    return next != given_.end() && next->first.starts_with(std::string(table) + ".");
  }

  /// At the value, or where the file starts when the value is a default.
  void refuse(std::string_view path, const std::string& message) {
    const auto leaf = given_.find(path);
    problems_.add(leaf == given_.end() ? origins_.file : leaf->second.place, fmt::format("{}: {}", path, message));
  }

  static std::string nothingMessage() {
    return "a body and a start are required, for example:\n"
           "    schema = 1\n"
           "    [body]\n"
           "    principal_moments = [1.0, 2.0, 2.5]\n"
           "    [motion]\n"
           "    omega_body = [0.01, 3.0, 0.0]";
  }

  void bodyAndStart() {
    const bool shaped = has("body.shape") || has("body.size") || has("body.mass");
    if (has("body.principal_moments") && shaped)
      refuseBoth();
    else if (has("body.principal_moments"))
      bareMoments();
    else if (shaped)
      shapedBody();
    else
      problems_.add(origins_.body, "body: the body is missing; give principal_moments, or shape, size and mass");
    if (!has("motion.omega_body"))
      problems_.add(origins_.motion,
                    "motion.omega_body: required: the angular velocity at the start, such as [0.01, 3.0, 0.0]");
    else
      rotation();
  }

  void refuseBoth() {
    const char* other = has("body.shape") ? "body.shape" : has("body.size") ? "body.size" : "body.mass";
    refuse(other,
           "body.principal_moments is given too; the moments come from it, or from shape, size and mass, "
           "not from both (to draw a shape that does not set the moments, use show.body.shape)");
  }

  void bareMoments() {
    if (!draft_.moments) return;
    try {
      scene_.body.axes = physics::PrincipalMoments(*draft_.moments);
    } catch (const core::Error&) {
      return refuse("body.principal_moments", triangleMessage(*draft_.moments));  // the range was checked before
    }
    if (const std::string problem = outOfReach(*draft_.moments); !problem.empty())
      refuse("body.principal_moments", problem);
  }

  void shapedBody() {
    const std::array<std::string_view, 3> paths = {"body.shape", "body.size", "body.mass"};
    std::string_view present, missing;
    for (const std::string_view path : paths) (has(path) ? present : missing) = path;
    if (!missing.empty())
      return refuse(present, fmt::format("{} is missing: shape, size and mass set the moments together", missing));
    if (!draft_.shape || !draft_.size_m || !draft_.mass_kg) return;
    const Shape shape{*draft_.shape, *draft_.size_m};
    if (!fits(shape, "body.size")) return;
    setBody(shape, *draft_.mass_kg);
  }

  void setBody(const Shape& shape, double mass_kg) {
    try {
      scene_.body.axes = momentsOf(shape, mass_kg);
      scene_.body.shape = shape;
    } catch (const core::Error& error) {
      return refuse("body.size", error.message());
    }
    if (const std::string problem = outOfReach(scene_.body.axes.moments().values()); !problem.empty())
      refuse("body.size", problem);
  }

  bool fits(const Shape& shape, std::string_view path) {
    const Vector3d& size = shape.size_m;
    if (shape.kind == ShapeKind::kCylinder && size[0] != size[1]) {
      refuse(path, fmt::format("the x and y extents of a cylinder must be equal, got {} m", vectorText(size)));
      return false;
    }
    if (shape.kind == ShapeKind::kRacket && !(size[0] > size[1])) {
      refuse(path, fmt::format("a racket must be longer (x) than wide (y), got {} m", vectorText(size)));
      return false;
    }
    return true;
  }

  void rotation() {
    scene_.motion.omega_B = draft_.omega_B.value_or(Vector3d::Ones());  // a refused one is not zero besides
    if (scene_.motion.omega_B != Vector3d::Zero()) return;
    if (!has("motion.orientation"))
      return refuse("motion.omega_body",
                    "must not be zero, got (0, 0, 0) rad/s: without rotation L has no direction to turn onto the "
                    "vertical; give a rotation, or motion.orientation");
    if (const std::string shown = needingRotation(); !shown.empty())
      refuse("motion.omega_body", fmt::format("must not be zero, got (0, 0, 0) rad/s: without rotation there is "
                                              "nothing to draw for {}; give a rotation, or set these to false",
                                              shown));
  }

  /// "show.L, show.omega": what is visible and does not exist for a body at rest.
  std::string needingRotation() const {
    const Show& show = scene_.show;
    const std::pair<const char*, bool> things[] = {{"L", show.L.visible},
                                                   {"omega", show.omega.visible},
                                                   {"ellipsoid", show.ellipsoid.visible},
                                                   {"plane", show.plane.visible},
                                                   {"contact", show.contact.visible},
                                                   {"polhode", show.polhode.visible},
                                                   {"herpolhode", show.herpolhode.visible},
                                                   {"height", show.height.visible}};
    std::string names;
    for (const auto& [name, visible] : things)
      if (visible) names += fmt::format("{}show.{}", names.empty() ? "" : ", ", name);
    return names;
  }

  void drawnShape() {
    if (has("show.body.size") && !has("show.body.shape"))
      return refuse("show.body.size", "needs show.body.shape, the shape whose extents these are");
    const bool sizeRefused = has("show.body.size") && !draft_.drawnSize;
    if (!draft_.drawnShape || sizeRefused) return;
    const Vector3d usual = usualSize(*draft_.drawnShape);
    const Shape shape{*draft_.drawnShape, draft_.drawnSize.value_or(draft_.size_m.value_or(usual))};
    if (fits(shape, has("show.body.size") ? "show.body.size" : "show.body.shape")) scene_.show.body.shape = shape;
  }

  /// Frames are all k with k/fps < duration.
  void frames() {
    const Time& time = scene_.time;
    const double count = std::ceil(time.duration_s * time.fps.value());
    if (count > static_cast<double>(kMostFrames))
      refuse(has("time.duration") ? "time.duration" : "time.fps",
             fmt::format("{} s at {} frames per second are {} frames; a film may have at most {}", time.duration_s,
                         core::toString(time.fps), count, kMostFrames));
  }

  void output() {
    const QualityPreset& preset = qualityPresets()[static_cast<std::size_t>(draft_.quality)];
    const Eigen::Vector2i size = draft_.size_px.value_or(Eigen::Vector2i(preset.width, preset.height));
    scene_.output = {size[0], size[1], draft_.crf.value_or(preset.crf)};
  }

  Draft draft_;
  Scene& scene_;
  const Leaves& given_;
  const Origins origins_;
  Problems& problems_;
};

}  // namespace

Scene assemble(Draft draft, const Leaves& given, const Origins& origins, Problems& problems) {
  return Assembly(std::move(draft), given, origins, problems).run();
}

}  // namespace poinsot::scene
