// SPDX-License-Identifier: Apache-2.0
#include "stage/type/note_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "stage/type/matrix_text.h"
#include "stage/type/written_number.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

using scene::Spot;

// Text sizes and width of the free edge, as fractions of Sizing::type_px.
constexpr double kHeading = 0.044, kUnderHeading = 0.028;
constexpr double kTitle = 0.042, kSubtitle = 0.03, kNote = 0.032, kFootnote = 0.025, kRowsEdge = 0.055;
// Lengths in em of a row's text.
constexpr double kRowCapHeight = 0.7, kRowDescent = 0.2, kRowLeading = 0.3;
constexpr double kRowEquals = 0.3;  // gap between "=" and a value
constexpr double kReadout = 0.5;    // space between rows of read-outs, whose digits are all tall

double noteSize_px(const scene::Note& note, const Sizing& sizing) {
  if (sizing.fixed_px > 0) return std::max(note.size, 1.0) * sizing.fixed_px;
  return smallSize_px(note.size * kNote, sizing);
}

void growTo(NoteRow& row, const std::string& tex, double size_px, double leading) {
  const text::GlyphRun run = text::setTex(tex);
  // Tall formulas, such as fractions, need more space between rows.
  const double tall = std::max(0.0, run.inkTop_em - 1) + std::max(0.0, -run.inkBottom_em - 0.4);
  leading += 0.5 * tall;
  row.ascent_px = std::max(row.ascent_px, size_px * std::max(run.inkTop_em, kRowCapHeight));
  row.descent_px = std::max(row.descent_px, size_px * (std::max(-run.inkBottom_em, kRowDescent) + leading));
}

NoteRow lineRow(const std::string& tex, double size_px, double room_px, const draw::Color& color) {
  NoteRow row;
  const double width_em = text::setTex(tex).width_em, size = std::min(size_px, room_px / std::max(width_em, 1e-9));
  row.pieces = {{tex, 0, size, color}};
  row.width_px = size * width_em;
  growTo(row, tex, size, kRowLeading);
  return row;
}

void addTitle(NoteBlock& block, const std::string& title, const std::string& subtitle, double titleShare,
              double subtitleShare, const Sizing& sizing, double room_px, const Palette& colors) {
  if (!title.empty())
    block.rows.push_back(
        lineRow("\\textbf{" + title + "}", titleSize_px(titleShare, sizing), room_px, colors.ink));
  if (!subtitle.empty())
    block.rows.push_back(lineRow(subtitle, smallSize_px(subtitleShare, sizing), room_px, colors.quietInk));
}

// Writes 200000 as "200 000". A number with decimals is not grouped.
std::string grouped(double x, scene::DecimalSign sign) {
  std::string digits = fmt::format("{:.15g}", x);
  if (digits.find_first_not_of("0123456789") != std::string::npos) return numberTex(digits, sign);
  for (auto i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), "\u2009");
  return digits;
}

std::string exaggerationText(const scene::Scene& scene) {
  return "angles drawn " + grouped(scene.show.exaggerateAngles, scene.style.decimalSign) + " times larger";
}

/// Column widths of read-outs that are under one another, em. All names end at the same position, and the widest
/// values begin at the same position.
struct Columns {
  double name = 0, value = 0, unit = 0;

  explicit Columns(const std::vector<ReadoutText>& readouts) {
    for (const ReadoutText& readout : readouts) {
      name = std::max(name, text::setTex(readout.name).width_em);
      value = std::max(value, text::setTex(readout.widest).width_em);
      unit = std::max(unit, text::setTex(readout.unit).width_em);
    }
  }
  double width() const { return name + kRowEquals + value + unit; }
};

NoteRow readoutRow(const ReadoutText& readout, const Columns& columns, double size_px) {
  const auto right = [&](const std::string& tex, double at_em) {
    return size_px * (at_em - text::setTex(tex).width_em);
  };
  const double values = columns.name + kRowEquals, end = values + text::setTex(readout.widest).width_em;
  NoteRow row;
  row.pieces = {{readout.name, right(readout.name, columns.name), size_px, readout.color},
                {readout.value, right(readout.value, end), size_px, readout.color},
                {readout.unit, end * size_px, size_px, readout.color}};
  row.width_px = columns.width() * size_px;
  for (const std::string& tex : {readout.name, readout.widest, readout.unit}) growTo(row, tex, size_px, kReadout);
  return row;
}

void addReadouts(NoteBlock& block, const std::vector<ReadoutText>& readouts, const Sizing& sizing,
                 double room_px) {
  std::vector<ReadoutText> here;
  for (const ReadoutText& readout : readouts)
    if (readout.at == block.at) here.push_back(readout);
  const Columns columns(here);
  const double size_px = std::min(smallSize_px(kNote, sizing), room_px / std::max(columns.width(), 1e-9));
  for (const ReadoutText& readout : here) block.rows.push_back(readoutRow(readout, columns, size_px));
}

void addNotes(NoteBlock& block, const scene::Scene& scene, const Sizing& sizing, double room_px,
              const Palette& colors) {
  for (const scene::Note& note : scene.notes) {
    if (note.at != block.at) continue;
    const std::vector<std::string> lines = note.matrix ? std::vector{matrixText(note, scene)} : note.lines;
    for (const std::string& line : lines)
      block.rows.push_back(lineRow(line, noteSize_px(note, sizing), room_px, colors.ink));
  }
}

}  // namespace

double noteEdge_px(const Sizing& sizing) { return kRowsEdge * sizing.type_px; }

std::vector<NoteBlock> pictureBlocks(const scene::Scene& scene, const WrittenThings& things, const Sizing& sizing,
                                     double room_px, const Palette& colors) {
  std::vector<NoteBlock> blocks;
  for (int place = 0; place < 9; ++place) {
    NoteBlock block{static_cast<Spot>(place), {}};
    if (block.at == Spot::kTopLeft) {
      addTitle(block, scene.show.title, scene.show.subtitle, kTitle, kSubtitle, sizing, room_px, colors);
      for (NoteRow& row : block.rows) row.halo = false, row.opacity = things.titleThere;
    }
    const std::size_t notes = block.rows.size();
    addNotes(block, scene, sizing, room_px, colors);
    const std::size_t readouts = block.rows.size();
    addReadouts(block, things.readouts, sizing, room_px);
    for (std::size_t i = notes; i < block.rows.size(); ++i)
      block.rows[i].opacity = i < readouts ? things.notesThere : things.readoutsThere;
    if (block.at == Spot::kBottomLeft && scene.show.exaggerateAngles > 1)
      block.rows.push_back(
          lineRow(exaggerationText(scene), smallSize_px(kFootnote, sizing), room_px, colors.quietInk));
    if (!block.rows.empty()) blocks.push_back(std::move(block));
  }
  return blocks;
}

NoteBlock headingBlock(const scene::View& view, const Sizing& sizing, double room_px, const Palette& colors) {
  NoteBlock block{Spot::kTop, {}};
  addTitle(block, view.title, view.subtitle, kHeading, kUnderHeading, sizing, room_px, colors);
  for (NoteRow& row : block.rows) row.halo = false;
  return block;
}

}  // namespace poinsot::stage
