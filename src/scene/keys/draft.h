// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/euler_angles.h"
#include "physics/heavy_top.h"
#include "physics/mean_periods.h"
#include "physics/unaligned_types.h"
#include "scene/scene.h"

/// Scene while its keys are being read, in SI units. A value that needs no other key is stored in Draft::scene. A
/// value that depends on other keys is stored in the other members, until assemble.h combines them.
namespace poinsot::scene {

/// Values of the keys of a shape, in [body], [[body.part]] or [show.body].
struct ShapeDraft {
  std::optional<int> word;                     ///< index of the shape in shapeWords()
  std::optional<std::vector<double>> size;     ///< two or three extents; one if all are equal
  std::map<std::string_view, double> lengths;  ///< lengths by the name of the key, such as "radius"
  std::optional<Eigen::Vector3d> wing;
  std::optional<std::string> file;
  std::optional<double> fileUnit_m;
};

struct PieceDraft {
  ShapeDraft shape;
  std::optional<double> mass, density;
  std::optional<Eigen::Vector3d> offset, axis;
  std::optional<physics::Quaternion> rotation;
  std::optional<double> angle;
};

struct MarkDraft {
  PieceDraft piece;
  std::optional<std::uint32_t> color;
};

struct PointDraft {
  std::optional<double> mass;
  std::optional<Eigen::Vector3d> position;
};

/// Point to which given moments of inertia refer. The order is the order of the key's words.
enum class MomentsAbout { kCentreOfMass, kOrigin, kPivot };

/// Values of the keys that give axes of one's own. A valid scene uses one of several ways to give them.
struct OwnAxesDraft {
  std::optional<physics::Quaternion> rotation;
  std::optional<Eigen::Vector3d> rollPitchYaw, x, y;
};

struct BodyDraft {
  std::optional<Eigen::Vector3d> moments;
  std::optional<Eigen::Matrix3d> inertia;
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();  ///< centre of mass, for a body given by moments or a tensor
  MomentsAbout momentsAbout = MomentsAbout::kCentreOfMass;
  std::optional<int> catalogue;  ///< index of the body in physics::catalogue()
  PieceDraft whole;
  std::vector<PieceDraft> parts;
  std::vector<PointDraft> points;
  OwnAxesDraft ownAxes;
};

/// One of the two steady precessions of a heavy top. The order is the order of the key's words.
enum class PrecessionWord { kSlow, kFast };

/// Values of the keys that give the start of the motion. A valid scene uses one of several ways to give it.
struct StartDraft {
  std::optional<Eigen::Vector3d> omega_B, omega_W, L_B, L_W;
  std::optional<double> spin, tilt, tiltTowards;
  int spinAxis = 0;  ///< 0, 1, 2: principal axis; 3, 4, 5: axis of the smallest, middle, largest moment
  std::optional<double> energy, L, phase;
  int branch = 0;  ///< half of the axis that the polhode encloses; 0: positive, 1: negative
  std::optional<double> periodPhi, periodPsi;
  std::optional<physics::AxisMode> mode;
  physics::EulerAngles euler, eulerRates;
  std::optional<Eigen::Vector3d> rollPitchYaw;
  std::optional<double> lean;
  std::optional<PrecessionWord> steady;  ///< steady precession of a heavy top with a spin
  std::optional<double> precession;      ///< rate of a steady precession, without a spin
  std::optional<physics::NutationKind> nutation;
};

struct TorqueStepDraft {
  std::optional<double> from;
  std::optional<Eigen::Vector3d> torque_B, torque_W;
};

struct PointForceDraft {
  std::optional<Eigen::Vector3d> at_B, force_B, force_W;
  std::optional<double> from, to;
  std::optional<std::string> name;
};

struct ForcingDraft {
  std::optional<Eigen::Vector3d> mgr_B, torque_B, torque_W, dragRates;
  std::optional<double> g, dissipation;
  std::optional<std::string> torqueFile;
  int fileAxes = 0;       ///< axes of the torque file; 0: body, 1: space
  int interpolation = 0;  ///< of the torque between two times of the file; 0: linear, 1: steps
  std::vector<TorqueStepDraft> steps;
  std::vector<PointForceDraft> forces;
};

struct FlightDraft {
  std::optional<Eigen::Vector3d> point, position, velocity, gravity;
};

struct RollingDraft {
  std::optional<double> rate, g;
};

struct VectorDraft {
  std::string name;
  std::optional<Eigen::Vector3d> components, position, velocity;
  VectorFrame frame = VectorFrame::kSpace;
  double scale = 1;
  Meaning color = Meaning::kVector;
};

struct AngleDraft {
  std::string name;
  std::vector<Direction> between;
  double scale = 1;
};

/// Values of the keys of one timeline entry. `shown` and `hidden` are indices into timelineThings().
struct TimelineDraft {
  std::optional<Moment> at, around;
  std::optional<double> atMotion, over, captionFor, speed, speedFor, hold, azimuth, turn, elevation, zoom;
  std::vector<int> shown, hidden;
  std::optional<std::string> caption;
};

struct Draft;

/// Values of the keys of a view. Camera and visible things of a view start as copies of the scene's.
struct ViewDraft {
  std::string title, subtitle;
  std::optional<Eigen::Vector2i> at, span;
  std::vector<std::function<void(Draft&)>>
      given;  ///< one function for each key that the view sets; it stores the value in a draft
};

/// Values of the keys of a plot. A value that depends on other keys is stored outside `plot`.
struct PlotDraft {
  Plot plot;
  std::optional<std::vector<double>> range;
  std::optional<Eigen::Vector2i> at, span;
};

struct Draft {
  Scene scene;
  BodyDraft body;
  StartDraft start;
  ForcingDraft forcing;
  FlightDraft flight;
  RollingDraft rolling;
  ShapeDraft drawn;
  std::optional<int> preset;  ///< index of the camera's preset in cameraPresets()
  std::optional<std::vector<CameraFrame>> frames;
  bool noViews = false;
  std::vector<ViewDraft> views;
  std::vector<MarkDraft> marks;
  std::vector<VectorDraft> vectors;
  std::vector<AngleDraft> angles;
  std::vector<PlotDraft> plots;
  std::vector<Readout> readouts;
  std::vector<Note> notes;
  std::vector<TimelineDraft> timeline;
  bool loop = false;
  int quality = 0;  ///< index of the preset in qualityPresets()
  std::optional<Eigen::Vector2i> size_px;
  std::optional<int> crf;
  std::optional<int> codec;    ///< index of the codec in codecWords()
  int chroma = 0, effort = 1;  ///< indices into chromaWords() and effortWords()
};

/// Returns element i. If the vector is too short, first extends it to i + 1 elements.
template <class T>
T& elementAt(std::vector<T>& elements, std::size_t i) {
  if (elements.size() <= i) elements.resize(i + 1);
  return elements[i];
}

}  // namespace poinsot::scene
