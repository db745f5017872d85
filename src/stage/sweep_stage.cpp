// SPDX-License-Identifier: Apache-2.0
#include "stage/sweep_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/expect.h"
#include "stage/plot/plot_frame.h"
#include "stage/scales.h"
#include "stage/timed_motion.h"
#include "stage/type/picture_writing.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

// Exponent with which text and lines shrink: (area of the cell / area of the picture)^kShrinks. They shrink less
// than their cell, so that they stay legible: to 46 % in a ninth of the picture.
constexpr double kShrinks = 0.35;
constexpr double kLabel = 0.05;                // size of the labels, as a fraction of the cells' Sizing::type_px
constexpr double kOver = 1.25, kUnder = 0.35;  // space for a label above and below its baseline, em
constexpr double kBeside = 0.8;                // gap on each side of the row labels, em
constexpr double kAcross = 0.95, kMostBand = 0.3;  // largest width and height of a label, as fractions of its cell
constexpr double kMostMargin = 0.3;  // largest width of the row labels, as a fraction of the picture's width
constexpr double kLeastType_px = 9;  // smaller text is illegible

double area(glm::ivec2 size) { return static_cast<double>(size.x) * static_cast<double>(size.y); }

scene::Scene withoutWriting(scene::Scene cell) {
  cell.show.title.clear();
  cell.show.subtitle.clear();
  cell.notes.clear();
  cell.timeline.captions.clear();
  return cell;
}

/// Removes text that each cell shows itself: the read-outs and the note on exaggerated angles.
scene::Scene writingOf(scene::Scene scene) {
  scene.readouts.clear();
  scene.show.exaggerateAngles = 1;
  return scene;
}

/// Adds the picture of a cell. @param plotsBefore  number of plots in the cells before it
void addAt(draw::Picture& picture, draw::Picture cell, glm::ivec2 origin_px, int plotsBefore) {
  const glm::vec2 origin(origin_px);
  const auto shift = [&](std::vector<glm::vec2>& points) {
    for (glm::vec2& p : points) p += origin;
  };
  for (draw::Panel& panel : cell.panels) {
    panel.origin_px += origin_px;
    picture.panels.push_back(std::move(panel));
  }
  for (draw::Area& each : cell.areas) {
    shift(each.points_px);
    picture.areas.push_back(std::move(each));
  }
  for (draw::Stroke& each : cell.strokes) {
    shift(each.points_px);
    if (each.plot > 0) each.plot += plotsBefore;
    picture.strokes.push_back(std::move(each));
  }
  for (draw::Text& each : cell.texts) {
    each.baseline_px += origin;
    picture.texts.push_back(std::move(each));
  }
}

FilmRanges rangesOf(const scene::Scene& cell, const std::shared_ptr<const physics::Motion>& motion) {
  FilmRanges ranges;
  for (const scene::Plot& plot : cell.plots) ranges.plots.push_back(PlotFigure(cell, plot, motion).ranges());
  ranges.readouts = ReadoutBoard(cell, motion, palette(cell.style)).ranges();
  return ranges;
}

/// Returns one range for all cells, so that their numbers have the same digits. Returns an empty range (low >
/// high) if the smallest numbers would keep too few digits.
QuantityRange commonDigits(const std::vector<QuantityRange>& ofCells) {
  constexpr double kMostUnlike = 10 * (1 + 1e-9);  // largest ratio of sizes: ten, with a tolerance for rounding
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  QuantityRange all{kUnbounded, -kUnbounded, 0};
  double least = kUnbounded;
  for (const QuantityRange& one : ofCells) {
    all = joined(all, one);
    least = std::min(least, sizeOf(one));
  }
  return sizeOf(all) <= kMostUnlike * least ? all : QuantityRange{kUnbounded, -kUnbounded, 0};
}

FilmRanges commonRanges(const std::vector<scene::Scene>& cells,
                        const std::vector<std::shared_ptr<const physics::Motion>>& motions) {
  FilmRanges all = rangesOf(cells[0], motions[0]);
  std::vector<std::vector<QuantityRange>> readouts;
  for (const QuantityRange& first : all.readouts) readouts.push_back({first});
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const FilmRanges one = rangesOf(cells[i], motions[i]);
    for (std::size_t k = 0; k < all.plots.size(); ++k) all.plots[k] = joined(all.plots[k], one.plots.at(k));
    for (std::size_t k = 0; k < readouts.size(); ++k) readouts[k].push_back(one.readouts.at(k));
  }
  std::ranges::transform(readouts, all.readouts.begin(), commonDigits);
  return all;
}

double widest_em(const std::vector<std::string>& lines) {
  double widest = 0;
  for (const std::string& tex : lines) widest = std::max(widest, text::setTex(tex).width_em);
  return widest;
}

}  // namespace

SweepStage::SweepStage(std::vector<scene::Scene> cells, std::vector<SweepLabels> labels, int columns,
                       CellTime time, core::StepLedger* steps)
    : written_(writingOf(cells.at(0))),
      labels_(std::move(labels)),
      columns_(columns),
      time_(time),
      colors_(palette(written_.style)),
      presence_(written_.timeline),
      captions_(written_) {
  POINSOT_EXPECT(labels_.size() == 1 || labels_.size() == 2);
  POINSOT_EXPECT(cells.size() == labels_[0].whole.size() * (labels_.size() == 2 ? labels_[1].whole.size() : 1));
  std::vector<std::shared_ptr<const physics::Motion>> motions;
  for (const scene::Scene& cell : cells) motions.push_back(timed(drawnMotion(cell), steps));
  const FilmRanges ranges = commonRanges(cells, motions);
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells_.emplace_back(withoutWriting(std::move(cells[i])), motions[i], ranges);
}

Moment SweepStage::momentOf(const Stage& cell, const Moment& picture) const {
  return time_ == CellTime::kOfPicture ? picture : Moment(cell.scene().time.stillTime_s(), picture.still);
}

draw::Picture SweepStage::compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const {
  expectPicture(moment, size_px);
  requireWithin(moment, written_.time.duration_s);
  const double filmTime_s = moment.filmTime_s;
  draw::Picture picture;
  picture.size_px = size_px;
  picture.background = colors_.paper;
  const Sizing type = typeScaled(sizing, written_.style.textSize);
  const int strip_px = static_cast<int>(std::min(captions_.height_px(size_px, type), kMostStrip * size_px.y));
  const glm::ivec2 free_px = size_px - glm::ivec2(0, strip_px);
  const WrittenThings things{{}, presence_.at("title", filmTime_s), presence_.at("notes", filmTime_s), 0};
  const PictureWriting writing = pictureWriting(written_, things, free_px, sizing, colors_);
  const PictureLayout whole(std::vector<scene::GridPlace>(1));
  const Grid grid = gridIn(whole.cells(free_px, writing.reach).front(), size_px, sizing);
  const std::vector<double> metres_px = mostMetre_px(grid);
  const int plots = static_cast<int>(written_.plots.size());
  for (int i = 0; i < static_cast<int>(cells_.size()); ++i) {
    const Stage& cell = cells_[static_cast<std::size_t>(i)];
    addAt(picture, cell.compose(momentOf(cell, moment), grid.cell_px, grid.sizing, metres_px), grid.originOf(i),
          i * plots);
  }
  addLabels(picture, grid);
  addBlocks(picture, writing.blocks, writing.boxes);
  captions_.add(picture, moment, type, colors_);
  return picture;
}

// Chooses the number of columns that makes the cells largest, measured by the shorter side of a cell: what a view
// shows is about as wide as high. Slightly smaller cells are preferred if they leave fewer grid positions empty.
int SweepStage::columnsFor(glm::ivec2 size_px) const {
  const int count = static_cast<int>(cells_.size());
  if (hasRows()) return static_cast<int>(labels_[0].whole.size());
  if (columns_ > 0) return std::min(columns_, count);
  int best = 1;
  double most = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double side_px = std::min(1.0 * size_px.x / columns, 1.0 * size_px.y / rows);
    const double worth = side_px * count / (columns * rows);
    if (worth > most * (1 + 1e-6)) most = worth, best = columns;
  }
  return best;
}

SweepStage::Grid SweepStage::gridIn(const Cell& room, glm::ivec2 picture_px, const Sizing& sizing) const {
  Grid grid;
  grid.columns = columnsFor(room.size_px);
  grid.rows = (static_cast<int>(cells_.size()) + grid.columns - 1) / grid.columns;
  const glm::ivec2 share_px = glm::max(room.size_px / glm::ivec2(grid.columns, grid.rows), glm::ivec2(1));
  const double share = std::pow(area(share_px) / area(picture_px), kShrinks);
  grid.sizing = inPart(sizing, share, share);
  grid.label_px = labelSize_px(typeScaled(grid.sizing, written_.style.textSize), share_px, room.size_px);
  const int band_px = static_cast<int>(std::ceil((kOver + kUnder) * grid.label_px));
  const int margin_px = static_cast<int>(std::ceil(margin_em() * grid.label_px));
  // Labels of columns are in one band above all cells. Labels of cells are in a band in each cell.
  const int headBand_px = hasRows() ? band_px : 0, cellBand_px = band_px - headBand_px;
  // All cells have the same size in whole pixels. The remaining pixels are left at the edges.
  const glm::ivec2 cells_px = room.size_px - glm::ivec2(margin_px, headBand_px);
  grid.pitch_px = glm::max(cells_px / glm::ivec2(grid.columns, grid.rows), glm::ivec2(1));
  grid.cell_px = glm::max(grid.pitch_px - glm::ivec2(0, cellBand_px), glm::ivec2(1));
  const glm::ivec2 left_px = cells_px - grid.pitch_px * glm::ivec2(grid.columns, grid.rows);
  grid.origin_px = room.origin_px + glm::ivec2(margin_px + std::max(left_px.x, 0) / 2, band_px);
  return grid;
}

double SweepStage::margin_em() const { return hasRows() ? widest_em(labels_[1].whole) + 2 * kBeside : 0; }

double SweepStage::labelSize_px(const Sizing& type, glm::dvec2 cell_px, glm::dvec2 room_px) const {
  const double wanted_px = std::max(smallSize_px(kLabel, type), kLeastType_px);
  return std::min({wanted_px, kAcross * cell_px.x / std::max(widest_em(labels_[0].whole), 1e-9),
                   kMostMargin * room_px.x / std::max(margin_em(), 1e-9),
                   kMostBand * cell_px.y / (kOver + kUnder)});
}

void SweepStage::addLabels(draw::Picture& picture, const Grid& grid) const {
  const double em_px = grid.label_px;
  const auto over = [&](const std::string& tex, int cell) {
    const glm::ivec2 corner = grid.originOf(cell);
    addLine(picture, tex, corner.x + 0.5 * grid.cell_px.x, corner.y - kUnder * em_px, Align::kCentre, em_px,
            colors_.ink);
  };
  for (std::size_t i = 0; i < labels_[0].whole.size(); ++i) over(labels_[0].whole[i], static_cast<int>(i));
  if (!hasRows()) return;
  for (std::size_t row = 0; row < labels_[1].whole.size(); ++row) {
    const glm::ivec2 corner = grid.originOf(static_cast<int>(row) * grid.columns);
    addLine(picture, labels_[1].whole[row], corner.x - kBeside * em_px,
            corner.y + 0.5 * grid.cell_px.y + kUnder * em_px, Align::kRight, em_px, colors_.ink);
  }
}

std::vector<double> SweepStage::mostMetre_px(const Grid& grid) const {
  std::vector<std::vector<double>> ofCells;
  for (const Stage& cell : cells_) ofCells.push_back(cell.metres_px(grid.cell_px, grid.sizing));
  std::vector<double> most;
  for (std::size_t view = 0; view < ofCells[0].size(); ++view) {
    std::vector<double> possible_px;
    for (const std::vector<double>& cell : ofCells) possible_px.push_back(cell.at(view));
    most.push_back(commonMetre_px(possible_px));
  }
  return most;
}

}  // namespace poinsot::stage
