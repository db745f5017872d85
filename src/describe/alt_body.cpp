// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "describe/alt_sections.h"
#include "describe/language.h"

namespace poinsot::describe {
namespace {

constexpr std::size_t kMostPartsNamed = 4;  // a longer list is tiring to hear

template <typename Vector>
std::string byWords(const Vector& lengths_m) {
  std::string text;
  for (int i = 0; i < lengths_m.size(); ++i) text += (i > 0 ? say(" by ") : "") + lengthWords(lengths_m[i]);
  return text;
}

std::string round(const char* noun, double radius_m) {
  return say("{} of radius {}", say(noun), lengthWords(radius_m));
}

std::string high(const char* noun, double radius_m, double height_m) {
  return say("{} and height {}", round(noun, radius_m), lengthWords(height_m));
}

struct SolidWords {
  std::string operator()(const physics::Box& s) const { return say("a box of {}", byWords(s.edges_m)); }
  std::string operator()(const physics::HollowBox& s) const {
    return say("a hollow box of {}", byWords(s.edges_m));
  }
  std::string operator()(const physics::Plate& s) const { return say("a thin plate of {}", byWords(s.edges_m)); }
  std::string operator()(const physics::Ellipsoid& s) const {
    return say("an ellipsoid of {}", byWords(Eigen::Vector3d(2 * s.semiAxes_m)));
  }
  std::string operator()(const physics::EllipsoidShell& s) const {
    return say("a hollow ellipsoid of {}", byWords(Eigen::Vector3d(2 * s.semiAxes_m)));
  }
  std::string operator()(const physics::Sphere& s) const {
    return round(s.innerRadius_m > 0 ? "a hollow sphere" : "a sphere", s.radius_m);
  }
  std::string operator()(const physics::SphereShell& s) const { return round("a spherical shell", s.radius_m); }
  std::string operator()(const physics::Hemisphere& s) const { return round("a hemisphere", s.radius_m); }
  std::string operator()(const physics::Cylinder& s) const {
    return high(s.innerRadius_m > 0 ? "a tube" : "a cylinder", s.radius_m, s.height_m);
  }
  std::string operator()(const physics::CylinderShell& s) const {
    return high("an open cylindrical shell", s.radius_m, s.height_m);
  }
  std::string operator()(const physics::Disc& s) const { return round("a thin disc", s.radius_m); }
  std::string operator()(const physics::Hoop& s) const { return round("a hoop", s.radius_m); }
  std::string operator()(const physics::Rod& s) const {
    return say("a thin rod of length {}", lengthWords(s.length_m));
  }
  std::string operator()(const physics::Cone& s) const { return high("a cone", s.radius_m, s.height_m); }
  std::string operator()(const physics::ConeShell& s) const {
    return high("a hollow cone", s.radius_m, s.height_m);
  }
  std::string operator()(const physics::Torus& s) const { return round("a torus", s.radius_m); }
  std::string operator()(const physics::TorusShell& s) const { return round("a hollow torus", s.radius_m); }
  std::string operator()(const physics::Capsule& s) const { return high("a capsule", s.radius_m, s.height_m); }
  std::string operator()(const physics::Polyhedron& s) const {
    constexpr const char* kNouns[] = {"a tetrahedron", "a cube", "an octahedron", "a dodecahedron",
                                      "an icosahedron"};
    return say("{} of edge {}", say(kNouns[static_cast<std::size_t>(s.kind)]), lengthWords(s.edge_m));
  }
  std::string operator()(const physics::LPlate& s) const {
    return say("an L-shaped plate of {}", byWords(s.edges_m));
  }
  std::string operator()(const physics::THandle& s) const {
    return say("a T-handle with a bar of {} and a shaft of {}", lengthWords(s.barLength_m),
               lengthWords(s.shaftLength_m));
  }
  std::string operator()(const physics::Racket& s) const {
    return say("a racket, {} long and {} wide", lengthWords(s.length_m), lengthWords(s.width_m));
  }
  std::string operator()(const physics::WingNut& s) const {
    return say("a wing nut with a hub of radius {}", lengthWords(s.hubRadius_m));
  }
};

struct FigureWords {
  std::string operator()(const physics::Solid& solid) const { return std::visit(SolidWords(), solid); }
  std::string operator()(const std::shared_ptr<const geometry::Mesh>&) const {
    return say("a body read from a mesh");
  }
  std::string operator()(const scene::PointMass&) const { return say("a point mass"); }
};

std::string partsWords(const std::vector<scene::Part>& parts) {
  if (parts.size() > kMostPartsNamed) return say("made of {} parts", parts.size());
  std::vector<std::string> nouns;
  for (const scene::Part& part : parts) nouns.push_back(std::visit(FigureWords(), part.figure));
  if (nouns.size() == 1) return nouns.front();
  return say("made of {}", listWords(nouns));
}

/// Returns words such as "1.2 kg m² about e1 and e2 and 3 kg m² about e3". Axes with equal moments are listed
/// together.
std::string momentsWords(const physics::PrincipalMoments& moments) {
  std::vector<std::string> words;
  for (int axis = 0; axis < 3; ++axis) {
    const bool sameAsNext = axis < 2 && moments[axis] == moments[axis + 1];
    const bool sameAsBefore = axis > 0 && moments[axis] == moments[axis - 1];
    if (sameAsNext) continue;
    const std::string both = sameAsBefore ? axisName(axis - 1) + say(" and ") : "";
    words.push_back(say("{} kg m² about {}{}", numberWords(moments[axis]), both, axisName(axis)));
  }
  return listWords(words);
}

std::string momentsSentence(const scene::Body& body) {
  const physics::PrincipalMoments& moments = body.axes.moments();
  const Eigen::Vector3d& I = moments.values();
  const std::string about = body.pivot_B ? say(" about that point") : "";
  if (I.minCoeff() == I.maxCoeff())
    return say("Its moment of inertia{} is {} kg m² about every axis.", about, numberWords(I[0]));
  return say("Its principal moments of inertia{} are {}.", about, momentsWords(moments));
}

std::string drawnAs(const scene::Scene& scene) {
  const bool drawn = std::ranges::any_of(scene.views, [](const auto& view) { return view.show.body.visible; });
  if (!drawn || (!scene.body.parts.empty() && scene.show.body.parts.empty())) return "";
  if (!scene.show.body.parts.empty()) return say(", and is drawn in another shape");
  return scene.body.mass || scene.motion.forcing.gravity_B.isZero(0)
             ? say(", and is drawn as the uniform box that has them")
             : say(", and is drawn as the uniform cone that has them");
}

std::string momentsAlone(const scene::Body& body) {
  return say(body.mass ? "given by its moments of inertia" : "given by its moments of inertia alone");
}

std::string whatItIs(const scene::Scene& scene) {
  const scene::Body& body = scene.body;
  std::string text = body.parts.empty() ? momentsAlone(body) : partsWords(body.parts);
  if (body.mass) text += say(", of {} kg", numberWords(body.mass->mass_kg()));
  text += drawnAs(scene);
  if (body.pivot_B) text += say(", and turns about a point that is held fixed");
  return text;
}

}  // namespace

std::string axisName(int axis) { return fmt::format("e{}", axis + 1); }

Sentences bodySentences(const scene::Scene& scene) {
  return {say("The body is {}.", whatItIs(scene)), momentsSentence(scene.body)};
}

}  // namespace poinsot::describe
