// SPDX-License-Identifier: Apache-2.0
#include "physics/catalogue.h"

#include <algorithm>
#include <numbers>

#include "physics/earth.h"

namespace poinsot::physics {
namespace {

using Eigen::Vector3d;

constexpr double kInch = 0.0254, kOunce = 0.028349523125;  // in m and kg, exact by definition
constexpr double kAluminium = 2700, kSteel = 7850;  // densities in kg/m³, rounded values of engineering tables

SolidPart whole(const Solid& solid, double mass_kg, const Vector3d& offset_B = Vector3d::Zero()) {
  SolidPart part{solid, mass_kg};
  part.offset_B = offset_B;
  return part;
}

SolidMark mark(const Solid& solid, const Vector3d& offset_B, MarkTone tone = MarkTone::kDark) {
  return {whole(solid, 0, offset_B), tone};
}

CatalogueBody tHandle() {
  const THandle solid{.090, .006, .045, .006};
  const double mass_kg = volume(solid) * kAluminium;
  return {"t_handle",
          "T-handle",
          mass_kg,
          partsOf(solid, mass_kg),
          {},
          "Assumed: bars of 12 mm, 90 mm and 45 mm long, of aluminium (2700 kg/m³). They are modelled on the "
          "handle that flips in films from space stations, whose dimensions are not published. Computed: mass "
          "0.0412 kg, moments."};
}

CatalogueBody racket() {
  return {
      "racket",
      "Tennis racket",
      0.33,
      {whole(Racket{.68, .26}, 0.33)},
      {},
      "Assumed: a hoop of 0.26 m with 0.17 kg and a thin handle of 0.42 m with 0.16 kg. The overall length is "
      "0.68 m. These sizes are within the limits of the ITF Rules of Tennis, appendix II (0.737 m by 0.317 m). "
      "Computed: moments. Strings are left out, and the balance is further from the butt than on most rackets.",
      {mark(Cylinder{.05, .003}, {0, 0, .003}), mark(Cylinder{.05, .003}, {0, 0, -.003}, MarkTone::kLight)}};
}

CatalogueBody book() {
  const Box solid{{.210, .148, .020}};
  const double mass_kg = 200 * .080 * (.210 * .148);
  return {
      "book",
      "Book",
      mass_kg,
      {whole(solid, mass_kg)},
      {},
      "Published: ISO 216, sheets of A5, 210 mm by 148 mm. Assumed: 200 sheets of 80 g/m² and 0.1 mm, without a "
      "cover. Computed: 20 mm thick, 0.497 kg, moments of a uniform box.",
      // a dark front cover with a title, and pages that show beyond the cover everywhere but at the spine
      {mark(Box{{.207, .145, .001}}, {0, 0, .010}),
       mark(Box{{.040, .100, .001}}, {.055, 0, .0108}, MarkTone::kLight),
       mark(Box{{.211, .1485, .015}}, {0, .0005, 0}, MarkTone::kLight)}};
}

CatalogueBody phone() {
  return {
      "phone",
      "Phone",
      0.171,
      {whole(Box{{.0716, .1476, .0078}}, 0.171)},
      {},
      "Published by the maker: iPhone 15, 147.6 mm by 71.6 mm by 7.8 mm, 171 g. Assumed: a uniform box. Computed: "
      "moments. Its long axis is y.",
      // a dark screen in front, and a dark camera with two lenses on the back
      {mark(Box{{.0656, .1416, .0008}}, {0, 0, .0039}), mark(Box{{.030, .030, .003}}, {.016, .052, -.0039}),
       mark(Cylinder{.006, .002}, {.0095, .0585, -.0054}, MarkTone::kLight),
       mark(Cylinder{.006, .002}, {.0225, .0455, -.0054}, MarkTone::kLight)}};
}

CatalogueBody football() {
  const double mass_kg = 14.5 * kOunce, half = 11.125 * kInch / 2,
               radius = 21.125 * kInch / (2 * std::numbers::pi);
  const Vector3d semiAxes(radius, radius, half);
  const Eigen::Matrix3d hull_B = massProperties(EllipsoidShell{semiAxes}, mass_kg).inertia_B();
  return {"football",
          "American football",
          mass_kg,
          {whole(Ellipsoid{semiAxes}, mass_kg)},  // only for drawing; a shell would be drawn open
          PrincipalMoments(Vector3d(hull_B.diagonal())),
          "Published: NFL Playing Rules, rule 2. The middle of each range is used: long axis 11 to 11 1/4 in, "
          "short circumference 21 to 21 1/4 in, 14 to 15 oz. Assumed: a thin shell between similar ellipsoids; a "
          "real ball has pointed ends and a bladder. Computed: moments. Its long axis is z."};
}

CatalogueBody frisbee() {
  const double radius = .137, depth = .025;
  return {"frisbee",
          "Flying disc",
          0.175,
          {whole(Disc{radius}, .1, {0, 0, depth / 2}), whole(CylinderShell{radius, depth}, .075)},
          PrincipalMoments({.001219, .001219, .002352}),
          "Published: 175 g, the weight of discs approved for Ultimate. The moments were measured by S. A. "
          "Hummel, Frisbee Flight Simulation and Throw Biomechanics, thesis, University of California, Davis, "
          "2003. They are quoted from the program FrisPy, because the thesis itself was not available. Assumed, "
          "for drawing only: a plate of 274 mm with a rim of 25 mm."};
}

CatalogueBody wingNut() {
  const WingNut solid{.010, .010, {.0145, .004, .017}, .01725, .0095};
  const double mass_kg = volume(solid) * kSteel;
  return {"wing_nut",
          "Wing nut",
          mass_kg,
          partsOf(solid, mass_kg),
          {},
          "Published: DIN 314, size M10. Span 47 to 50 mm, hub 18 to 21 mm across and 8 to 10 mm high. Wings at "
          "most 4 mm thick, 22 to 24 mm over all. Assumed: a hub without its hole, boxes for wings, steel (7850 "
          "kg/m³). Computed: mass 0.0401 kg, moments."};
}

CatalogueBody explorer1() {
  return {"explorer_1",
          "Explorer 1",
          13.97,
          {whole(Cylinder{.076, 2.03}, 13.97)},
          {},
          "Published by NASA: 13.97 kg, 203 cm long, 15.2 cm across. Assumed: a uniform cylinder without "
          "its four whip antennas. Computed: moments. Its long axis is z."};
}

CatalogueBody earthBody() {
  const double equator = earth::kEquatorialRadius_m, pole = equator * (1 - 1 / earth::kInverseFlattening);
  const double C = earth::kPolarMoment, A = C * (1 - earth::kDynamicalFlattening);
  const double mass_kg = earth::kGM / earth::kGravitation;
  return {"earth",
          "Earth",
          mass_kg,
          {whole(Ellipsoid{{equator, equator, pole}}, mass_kg)},
          PrincipalMoments({A, A, C}),
          "Published: polar moment C = 8.0365e37 kg·m² (E. Groten, J. Geodesy 77 (2004) 724). Also published: "
          "dynamical flattening H = (C - A)/C = 0.003273795, GM, G, equatorial radius and flattening of the IERS "
          "Conventions (2010), table 1.1. Computed: A = C (1 - H), the mean of the two equatorial moments; mass "
          "GM/G. Assumed: rigid and symmetric. The difference B - A = 7.26e-6 M R² (Liu & Chao, Geophys. J. Int. "
          "106 (1991) 699) is left out. Therefore, this Earth wobbles in A/(C - A) = 304.46 sidereal days. The "
          "real one takes 433 days. Its fluid core shortens the period, and its elasticity and its oceans "
          "lengthen it by more (Smith & Dahlen, Geophys. J. R. astr. Soc. 64 (1981) 223). The command info prints "
          "the periods of an elastic Earth and of one with a fluid core."};
}

CatalogueBody toutatis() {
  // Only ratios of the moments are published. The moment about the long axis is therefore computed from an
  // ellipsoid of the published size.
  const Ellipsoid figure{{1200, 960, 2300}};
  const double mass_kg = 1.9e13, longAxis = massProperties(figure, mass_kg).inertia_B()(2, 2);
  return {
      "toutatis",
      "Asteroid 4179 Toutatis",
      mass_kg,
      {whole(figure, mass_kg)},
      PrincipalMoments(Vector3d(3.0836, 3.235, 1) * longAxis),
      "Published: ratios of the moments 3.0836 : 3.235 : 1 (Y. Takahashi, M. W. Busch, D. J. Scheeres, Astron. J. "
      "146 (2013) 95). Also published: size 1.92 km by 2.40 km by 4.60 km (R. S. Hudson, S. J. Ostro, Science 270 "
      "(1995) 84). Assumed: mass 1.9e13 kg and the moment about the long axis, z, of an ellipsoid of that size; "
      "free motion depends on the ratios only. Drawn as that ellipsoid; the real body has two lobes."};
}

}  // namespace

const std::vector<CatalogueBody>& catalogue() {
  static const std::vector<CatalogueBody> kBodies = {tHandle(), racket(),  book(),      phone(),     football(),
                                                     frisbee(), wingNut(), explorer1(), earthBody(), toutatis()};
  return kBodies;
}

const CatalogueBody* findCatalogueBody(std::string_view name) {
  const auto found = std::ranges::find(catalogue(), name, &CatalogueBody::name);
  return found == catalogue().end() ? nullptr : &*found;
}

MassProperties massProperties(const CatalogueBody& body) {
  if (body.moments) return {body.mass_kg, Vector3d::Zero(), body.moments->values().asDiagonal().toDenseMatrix()};
  std::vector<MassProperties> pieces;
  for (const SolidPart& part : body.parts) pieces.push_back(massProperties(part));
  return combined(pieces);
}

}  // namespace poinsot::physics
