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

/// The whole request as values. Made by scene_file.h, never changed afterwards. SI units, radians.
namespace poinsot::scene {

/// A mass without extent; drawn as a small ball.
struct PointMass {};

/// One of the things a body is made of, or drawn as. S: its own axes.
struct Part {
  std::variant<physics::Solid, std::shared_ptr<const geometry::Mesh>, PointMass> figure;
  double mass_kg = 1;
  physics::Quaternion q_BS = physics::Quaternion::Identity();
  Eigen::Vector3d offset_B = Eigen::Vector3d::Zero();  ///< of S's origin, m
};

/// B: the axes the file describes the body in, origin where it says.
struct Body {
  physics::PrincipalAxes axes{physics::PrincipalMoments(Eigen::Vector3d::Ones())};  ///< about the fixed point
  std::optional<physics::MassProperties> mass;  ///< none for bare moments or a bare tensor
  std::optional<Eigen::Vector3d> pivot_B;       ///< the point held fixed; none: the centre of mass
  std::vector<Part> parts;                      ///< none for bare moments or a bare tensor

  /// The point that the body turns about, in B, m.
  Eigen::Vector3d fixedPoint_B() const {
    if (pivot_B) return *pivot_B;
    return mass ? mass->centre_B() : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }
};

enum class LPoints { kAuto, kDown, kUp };

using Flight = physics::Flight;

struct Motion {
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();  ///< at motion time 0, rad/s
  std::optional<physics::Quaternion> orientation_WB;  ///< unit; none: L turned onto the world's vertical
  LPoints lPoints = LPoints::kAuto;
  physics::Forcing forcing;
  double tolerance_rad = 1e-12;  ///< of the attitude over the run, where something acts
  double mostSteps = 2e6;        ///< that the user allows for that (Limit::kSteps)
  std::optional<Flight> flight;
};

/// What was changed of a film so that it repeats without a jump (film_loop.h).
struct Loop {
  double period_s = 0;         ///< motion time after which everything comes back: the film's
  int polhodePeriods = 0;      ///< in that time; 0: a steady spin
  int turns = 0;               ///< about L in that time
  double change = 0;           ///< of omega0 as it is drawn, as a part of its length
  double turned_rad = 0;       ///< its direction in the body
  double speedAsked = 0;       ///< motion seconds per film second before, as asked for or chosen
  double durationAsked_s = 0;  ///< film time before
  double mismatch_rad = 0;     ///< of the attitudes at the two ends: rounding
};

struct Time {
  double start_s = 0;
  double duration_s = 10;  ///< film time
  core::Rational fps{30, 1};
  std::optional<Loop> loop;     ///< the film repeats without a jump; the rest of the scene has been changed for it
  std::optional<double> speed;  ///< motion seconds per film second; none: chosenSpeed() chooses
  std::optional<double> still_s;  ///< film time of the picture that says most; none: a third of the way

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
  double azimuth_rad = 0;                   ///< about the world's vertical (z), from its x axis
  double elevation_rad = 0;                 ///< above the horizontal
  double fov_rad = 0;                       ///< vertical field of view, in perspective
  double zoom = 1;                          ///< 1 frames the whole motion; 2 shows it twice as large
  double orbit_rad = 0;                     ///< added to the azimuth over the film, steadily
  CameraFrame frame = CameraFrame::kSpace;  ///< which axes stand still in the picture
  bool follow = false;                      ///< goes along with a thrown body
};

struct Show {
  std::string title, subtitle;  ///< the TeX subset of text/
  double exaggerateAngles = 1;  ///< > 1: transverse omega is drawn that many times larger, and the picture says so
  bool labels = true;
  struct : Drawn {
    std::vector<Part> parts;  ///< drawn in place of what sets the inertia; only their proportions count
  } body;
  Drawn principalAxes, L, omega;
  struct : Drawn {
    double opacity = 0;
    bool graticule = true;
  } ellipsoid;  ///< its scale is also the plane's: the two are in rad/s and touch
  struct : Drawn {
    double opacity = 0;
    bool grid = true;
  } plane;
  Drawn contact, polhode, height;
  struct : Drawn {
    bool future = true;  ///< the part not yet travelled, faint
  } herpolhode;
  ShownFigures figures;
};

/// One panel of the picture. Of `show`, what is said of the whole picture (title, subtitle, exaggerateAngles) and
/// the shape drawn for the body are the scene's.
struct View {
  Camera camera;
  Show show;
  std::string title, subtitle;  ///< its heading, as the picture's
  GridPlace place;
};

/// Whether a thrown body moves along in a view; else the picture goes with its centre of mass.
inline bool movesAlong(const Motion& motion, const Camera& camera, const Show& show) {
  return motion.flight && show.figures.flight.visible && camera.frame == CameraFrame::kSpace;
}

enum class Theme { kLight, kDark, kPrint };

enum class DecimalSign { kPoint, kComma };

struct Style {
  Theme theme = Theme::kLight;
  GivenColors colors;
  double lineWidth = 1;                           ///< factor on all lines
  double textSize = 1;                            ///< factor on all type
  DecimalSign decimalSign = DecimalSign::kPoint;  ///< in numbers that are drawn
};

struct Output {
  int width = 1920;
  int height = 1080;
  int crf = 18;                   ///< of a film, x264's constant rate factor: 0 (lossless) to 51
  std::string codec;              ///< of a film; empty: what its file usually holds
  std::string chroma = "4:2:0";   ///< of a film
  std::string effort = "medium";  ///< of a film's encoder
};

/// A file that the scene names.
struct InputFile {
  std::string path;  ///< as the scene has it
  core::Digest digest{};
  std::filesystem::path place{};  ///< where it was found, from the current folder
};

struct Scene {
  std::string name;               ///< the file's name without folder and extension
  std::vector<InputFile> inputs;  ///< that were read, in the order they were
  std::vector<Doubt> doubts;      ///< in the order of the file
  Body body;
  Motion motion;
  Time time;
  Camera camera;            ///< from which the views' cameras start
  Show show;                ///< of the whole picture, and from which the views' start
  std::vector<View> views;  ///< with the plots at least one panel, no two in one cell
  bool ownViews = false;    ///< from [[view]] tables, each with a camera of its own
  std::vector<Plot> plots;
  std::vector<Readout> readouts;
  LabelTexts labels;                 ///< of every view
  std::vector<NamedVector> vectors;  ///< in every view
  std::vector<NamedAngle> angles;    ///< in every view
  std::vector<Note> notes;
  Timeline timeline;
  Style style;
  Output output;
};

}  // namespace poinsot::scene
