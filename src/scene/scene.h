// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/rational.h"
#include "core/sha256.h"
#include "core/vector2.h"
#include "geometry/mesh.h"
#include "physics/catalogue.h"
#include "physics/flight.h"
#include "physics/forcing.h"
#include "physics/mass_properties.h"
#include "physics/principal_axes.h"
#include "physics/rolling_cone.h"
#include "physics/unaligned_types.h"
#include "scene/document/problem.h"
#include "scene/grid_place.h"
#include "scene/keys/label_text.h"
#include "scene/named_figures.h"
#include "scene/note.h"
#include "scene/plot.h"
#include "scene/shown_figures.h"
#include "scene/style_colors.h"
#include "scene/timeline.h"

/// Scenes as validated values, in SI units and radians. The functions in scene_file.h create them.
namespace poinsot::scene {

/// Mass without extent. The picture shows it as a small ball.
struct PointMass {};

/// Solid, mesh or point mass as a part of a body. S denotes the part's own axes.
struct Part {
  std::variant<physics::Solid, std::shared_ptr<const geometry::Mesh>, PointMass> figure;
  double mass_kg = 1;
  physics::Quaternion q_BS = physics::Quaternion::Identity();
  Eigen::Vector3d offset_B = Eigen::Vector3d::Zero();  ///< position of the origin of S, m
};

/// Coloured shape on a body, such as the camera of a phone. It has no mass and is only drawn.
struct BodyMark {
  Part part;  ///< its mass has no meaning
  physics::MarkTone tone = physics::MarkTone::kDark;
  std::optional<std::uint32_t> color;  ///< 0xRRGGBB in sRGB; nullopt for the colour of the tone
};

/// Rigid body. B denotes the axes and the origin that the scene file uses to describe the body.
struct Body {
  physics::PrincipalAxes axes{physics::PrincipalMoments(Eigen::Vector3d::Ones())};  ///< about the fixed point
  std::optional<physics::MassProperties> mass;  ///< nullopt if only moments or a tensor are given
  std::optional<Eigen::Vector3d> pivot_B;       ///< fixed point of the body; nullopt for the centre of mass
  std::optional<physics::Quaternion> q_BA;      ///< takes components along the scene's own axes A to B (eq 15, 16)
  std::vector<Part> parts;                      ///< empty if only moments or a tensor are given
  std::vector<BodyMark> marks;                  ///< marks that fit the drawn parts

  /// Returns the point about which the body turns, in m.
  Eigen::Vector3d fixedPoint_B() const {
    if (pivot_B) return *pivot_B;
    return mass ? mass->centre_B() : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }
};

enum class LPoints { kAuto, kDown, kUp };

using Flight = physics::Flight;

/// Cone that rolls on a table, whose points of contact are at rest.
struct Rolling {
  physics::RollingCone cone;
  double g = 9.80665;   ///< acceleration of gravity, m/s², which sets the place of the normal force
  double centre_m = 0;  ///< distance of the centre of mass from the apex
};

struct Motion {
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();  ///< angular velocity at motion time 0, rad/s
  std::optional<physics::Quaternion> orientation_WB;  ///< unit quaternion; nullopt: L is made vertical
  LPoints lPoints = LPoints::kAuto;
  physics::Forcing forcing;
  std::vector<std::string> forceNames;  ///< label of each force of `forcing`; empty for none
  double tolerance_rad = 1e-12;         ///< allowed error of the attitude in a driven motion
  double mostSteps = 2e6;               ///< largest number of integration steps (Limit::kSteps)
  std::optional<Flight> flight;
  std::optional<Rolling> rolling;
  std::optional<Eigen::Vector3d> thrownBy_B;  ///< point K of a thrown body whose start the scene gives (eq 4), m

  /// Returns whether no torque acts on the body, so that the motion is free.
  bool isFree() const { return forcing.none() && !rolling; }
};

/// Record of the changes to a scene that make its film repeat without a jump (film_loop.h).
struct Loop {
  double period_s = 0;              ///< motion time of the film, after which the complete state repeats
  int polhodePeriods = 0;           ///< periods of the polhode until the state repeats; 0 for a steady spin
  int turns = 0;                    ///< turns until the state repeats: about L, or of a top about the vertical
  double change = 0;                ///< length of the change of drawn omega at the start, relative to omega
  double turned_rad = 0;            ///< angle between the old and the new omega, in the body
  std::optional<double> spinAsked;  ///< spin of a top about its axis before the change, rad/s; free motion: none
  double speedAsked = 0;            ///< motion seconds per film second before the change
  double durationAsked_s = 0;       ///< film time before the change
  double mismatch_rad = 0;          ///< angle between the attitudes at both ends, due to rounding errors
};

struct Time {
  double start_s = 0;
  double duration_s = 10;  ///< length of the film, in film time
  core::Rational fps{30, 1};
  std::optional<Loop> loop;       ///< set if the scene was changed so that its film repeats
  std::optional<double> speed;    ///< motion seconds per film second; nullopt for the result of chosenSpeed()
  std::optional<double> still_s;  ///< film time of the default still; nullopt for a third of the duration

  double stillTime_s() const { return std::min(still_s.value_or(duration_s / 3), duration_s); }
};

enum class CameraFrame {
  kSpace,
  kBody,
  kPrecession,  ///< turns about L with the axis of a free symmetric top, so that L, omega and the axis are fixed
};

enum class Projection { kPerspective, kOrthographic };

struct Camera {
  Projection projection = Projection::kPerspective;
  double azimuth_rad = 0;                       ///< angle about the vertical z axis, from the x axis
  double elevation_rad = 0;                     ///< angle above the horizontal plane
  double fov_rad = 0;                           ///< vertical field of view of a perspective
  double zoom = 1;                              ///< 1 fits the complete motion into the view; 2 is twice as large
  core::Vector2 shift = core::Vector2::Zero();  ///< shift of the picture to the right and up, as fractions of the
                                                ///< panel's width and height
  double orbit_rad = 0;  ///< angle that is added to the azimuth over the film, at a constant rate
  CameraFrame frame = CameraFrame::kSpace;  ///< axes that are fixed in the picture
  bool follow = false;                      ///< whether the camera moves with a thrown body
};

static_assert(core::laidOut<Camera, 72>());

struct Show {
  std::string title, subtitle;  ///< text in the TeX subset of the text library
  double exaggerateAngles = 1;  ///< factor on transverse omega; if above 1, the picture states it
  bool labels = true;
  std::optional<bool> captions;  ///< whether captions are drawn; nullopt: in films and stills, not in figures
  struct : Drawn {
    std::vector<Part> parts;  ///< parts to draw instead of those of Body; only their proportions matter
  } body;
  struct : Drawn {
    std::vector<int> axes{0, 1, 2};  ///< indices of the axes that are drawn
  } principalAxes;
  Drawn L, omega;
  struct : Drawn {
    double opacity = 0;
    bool graticule = true;
  } ellipsoid;  ///< ellipsoid in the space of omega; `scale` also applies to the plane that it touches
  struct : Drawn {
    double opacity = 0;
    bool grid = true;
  } plane;
  Drawn contact, polhode, height;
  struct : Drawn {
    bool future = true;  ///< whether the curve after the current instant is drawn too, faintly
  } herpolhode;
  ShownFigures figures;
};

/// Panel of the picture. In `show`, the title, subtitle, exaggerateAngles and drawn shape are equal for all views.
struct View {
  Camera camera;
  Show show;
  std::string title, subtitle;
  GridPlace place;
};

/// Returns whether a thrown body moves through the view. If not, the view follows the centre of mass.
inline bool movesAlong(const Motion& motion, const Camera& camera, const Show& show) {
  return motion.flight && show.figures.flight.visible && camera.frame == CameraFrame::kSpace;
}

enum class Theme { kLight, kDark, kPrint };

enum class DecimalSign { kPoint, kComma };

enum class StylePreset {
  kScreen,
  kHall,  ///< large type and thick lines, for the last row of a lecture hall
};

struct Style {
  Theme theme = Theme::kLight;
  StylePreset preset = StylePreset::kScreen;
  GivenColors colors;
  double lineWidth = 1;  ///< factor on the widths of all lines
  double textSize = 1;   ///< factor on the sizes of all letters
  DecimalSign decimalSign = DecimalSign::kPoint;
};

/// Returns the value of the key style.line_width: lineWidth without the factors of the theme and the preset.
double lineWidthKey(const Style& style);

/// Language of the description of a picture. The order is the order of the key's words.
enum class Language { kEnglish, kGerman };

struct Output {
  int width = 1920;
  int height = 1080;
  int crf = 18;       ///< constant rate factor of the film on x264's scale, from 0 (lossless) to 51
  std::string codec;  ///< codec of a film; empty for the default of the film's container
  std::string chroma = "4:2:0";
  std::string effort = "medium";
  int colors = 255;  ///< colours in the palette of a GIF, from 2 to 255
  Language language = Language::kEnglish;
};

struct InputFile {
  std::string path;  ///< path as written in the scene
  core::Digest digest{};
  std::filesystem::path place{};  ///< path of the file that was read, relative to the current folder
};

struct Scene {
  std::string name;  ///< name of the file without folder and extension
  std::vector<InputFile> inputs;
  std::vector<Doubt> doubts;  ///< notes in the order of the scene file
  Body body;
  Motion motion;
  Time time;
  Camera camera;            ///< camera of the scene; the views start from it
  Show show;                ///< visible things of the scene; the views start as copies
  std::vector<View> views;  ///< views of the picture; together with the plots at least one panel, without overlaps
  bool ownViews = false;    ///< whether the views come from [[view]] tables and have cameras of their own
  std::vector<Plot> plots;
  std::vector<Readout> readouts;
  LabelTexts labels;                 ///< texts of the labels in all views
  std::vector<NamedVector> vectors;  ///< vectors that all views show
  std::vector<NamedAngle> angles;    ///< angles that all views show
  std::vector<Note> notes;
  Timeline timeline;
  Style style;
  Output output;
};

/// Returns the vector from the fixed point of a scene's body to the point K by which the body is thrown (eq 4), in
/// B, m. Zero if the scene gives no such point: then R, V and r are those of the fixed point.
inline Eigen::Vector3d referencePoint_B(const Scene& scene) {
  const Eigen::Vector3d fixed_B = scene.body.fixedPoint_B();
  return scene.motion.thrownBy_B.value_or(fixed_B) - fixed_B;
}

}  // namespace poinsot::scene
