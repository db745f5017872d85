// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

#include <fmt/format.h>

#include "core/error.h"
#include "physics/catalogue.h"
#include "physics/euler_angles.h"
#include "scene/assembly/measured_body.h"
#include "scene/assembly/piece_reader.h"
#include "scene/keys/tensor_text.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

using Eigen::Vector3d;

constexpr const char* kWays = "principal_moments, inertia, shape, catalogue, or parts and point masses";

std::string vectorText(const Vector3d& v) { return fmt::format("({:g}, {:g}, {:g})", v[0], v[1], v[2]); }

/// Returns why the physics library cannot solve a motion with these moments; empty if it can. For moments given as
/// numbers, their range was checked before. For moments of a shape, this is the only check.
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

/// Reads the axes of one's own. Each way to give them needs all of its keys.
class OwnAxesReader {
 public:
  OwnAxesReader(const OwnAxesDraft& draft, Findings& findings) : draft_(draft), findings_(findings) {}

  std::optional<physics::Quaternion> q_BA() {
    if (!findings_.hasTable("body.own_axes") && !findings_.hasBelow("body.own_axes")) return std::nullopt;
    if (!isOneWay()) return std::nullopt;
    if (draft_.rotation) return *draft_.rotation;
    if (const auto& angles = draft_.rollPitchYaw)
      return physics::attitudeOf(physics::RollPitchYaw{(*angles)[0], (*angles)[1], (*angles)[2]});
    return draft_.x && draft_.y ? fromDirections(*draft_.x, *draft_.y) : std::nullopt;
  }

 private:
  static std::string path(std::string_view name) { return fmt::format("body.own_axes.{}", name); }

  bool isOneWay() {
    std::vector<std::string> given;
    for (const char* way : {"rotation", "roll_pitch_yaw", "x", "y"})
      if (findings_.has(path(way))) given.push_back(path(way));
    if (given.empty()) {
      findings_.refuseMissing(
          "body.own_axes.rotation", "body.own_axes",
          "needs rotation, roll_pitch_yaw, or x and y, such as roll_pitch_yaw = [0, 0, \"30 deg\"]");
      return false;
    }
    const bool directions = given[0] == path("x") || given[0] == path("y");
    if (!directions && given.size() > 1)
      findings_.refuse(given[1],
                       fmt::format("{} is given too; give the axes in one way: rotation, roll_pitch_yaw, or "
                                   "x and y",
                                   given[0]));
    else if (directions && given.size() == 1)
      refuseLone(given[0] == path("x") ? "x" : "y");
    return given.size() == (directions ? 2 : 1);
  }

  void refuseLone(std::string_view name) {
    const std::string other = path(name == "x" ? "y" : "x");
    findings_.refuseMissing(other, path(name),
                            fmt::format("one direction does not fix the axes; give {} too", other));
  }

  std::optional<physics::Quaternion> fromDirections(const Vector3d& x, const Vector3d& y) {
    constexpr double kLeastSine = 1e-6;  // below, rounding turns the axes by more than 1e-10 rad
    for (const auto& [name, v] : {std::pair("x", x), std::pair("y", y)})
      if (v.isZero(0)) {
        findings_.refuse(path(name), "must not all be zero: the axis would have no direction");
        return std::nullopt;
      }
    const Vector3d ahead = x.normalized(), up = ahead.cross(y.normalized());
    if (up.norm() < kLeastSine) {
      findings_.refuse(path("y"), fmt::format("must not be along {}, got {}", path("x"), vectorText(y)));
      return std::nullopt;
    }
    Eigen::Matrix3d R_BA;
    R_BA << ahead, up.normalized().cross(ahead), up.normalized();
    return physics::Quaternion(R_BA);
  }

  const OwnAxesDraft& draft_;
  Findings& findings_;
};

class BodyAssembly {
 public:
  BodyAssembly(const Draft& draft, Findings& findings, const SceneFolder& folder)
      : all_(draft), draft_(draft.body), findings_(findings), folder_(folder) {
    body_.pivot_B = draft.scene.body.pivot_B;
    body_.q_BA = OwnAxesReader(draft_.ownAxes, findings_).q_BA();
  }

  std::optional<Body> run() {
    const std::vector<std::string> ways = waysGiven();
    if (ways.empty())
      refuseNone();
    else if (ways[0] == wholePath() && isMeantMeasured())
      refuseShape();
    else if (ways.size() > 1)
      refuseSecond(ways);
    else
      describe(ways[0]);
    return whole_ ? std::optional(std::move(body_)) : std::nullopt;
  }

 private:
  void refuseNone() {
    if (findings_.isMeantBelow("body")) return;
    for (const char* path : {"body", "body.principal_moments", "body.inertia", "body.shape", "body.catalogue",
                             "body.part", "body.point_mass"})
      if (findings_.misspelt(path)) return;
    findings_.refuse("body", fmt::format("the body is missing; give {}. For example, in [body]:\n    shape = "
                                         "\"box\"\n    size = [0.3, 0.2, 0.05]\n    mass = 1",
                                         kWays));
  }

  /// Refuses the keys of a shape beside an unknown name that stands for the moments. An invalid shape is already
  /// reported.
  void refuseShape() {
    if (findings_.failed("body.shape")) return;
    KeyNames names;
    if (findings_.has("body.shape")) names.emplace_back("shape");
    for (const std::string_view name : shapeKeyNames())
      if (findings_.has(fmt::format("body.{}", name))) names.push_back(name);
    if (findings_.has("body.density")) names.emplace_back("density");
    findings_.refuse(wholePath(),
                     fmt::format("the scene gives the moments, which a shape would set too; leave out {} "
                                 "(show.body.shape draws a shape that does not set them)",
                                 listed(names)));
  }

  std::vector<std::string> waysGiven() const {
    std::vector<std::string> ways;
    for (const char* path : {"body.principal_moments", "body.inertia", "body.catalogue"})
      if (findings_.has(path)) ways.emplace_back(path);
    if (const std::string path = wholePath(); !path.empty()) ways.push_back(path);
    for (const char* array : {"body.part", "body.point_mass"})
      if (findings_.count(array) > 0) {
        ways.push_back(fmt::format("{}[0]", array));
        break;
      }
    return ways;
  }

  std::string wholePath() const {
    if (findings_.has("body.shape")) return "body.shape";
    for (const std::string_view name : shapeKeyNames())
      if (std::string path = fmt::format("body.{}", name); findings_.has(path)) return path;
    for (const char* path : {"body.mass", "body.density"})
      if (findings_.has(path) && !((isMeasured() || isMeantMeasured()) && path == std::string_view("body.mass")))
        return path;
    return "";
  }

  /// Returns whether an unknown name of the scene stands for the moments.
  bool isMeantMeasured() const {
    return findings_.misspelt("body.principal_moments") || findings_.misspelt("body.inertia");
  }

  bool isMeasured() const { return findings_.has("body.principal_moments") || findings_.has("body.inertia"); }

  void refuseSecond(const std::vector<std::string>& ways) {
    if (isMeasured() && ways[1] == "body.density")
      return findings_.refuse(
          ways[1],
          fmt::format("cannot be combined with {}, which has no volume; give body.mass instead", ways[0]));
    if (ways[0] == "body.principal_moments" && ways[1] == wholePath())
      return findings_.refuse(
          ways[1],
          "body.principal_moments is given too; the moments come from it, or from shape, size and mass, not from "
          "both (to draw a shape that does not set the moments, use show.body.shape)");
    findings_.refuse(ways[1], fmt::format("{} is given too; a body is described in one way: {}", ways[0], kWays));
  }

  void describe(const std::string& way) {
    if (way == "body.principal_moments") return bareMoments();
    if (way == "body.inertia") return bareTensor();
    refuseMeasuredKeys(way, findings_);
    if (way == "body.catalogue") return fromCatalogue();
    if (way == wholePath()) return onePiece();
    pieces();
  }

  void bareMoments() {
    if (!draft_.moments) return;
    try {
      body_.axes = physics::PrincipalMoments(*draft_.moments);
    } catch (const core::Error&) {  // only the triangle inequality can fail; the range was checked before
      return findings_.refuse("body.principal_moments", triangleMessage(*draft_.moments) +
                                                            nearestMomentsAdvice({draft_.moments->data(), 3}));
    }
    finishMeasured(draft_.moments->asDiagonal(), "body.principal_moments");
  }

  void bareTensor() {
    if (!draft_.inertia) return;
    try {
      body_.axes = physics::PrincipalAxes(*draft_.inertia);
    } catch (const core::Error& error) {
      return findings_.refuse("body.inertia", error.message() + nearestTensorAdvice(*draft_.inertia));
    }
    finishMeasured(*draft_.inertia, "body.inertia");
  }

  /// Completes a body that is given by moments or a tensor. If these are about the fixed point, the principal axes
  /// are those of the given tensor.
  void finishMeasured(const Eigen::Matrix3d& inertia_B, const std::string& path) {
    MeasuredBody measured(all_, path, findings_);
    if (!measured.keysFit()) return;
    body_.mass = measured.massProperties(inertia_B);
    if (findings_.has("body.mass") && !body_.mass) return;
    if (measured.aboutFixedPoint())
      finish(path);
    else
      setAxes(body_.mass->inertiaAbout(body_.fixedPoint_B()), path);
  }

  /// @param inertia_B  inertia tensor about the fixed point, computed from the scene's values
  void setAxes(const Eigen::Matrix3d& inertia_B, const std::string& path) {
    try {
      body_.axes = physics::PrincipalAxes(inertia_B);
    } catch (const core::Error& error) {
      return findings_.refuse(path, error.message());
    }
    finish(path);
  }

  void finish(const std::string& path) {
    const std::string problem = outOfReach(body_.axes.moments().values());
    if (!problem.empty()) findings_.refuse(path, problem);
    whole_ = problem.empty();
  }

  void fromCatalogue() {
    if (!draft_.catalogue) return;
    const auto& entry = physics::catalogue()[static_cast<std::size_t>(*draft_.catalogue)];
    for (const physics::SolidPart& part : entry.parts)
      body_.parts.push_back({part.solid, part.mass_kg, part.q_BS, part.offset_B});
    for (const physics::SolidMark& mark : entry.marks)
      body_.marks.push_back({{mark.part.solid, 0, mark.part.q_BS, mark.part.offset_B}, mark.tone, {}});
    setMass(physics::massProperties(entry), "body.catalogue");
  }

  void onePiece() {
    PieceReader reader(draft_.whole, "body", findings_, folder_);
    if (auto piece = reader.piece()) setPieces({std::move(*piece)}, reader.lengthPath());
  }

  void pieces() {
    std::vector<Piece> pieces;
    const std::size_t parts = findings_.count("body.part"), points = findings_.count("body.point_mass");
    for (std::size_t i = 0; i < parts; ++i) add(pieces, partPiece(i));
    for (std::size_t i = 0; i < points; ++i) add(pieces, pointPiece(i));
    if (pieces.size() == parts + points)
      setPieces(std::move(pieces), parts > 0 ? "body.part[0]" : "body.point_mass[0]");
  }

  static void add(std::vector<Piece>& pieces, std::optional<Piece> piece) {
    if (piece) pieces.push_back(std::move(*piece));
  }

  std::optional<Piece> partPiece(std::size_t i) {
    static const PieceDraft nothing;
    const PieceDraft& draft = i < draft_.parts.size() ? draft_.parts[i] : nothing;
    return PieceReader(draft, fmt::format("body.part[{}]", i), findings_, folder_).piece();
  }

  std::optional<Piece> pointPiece(std::size_t i) {
    static const PointDraft nothing;
    const PointDraft& draft = i < draft_.points.size() ? draft_.points[i] : nothing;
    return pointMass(draft, fmt::format("body.point_mass[{}]", i), findings_);
  }

  void setPieces(std::vector<Piece> pieces, const std::string& path) {
    std::vector<physics::MassProperties> masses;
    for (Piece& piece : pieces) {
      masses.push_back(piece.mass);
      body_.parts.push_back(std::move(piece.part));
    }
    try {
      setMass(physics::combined(masses), path);
    } catch (const core::Error& error) {
      findings_.refuse(path, error.message());
    }
  }

  void setMass(const physics::MassProperties& mass, const std::string& path) {
    if (findings_.failed("body.pivot")) return;
    body_.mass = mass;
    const Eigen::Matrix3d inertia_B = body_.mass->inertiaAbout(body_.fixedPoint_B());
    if (inertia_B.diagonal().minCoeff() == 0)
      findings_.refuse(path,
                       "the whole body lies on one line through its fixed point, so it has no moment of inertia "
                       "about that line; add another part, or give the body an extent" +
                           thinBox());
    else
      setAxes(inertia_B, path);
  }

  /// Returns a thin box along x in place of a rod, as advice.
  std::string thinBox() const {
    const auto length = draft_.whole.shape.lengths.find("length");
    if (length == draft_.whole.shape.lengths.end()) return "";
    const double thickness = length->second / 50;
    return fmt::format(
        ". For example, a thin box along x, in place of shape and length:\n    shape = \"box\"\n    "
        "size = [{:.6g}, {:.6g}, {:.6g}]",
        length->second, thickness, thickness);
  }

  const Draft& all_;
  const BodyDraft& draft_;
  Body body_;
  bool whole_ = false;
  Findings& findings_;
  const SceneFolder& folder_;
};

}  // namespace

void assembleMarks(const Draft& draft, Findings& findings, const SceneFolder& folder, Scene& scene) {
  static const MarkDraft nothing;
  if (!scene.show.body.parts.empty()) scene.body.marks.clear();  // the marks of a catalogue fit its own parts only
  for (std::size_t i = 0; i < findings.count("mark"); ++i) {
    const MarkDraft& mark = i < draft.marks.size() ? draft.marks[i] : nothing;
    if (auto part = PieceReader(mark.piece, fmt::format("mark[{}]", i), findings, folder).massless())
      scene.body.marks.push_back({std::move(*part), physics::MarkTone::kDark, mark.color});
  }
}

std::optional<Body> assembleBody(const Draft& draft, Findings& findings, const SceneFolder& folder) {
  return BodyAssembly(draft, findings, folder).run();
}

bool massIsUnknown(const Findings& findings) {
  return (findings.has("body.principal_moments") || findings.has("body.inertia")) && !findings.has("body.mass");
}

}  // namespace poinsot::scene
