// SPDX-License-Identifier: Apache-2.0
#include "scene/shapes.h"

#include <fmt/format.h>

namespace poinsot::scene {
namespace {

using namespace physics;  // this file uses nearly all solids of physics
using Eigen::Vector3d;
using physics::Vector2;

double length(const ShapeDraft& shape, std::string_view name) {
  const auto found = shape.lengths.find(name);
  return found == shape.lengths.end() ? 0 : found->second;
}

double extent(const ShapeDraft& shape, std::size_t axis) {
  const std::vector<double>& size = *shape.size;
  return size.size() == 1 ? size[0] : size.at(axis);
}

Vector3d extents(const ShapeDraft& shape) { return {extent(shape, 0), extent(shape, 1), extent(shape, 2)}; }
Vector2 twoExtents(const ShapeDraft& shape) { return {extent(shape, 0), extent(shape, 1)}; }

Solid cylinder(const ShapeDraft& s) {
  const double inner_m = length(s, "inner_radius");
  if (s.size) return Cylinder{extent(s, 0) / 2, extent(s, 2), inner_m};
  return Cylinder{length(s, "radius"), length(s, "height"), inner_m};
}

Solid racket(const ShapeDraft& s) {
  if (s.size) return Racket{extent(s, 0), extent(s, 1)};
  return Racket{length(s, "length"), length(s, "width")};
}

Solid tHandle(const ShapeDraft& s) {
  return THandle{length(s, "bar_length"), length(s, "bar_radius"), length(s, "shaft_length"),
                 length(s, "shaft_radius")};
}

Solid wingNut(const ShapeDraft& s) {
  return WingNut{length(s, "hub_radius"), length(s, "hub_height"), *s.wing, length(s, "wing_centre"),
                 length(s, "wing_rise")};
}

template <class T>
Solid ofRadius(const ShapeDraft& s) {
  return T{length(s, "radius")};
}

template <class T>
Solid ofRadiusAndHeight(const ShapeDraft& s) {
  return T{length(s, "radius"), length(s, "height")};
}

template <class T>
Solid ofTwoRadii(const ShapeDraft& s) {
  return T{length(s, "radius"), length(s, "tube_radius")};
}

NamedShape polyhedron(std::string_view word, PolyhedronKind kind) {
  return {.word = word,
          .help = "A regular polyhedron with its centre at the origin.",
          .ways = {{"edge"}},
          .make = [kind](const ShapeDraft& s) -> Solid {
            return Polyhedron{kind, length(s, "edge")};
          },
          .usual = Polyhedron{kind, 0.1}};
}

/// Returns the shapes that have the key `size`. The default proportions in this file are those of a book, an egg,
/// a can, a tennis racket (ITF: at most 0.737 m x 0.317 m), and the table of solids in the lecture notes.
std::vector<NamedShape> solidsWithExtents() {
  return {
      {.word = "box",
       .help = "A box with its edges along the axes.",
       .ways = {{"size"}},
       .make = [](const ShapeDraft& s) -> Solid { return Box{extents(s)}; },
       .usual = Box{{0.24, 0.16, 0.04}}},
      {.word = "hollow_box",
       .help = "A box with walls of constant thickness.",
       .ways = {{"size", "wall"}},
       .make = [](const ShapeDraft& s) -> Solid {
         return HollowBox{extents(s), length(s, "wall")};
       },
       .usual = HollowBox{{1.2, 0.9, 0.5}, 0.05}},
      {.word = "plate",
       .help = "A rectangle of no thickness in the xy plane.",
       .ways = {{"size"}},
       .extents = 2,
       .make = [](const ShapeDraft& s) -> Solid { return Plate{twoExtents(s)}; },
       .usual = Plate{{0.297, 0.21}}},
      {.word = "ellipsoid",
       .help = "An ellipsoid with its axes along x, y and z.",
       .ways = {{"size"}},
       .make = [](const ShapeDraft& s) -> Solid { return Ellipsoid{extents(s) / 2}; },
       .usual = Ellipsoid{{0.15, 0.10, 0.08}}},
      {.word = "ellipsoid_shell",
       .help = "The matter between two similar, concentric ellipsoids that nearly touch.",
       .ways = {{"size"}},
       .make = [](const ShapeDraft& s) -> Solid { return EllipsoidShell{extents(s) / 2}; },
       .usual = EllipsoidShell{{0.15, 0.10, 0.08}}},
  };
}

std::vector<NamedShape> roundSolids() {
  return {
      {.word = "sphere",
       .help = "A ball. With inner_radius it is hollow.",
       .ways = {{"radius"}},
       .optional = {"inner_radius"},
       .make = [](const ShapeDraft& s) -> Solid {
         return Sphere{length(s, "radius"), length(s, "inner_radius")};
       },
       .usual = Sphere{0.1, 0}},
      {.word = "sphere_shell",
       .help = "The surface of a ball.",
       .ways = {{"radius"}},
       .make = ofRadius<SphereShell>,
       .usual = SphereShell{0.1}},
      {.word = "hemisphere",
       .help = "Half a ball. The origin is the centre of its flat face, and the dome points towards +z.",
       .ways = {{"radius"}},
       .make = ofRadius<Hemisphere>,
       .usual = Hemisphere{0.1}},
      {.word = "cylinder",
       .help = "A cylinder about z. With inner_radius it is a tube. The x and y extents of `size` must be equal.",
       .ways = {{"size"}, {"radius", "height"}},
       .optional = {"inner_radius"},
       .make = cylinder,
       .usual = Cylinder{0.033, 0.115, 0}},
      {.word = "cylinder_shell",
       .help = "The wall of a cylinder about z, without its ends.",
       .ways = {{"radius", "height"}},
       .make = ofRadiusAndHeight<CylinderShell>,
       .usual = CylinderShell{0.033, 0.115}},
      {.word = "disc",
       .help = "A disc of no thickness in the xy plane.",
       .ways = {{"radius"}},
       .make = ofRadius<Disc>,
       .usual = Disc{0.1}},
      {.word = "hoop",
       .help = "A thin ring in the xy plane.",
       .ways = {{"radius"}},
       .make = ofRadius<Hoop>,
       .usual = Hoop{0.1}},
      {.word = "rod",
       .help = "A thin straight rod along x.",
       .ways = {{"length"}},
       .make = [](const ShapeDraft& s) -> Solid { return Rod{length(s, "length")}; },
       .usual = Rod{0.3}},
      {.word = "cone",
       .help = "A cone about z with its apex towards +z. The origin is its centre of mass, a quarter of the "
               "height above the base.",
       .ways = {{"radius", "height"}},
       .make = ofRadiusAndHeight<Cone>,
       .usual = Cone{0.05, 0.12}},
      {.word = "cone_shell",
       .help = "The side of a cone, without its base. The origin is its centre of mass, a third of the height "
               "above the base.",
       .ways = {{"radius", "height"}},
       .make = ofRadiusAndHeight<ConeShell>,
       .usual = ConeShell{0.05, 0.12}},
      {.word = "torus",
       .help = "A torus about z.",
       .ways = {{"radius", "tube_radius"}},
       .make = ofTwoRadii<Torus>,
       .usual = Torus{0.1, 0.03}},
      {.word = "torus_shell",
       .help = "The surface of a torus.",
       .ways = {{"radius", "tube_radius"}},
       .make = ofTwoRadii<TorusShell>,
       .usual = TorusShell{0.1, 0.03}},
      {.word = "capsule",
       .help = "A cylinder about z with half balls on its ends.",
       .ways = {{"radius", "height"}},
       .make = ofRadiusAndHeight<Capsule>,
       .usual = Capsule{0.05, 0.12}},
  };
}

std::vector<NamedShape> polyhedra() {
  return {polyhedron("tetrahedron", PolyhedronKind::kTetrahedron), polyhedron("cube", PolyhedronKind::kCube),
          polyhedron("octahedron", PolyhedronKind::kOctahedron),
          polyhedron("dodecahedron", PolyhedronKind::kDodecahedron),
          polyhedron("icosahedron", PolyhedronKind::kIcosahedron)};
}

std::vector<NamedShape> composites() {
  return {
      {.word = "l_plate",
       .help = "A plate of two arms in the xy plane. Its outer corner is the origin. One arm points along +x, the "
               "other along +y.",
       .ways = {{"size", "arm"}},
       .extents = 2,
       .make = [](const ShapeDraft& s) -> Solid {
         return LPlate{twoExtents(s), length(s, "arm")};
       },
       .usual = LPlate{{3, 2}, 0.5}},
      {.word = "t_handle",
       .help = "Two round bars of one density. The bar lies along x, and its centre is the origin. The shaft "
               "leaves the bar's surface along +y.",
       .ways = {{"bar_length", "bar_radius", "shaft_length", "shaft_radius"}},
       .make = tHandle,
       .usual = THandle{3, 0.2, 1.5, 0.2}},
      {.word = "racket",
       .help = "A hoop in the xy plane and a thin handle from its rim along -x, with masses in the ratio 17 : 16. "
               "The origin is the hoop's centre. In `size`, x is the overall length and y is the hoop's width.",
       .ways = {{"size"}, {"length", "width"}},
       .make = racket,
       .usual = Racket{0.685, 0.26}},
      {.word = "wing_nut",
       .help = "A hub about z with its centre at the origin, and two boxes as wings along +x and -x.",
       .ways = {{"hub_radius", "hub_height", "wing", "wing_centre"}},
       .optional = {"wing_rise"},
       .make = wingNut,
       .usual = WingNut{0.5, 1, {1.2, 0.2, 0.9}, 1.1, 0.3}},
      {.word = "mesh",
       .help =
           "The inside of a closed surface of triangles. Each triangle is counter-clockwise, seen from outside. "
           "The file sets axes and origin. Corners that differ only by rounding are joined, with a note. A mesh "
           "that is not closed can be drawn with show.body if the body's moments are given as numbers.",
       .ways = {{"file"}},
       .optional = {"file_unit"}},
  };
}

std::vector<NamedShape> allKinds() {
  std::vector<NamedShape> all;
  for (const auto& some : {solidsWithExtents(), roundSolids(), polyhedra(), composites()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

KeyNames allNames() {
  KeyNames names{"size"};
  for (const LengthKey& key : lengthKeys()) names.push_back(key.name);
  for (const char* name : {"wing", "file", "file_unit"}) names.emplace_back(name);
  return names;
}

}  // namespace

const std::vector<NamedShape>& namedShapes() {
  static const std::vector<NamedShape> kinds = allKinds();
  return kinds;
}

std::vector<std::string_view> shapeWords() {
  std::vector<std::string_view> words;
  for (const NamedShape& kind : namedShapes()) words.push_back(kind.word);
  return words;
}

const std::vector<LengthKey>& lengthKeys() {
  static const std::vector<LengthKey> table = {
      {"radius", "Radius of a round shape. The radius of a torus is that of the circle that its tube follows.",
       "\"10 cm\""},
      {"inner_radius",
       "Radius of the hollow in a sphere or in a cylinder, which is then a tube. By default, there is no hollow.",
       "\"5 cm\""},
      {"height",
       "Height of a shape along z. The height of a capsule is that of the cylinder between its half balls.",
       "\"20 cm\""},
      {"length", "Length of a rod, along x. For a racket, overall length.", "\"68.5 cm\""},
      {"width", "Width of a racket's hoop.", "\"26 cm\""},
      {"edge", "Edge length of a regular polyhedron.", "\"10 cm\""},
      {"wall", "Thickness of a hollow box's walls.", "\"5 mm\""},
      {"tube_radius", "Radius of a torus's tube.", "\"3 cm\""},
      {"arm", "Width of both arms of an L plate.", "\"5 cm\""},
      {"bar_length", "Length of a T-handle's bar, along x.", "\"6 cm\""},
      {"bar_radius", "Radius of a T-handle's bar.", "\"4 mm\""},
      {"shaft_length", "Length of a T-handle's shaft, from the bar's surface along +y.", "\"3 cm\""},
      {"shaft_radius", "Radius of a T-handle's shaft.", "\"4 mm\""},
      {"hub_radius", "Radius of a wing nut's hub.", "\"5 mm\""},
      {"hub_height", "Height of a wing nut's hub, along z.", "\"10 mm\""},
      {"wing_centre", "Distance of a wing's centre from the hub's axis, along x.", "\"11 mm\""},
      {"wing_rise", "Height of the centre of a wing nut's wing above the hub's centre. The default is 0.",
       "\"3 mm\"", true},
  };
  return table;
}

const KeyNames& shapeKeyNames() {
  static const KeyNames names = allNames();
  return names;
}

std::string listed(const KeyNames& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " and ";
    text += names[i];
  }
  return text;
}

std::string described(const NamedShape& kind) {
  std::string text;
  for (const KeyNames& way : kind.ways) text += (text.empty() ? "" : ", or ") + listed(way);
  if (!kind.optional.empty()) text += fmt::format(" (optional: {})", listed(kind.optional));
  return text;
}

}  // namespace poinsot::scene
