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

#include "physics/unaligned_types.h"
#include "scene/scene.h"

/// Scene while its keys are being read, in SI units. Final values go straight into Draft::scene. Values that
/// several keys decide together wait for assemble.h.
namespace poinsot::scene {

/// Keys of a shape in [body], [[body.part]] or [show.body].
struct ShapeDraft {
  std::optional<int> word;                     ///< index into shapeWords()
  std::optional<std::vector<double>> size;     ///< two or three extents, or one for all
  std::map<std::string_view, double> lengths;  ///< by key, such as "radius"
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

struct PointDraft {
  std::optional<double> mass;
  std::optional<Eigen::Vector3d> position;
};

/// Point that measured moments are about, in the order of the key's words.
enum class MomentsAbout { kCentreOfMass, kOrigin, kPivot };

struct BodyDraft {
  std::optional<Eigen::Vector3d> moments;
  std::optional<Eigen::Matrix3d> inertia;
  Eigen::Vector3d centre_B = Eigen::Vector3d::Zero();  ///< centre of mass, given beside moments or a tensor
  MomentsAbout momentsAbout = MomentsAbout::kCentreOfMass;
  std::optional<int> catalogue;  ///< index into physics::catalogue()
  PieceDraft whole;
  std::vector<PieceDraft> parts;
  std::vector<PointDraft> points;
};

/// Keys of all ways to give a start, of which a valid scene uses one.
struct StartDraft {
  std::optional<Eigen::Vector3d> omega_B, omega_W, L_B, L_W;
  std::optional<double> spin, tilt, tiltTowards;
  int spinAxis = 0;  ///< 0 to 2: axis of P; 3 to 5: axis of the smallest, middle, largest moment
  std::optional<double> energy, L, phase;
  int branch = 0;  ///< 0: positive, 1: negative
};

struct TorqueStepDraft {
  std::optional<double> from;
  std::optional<Eigen::Vector3d> torque_B, torque_W;
};

struct ForcingDraft {
  std::optional<Eigen::Vector3d> mgr_B, torque_B, torque_W, dragRates;
  std::optional<double> g, dissipation;
  std::optional<std::string> torqueFile;
  int fileAxes = 0;       ///< 0: body axes, 1: space axes
  int interpolation = 0;  ///< 0: linear, 1: steps
  std::vector<TorqueStepDraft> steps;
};

struct FlightDraft {
  std::optional<Eigen::Vector3d> position, velocity, gravity;
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

/// Entry of the timeline. `shown` and `hidden` are indices into timelineThings().
struct TimelineDraft {
  std::optional<double> at, over, captionFor, speed, hold, azimuth, turn, elevation, zoom;
  std::vector<int> shown, hidden;
  std::optional<std::string> caption;
};

struct Draft;

/// Keys of a view. Its camera and its shown things start as copies of the scene's.
struct ViewDraft {
  std::string title, subtitle;
  std::optional<Eigen::Vector2i> at, span;
  std::vector<std::function<void(Draft&)>> given;  ///< each puts one key of [camera] or [show] into a draft
};

/// Keys of a plot. Values that several keys decide together are stored beside `plot`.
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
  ShapeDraft drawn;
  std::optional<int> preset;  ///< index into cameraPresets()
  std::optional<std::vector<CameraFrame>> frames;
  bool noViews = false;
  std::vector<ViewDraft> views;
  std::vector<VectorDraft> vectors;
  std::vector<AngleDraft> angles;
  std::vector<PlotDraft> plots;
  std::vector<Readout> readouts;
  std::vector<Note> notes;
  std::vector<TimelineDraft> timeline;
  bool loop = false;
  int quality = 0;  ///< index into qualityPresets()
  std::optional<Eigen::Vector2i> size_px;
  std::optional<int> crf;
  std::optional<int> codec;    ///< index into codecWords()
  int chroma = 0, effort = 1;  ///< indices into chromaWords(), effortWords()
};

/// Returns element i, after extending the vector to contain it.
template <class T>
T& elementAt(std::vector<T>& elements, std::size_t i) {
  if (elements.size() <= i) elements.resize(i + 1);
  return elements[i];
}

}  // namespace poinsot::scene
