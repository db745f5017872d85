// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/table_figure.h"

#include "stage/to_picture.h"

namespace poinsot::stage {
namespace {

using Eigen::Vector3d;

constexpr double kEdge = 1.22;    // half the edge of the table, relative to the length of the line of contact
constexpr double kCells = 5;      // cells of the grid from the middle of the table to its edge
constexpr double kBelow = 0.006;  // distance of the sheet below the line of contact, in picture lengths
constexpr double kOpacity = 0.22;
constexpr int kCirclePoints = 180;
constexpr double kLift = 0.01;

}  // namespace

TableFigure::TableFigure(const Setting& setting)
    : cone_(setting.motion.rolling()->cone),
      slant_(setting.scales.body * cone_.slant_m()),
      halfEdge_(kEdge * setting.scene.show.figures.table.scale * slant_) {}

// The cone's axis, without its vertical part, lies along the line of contact.
Vector3d TableFigure::contactEnd_V(const PictureState& state) const {
  const Vector3d up = state.R_VW.col(2), axis = state.R_VB * cone_.axis_B;
  return slant_ * (axis - axis.dot(up) * up).normalized();
}

draw::GridPlane TableFigure::sheet(const Canvas& canvas, const PictureState& state) const {
  draw::GridPlane plane;
  plane.centre_V = toPicture(Vector3d(-kBelow * state.R_VW.col(2)));
  plane.u_V = toPicture(Vector3d(halfEdge_ * state.R_VW.col(0)));
  plane.v_V = toPicture(Vector3d(halfEdge_ * state.R_VW.col(1)));
  plane.spacing_V = static_cast<float>(halfEdge_ / kCells);
  plane.color = canvas.colors.rod;
  plane.opacity = canvas.glass(kOpacity);
  plane.lineColor = canvas.colors.quietInk;
  plane.lineOpacity = 0.35f;
  plane.lineWidth_px = static_cast<float>(0.8 * canvas.line_px);
  plane.shadowCentre_V = toPicture(Vector3d(0.66 * contactEnd_V(state)));
  plane.shadowRadius_V = static_cast<float>(0.5 * slant_);
  plane.shadowOpacity = 0.25f;
  return plane;
}

void TableFigure::add(const Canvas& canvas, double /*filmTime_s*/, const PictureState& state) const {
  canvas.list.planes.push_back(sheet(canvas, state));
  canvas.line(circleAbout(Vector3d::Zero(), state.R_VW.col(2), slant_, kCirclePoints), true,
              canvas.colors.quietInk, 1.1);
  canvas.line({Vector3d::Zero(), contactEnd_V(state)}, false, canvas.colors.omega, 3, kLift);
}

std::vector<Vector3d> TableFigure::outermostPoints(const PictureState& state) const {
  std::vector<Vector3d> corners;
  for (const double x : {-halfEdge_, halfEdge_})
    for (const double y : {-halfEdge_, halfEdge_})
      corners.emplace_back(x * state.R_VW.col(0) + y * state.R_VW.col(1));
  return corners;
}

}  // namespace poinsot::stage
