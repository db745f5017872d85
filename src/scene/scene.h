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
#include "geometry/mesh.h"
#include "physics/flight.h"
#include "physics/forcing.h"
#include "physics/mass_properties.h"
#include "physics/principal_axes.h"
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

/// Scenes as validated values, in SI units and radians. scene_file.h makes them.
namespace poinsot::scene {

/// Mass without extent, drawn as a small ball.
struct PointMass {};

/// One of the objects that a body is made of, or drawn as. S denotes the object's own axes.
struct Part {
  std::variant<physics::Solid, std::shared_ptr<const geometry::Mesh>, PointMass> figure;
  double mass_kg = 1;
  physics::Quaternion q_BS = physics::Quaternion::Identity();
  Eigen::Vector3d offset_B = Eigen::Vector3d::Zero();  ///< position of S's origin, m
};

/// Rigid body. B denotes the axes and the origin in which the scene file describes the body.
struct Body {
  physics::PrincipalAxes axes{physics::PrincipalMoments(Eigen::Vector3d::Ones())};  ///< about the fixed point
  std::optional<physics::MassProperties> mass;  ///< nullopt for bare moments or a bare tensor
  std::optional<Eigen::Vector3d> pivot_B;       ///< point held fixed; nullopt: the centre of mass
  std::vector<Part> parts;                      ///< empty for bare moments or a bare tensor

  /// Returns the point about which the body turns, in m.
  Eigen::Vector3d fixedPoint_B() const {
    if (pivot_B) return *pivot_B;
    return mass ? mass->centre_B() : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }
};

enum class LPoints { kAuto, kDown, kUp };

using Flight = physics::Flight;

struct Motion {
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();  ///< angular velocity at motion time 0, rad/s
  std::optional<physics::Quaternion> orientation_WB;  ///< unit; nullopt: L is turned onto the world's vertical
  LPoints lPoints = LPoints::kAuto;
  physics::Forcing forcing;
  double tolerance_rad = 1e-12;  ///< allowed error of the attitude over a driven motion
  double mostSteps = 2e6;        ///< largest number of integration steps (Limit::kSteps)
  std::optional<Flight> flight;
};

/// Changes made to a film so that it repeats without a jump (film_loop.h).
struct Loop {
  double period_s = 0;         ///< motion time of the film, after which the whole state repeats
  int polhodePeriods = 0;      ///< number of periods until the state repeats; 0: a steady spin
  int turns = 0;               ///< turns about L until the state repeats
  double change = 0;           ///< change of omega0 as drawn, relative to its length
  double turned_rad = 0;       ///< angle between the old and new omega0 in the body
  double speedAsked = 0;       ///< motion seconds per film second before the change, as requested or chosen
  double durationAsked_s = 0;  ///< film time before the change
  double mismatch_rad = 0;     ///< angle between the attitudes at the two ends, due to rounding
};

struct Time {
  double start_s = 0;
  double duration_s = 10;  ///< in film time
  core::Rational fps{30, 1};
  std::optional<Loop> loop;       ///< set for a film that repeats without a jump; the scene was adjusted for it
  std::optional<double> speed;    ///< motion seconds per film second; nullopt: chosenSpeed() decides
  std::optional<double> still_s;  ///< film time of the most telling picture; nullopt: a third of the duration

  double stillTime_s() const { return std::min(still_s.value_or(duration_s / 3), duration_s); }
};

enum class CameraFrame {
  kSpace,
  kBody,
  kPrecession,  ///< turns about L with the axis of a free symmetric top: L, omega and the axis stand still
};

enum class Projection { kPerspective, kOrthographic };

struct Camera {
  Projection projection = Projection::kPerspective;
  double azimuth_rad = 0;                   ///< angle about the world's vertical (z), from its x axis
  double elevation_rad = 0;                 ///< angle above the horizontal
  double fov_rad = 0;                       ///< vertical field of view, in perspective
  double zoom = 1;                          ///< 1 frames the whole motion; 2 shows it twice as large
  double orbit_rad = 0;                     ///< added to the azimuth over the film, at a constant rate
  CameraFrame frame = CameraFrame::kSpace;  ///< axes that stand still in the picture
  bool follow = false;                      ///< moves along with a thrown body
};

struct Show {
  std::string title, subtitle;  ///< in the TeX subset of the text library
  double exaggerateAngles = 1;  ///< > 1: draws transverse omega that many times larger, as the picture states
  bool labels = true;
  struct : Drawn {
    std::vector<Part> parts;  ///< drawn instead of the parts that define the inertia; only proportions matter
  } body;
  Drawn principalAxes, L, omega;
  struct : Drawn {
    double opacity = 0;
    bool graticule = true;
  } ellipsoid;  ///< `scale` also applies to the plane: both are in rad/s and touch
  struct : Drawn {
    double opacity = 0;
    bool grid = true;
  } plane;
  Drawn contact, polhode, height;
  struct : Drawn {
    bool future = true;  ///< also draws the part not yet travelled, faintly
  } herpolhode;
  ShownFigures figures;
};

/// One panel of the picture. The title, subtitle, exaggerateAngles and drawn shape in `show` are the scene's for
/// all views.
struct View {
  Camera camera;
  Show show;
  std::string title, subtitle;
  GridPlace place;
};

/// Returns whether a thrown body moves through the view. Otherwise the view follows the centre of mass.
inline bool movesAlong(const Motion& motion, const Camera& camera, const Show& show) {
  return motion.flight && show.figures.flight.visible && camera.frame == CameraFrame::kSpace;
}

enum class Theme { kLight, kDark, kPrint };

enum class DecimalSign { kPoint, kComma };

struct Style {
  Theme theme = Theme::kLight;
  GivenColors colors;
  double lineWidth = 1;                           ///< factor on all line widths
  double textSize = 1;                            ///< factor on all type sizes
  DecimalSign decimalSign = DecimalSign::kPoint;  ///< decimal sign of drawn numbers
};

struct Output {
  int width = 1920;
  int height = 1080;
  int crf = 18;       ///< constant rate factor of the film (x264's scale): 0 (lossless) to 51
  std::string codec;  ///< codec of a film; empty: the default of its container
  std::string chroma = "4:2:0";
  std::string effort = "medium";
};

struct InputFile {
  std::string path;  ///< path as written in the scene
  core::Digest digest{};
  std::filesystem::path place{};  ///< path of the file as found, relative to the current folder
};

struct Scene {
  std::string name;  ///< file name without folder and extension
  std::vector<InputFile> inputs;
  std::vector<Doubt> doubts;  ///< notes in the order of the scene file
  Body body;
  Motion motion;
  Time time;
  Camera camera;            ///< initial camera of every view
  Show show;                ///< contents of the whole picture; the views start as copies
  std::vector<View> views;  ///< views and plots form at least one panel and do not overlap
  bool ownViews = false;    ///< made from [[view]] tables, each with a camera of its own
  std::vector<Plot> plots;
  std::vector<Readout> readouts;
  LabelTexts labels;                 ///< texts of the labels in every view
  std::vector<NamedVector> vectors;  ///< drawn in every view
  std::vector<NamedAngle> angles;    ///< drawn in every view
  std::vector<Note> notes;
  Timeline timeline;
  Style style;
  Output output;
};

}  // namespace poinsot::scene
