// SPDX-License-Identifier: Apache-2.0
#include "text/math_layout.h"

#include <algorithm>
#include <cmath>

#include "text/plain_text.h"

namespace poinsot::text {

namespace {

const MathConstants& constants() { return Font::mathematics().constants(); }

// Turns binary operators that are only signs, such as the minus of -1, into ordinary atoms. Atoms are processed
// from left to right, because an operator depends on the class of its left neighbour.
std::vector<Atom> withSignsSettled(std::vector<Atom> atoms) {
  const AtomClass* before = nullptr;
  for (auto atom = atoms.begin(); atom != atoms.end(); ++atom) {
    if (atom->isSpace) continue;
    const auto next = std::find_if(atom + 1, atoms.end(), [](const Atom& a) { return !a.isSpace; });
    const AtomClass* after = next == atoms.end() ? nullptr : &next->atomClass;
    if (atom->atomClass == AtomClass::kBinary && isSign(before, after)) atom->atomClass = AtomClass::kOrdinary;
    before = &atom->atomClass;
  }
  return atoms;
}

// Distances of the superscript's baseline above, and of the subscript's baseline below, the baseline of the base.
struct Shifts {
  double up = 0;
  double down = 0;
};

double shiftUp(const Box& base, const Box& sup, const MathStyle& style) {
  const MathConstants& c = constants();
  const double scale = scaleOf(style.level);
  double up = scale * (style.cramped ? c.superscriptShiftUpCramped : c.superscriptShiftUp);
  if (!base.character) up = std::max(up, base.height - scale * c.superscriptBaselineDropMax);
  return std::max(up, scale * c.superscriptBottomMin + sup.depth);
}

double shiftDown(const Box& base, const Box& sub, const MathStyle& style) {
  const MathConstants& c = constants();
  const double scale = scaleOf(style.level);
  double down = scale * c.subscriptShiftDown;
  if (!base.character) down = std::max(down, base.depth + scale * c.subscriptBaselineDropMin);
  return std::max(down, sub.height - scale * c.subscriptTopMax);
}

// Moves a superscript and a subscript apart until their gap is large enough. First the superscript moves up as far
// as the font allows, then the subscript moves down.
Shifts apart(Shifts shifts, const Box& sub, const Box& sup, double scale) {
  const MathConstants& c = constants();
  const double gap = (shifts.up - sup.depth) - (sub.height - shifts.down);
  const double missing = scale * c.subSuperscriptGapMin - gap;
  if (missing <= 0) return shifts;
  const double supBottom = shifts.up - sup.depth;
  const double raise = std::clamp(scale * c.superscriptBottomMaxWithSubscript - supBottom, 0.0, missing);
  return {shifts.up + raise, shifts.down + (missing - raise)};
}

}  // namespace

Box joined(const std::vector<Atom>& list, const MathStyle& style) {
  const std::vector<Atom> atoms = withSignsSettled(list);
  Box line;
  const AtomClass* before = nullptr;
  for (const Atom& atom : atoms) {
    if (!atom.isSpace && before != nullptr) {
      const double space_em = spaceBetween_em(*before, atom.atomClass, style.level > 0);
      if (space_em > 0) append(line, spaceBox(space_em, style.level));
    }
    append(line, atom.box);
    if (!atom.isSpace) before = &atom.atomClass;
  }
  // A group of one atom is the same as the atom itself, so that scripts and accents are placed as on the atom.
  if (atoms.size() == 1) return atoms.front().box;
  line.accentX = line.width / 2;
  return line;
}

Box withScripts(const Box& base, const Scripts& scripts, const MathStyle& style) {
  const double scale = scaleOf(style.level);
  Shifts shifts;
  if (scripts.sup) shifts.up = shiftUp(base, *scripts.sup, style);
  if (scripts.sub) shifts.down = shiftDown(base, *scripts.sub, style);
  if (scripts.sup && scripts.sub) shifts = apart(shifts, *scripts.sub, *scripts.sup, scale);

  Box box = base;
  box.italic = 0;
  if (scripts.primes) append(box, *scripts.primes);
  double right = box.width;
  if (scripts.sub) {
    const double x = base.width - base.italic;
    place(box, *scripts.sub, x, -shifts.down);
    right = std::max(right, x + scripts.sub->width + scale * constants().spaceAfterScript);
    box.plain += plainSubscript(scripts.sub->plain);
  }
  if (scripts.sup) {
    place(box, *scripts.sup, box.width, shifts.up);
    right = std::max(right, box.width + scripts.sup->width + scale * constants().spaceAfterScript);
    box.plain += plainSuperscript(scripts.sup->plain);
  }
  box.width = right;
  return box;
}

Box fraction(const Box& numerator, const Box& denominator, const MathStyle& style, bool display) {
  const MathConstants& c = constants();
  const MathConstants::Fraction& f = display ? c.displayFraction : c.fraction;
  const double scale = scaleOf(style.level);
  const double rule = scale * c.fractionRuleThickness;
  const double barBottom = scale * c.axisHeight - rule / 2;
  const double up =
      std::max(scale * f.numeratorShiftUp, barBottom + rule + scale * f.numeratorGapMin + numerator.depth);
  const double down =
      std::max(scale * f.denominatorShiftDown, denominator.height + scale * f.denominatorGapMin - barBottom);
  const double side =
      // Space beside the bar, which keeps it off its neighbour (TeX's \nulldelimiterspace, 1.2 pt at 10 pt).
      scale * 0.12;
  const double bar = std::max(numerator.width, denominator.width);

  Box box;
  box.width = bar + 2 * side;
  place(box, numerator, side + (bar - numerator.width) / 2, up);
  place(box, denominator, side + (bar - denominator.width) / 2, -down);
  box.rules.push_back({side, barBottom, bar, rule});
  box.accentX = box.width / 2;
  box.plain = plainFraction(numerator.plain, denominator.plain);
  return box;
}

namespace {

// Lengths of a matrix, em. The distances of rows and columns are LaTeX's.
constexpr double kRowsApart = 1.2, kLeastRowGap = 0.15, kColumnsApart = 1.0;
constexpr double kRowHeight = 0.7, kRowDepth = 0.2;    // least extent of the first and the last row
constexpr double kBracketLip = 0.2, kInBracket = 0.2;  // width of a bracket's ends, and the space inside
constexpr double kBesideBracket = 0.1, kBeyondRows = 0.1;

std::vector<double> columnWidths(const std::vector<std::vector<Box>>& rows) {
  std::vector<double> widths;
  for (const std::vector<Box>& row : rows) {
    if (widths.size() < row.size()) widths.resize(row.size());
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].width);
  }
  return widths;
}

struct Extent {
  double height = 0, depth = 0;
};

Extent extentOf(const std::vector<Box>& row, double scale) {
  Extent extent{scale * kRowHeight, scale * kRowDepth};
  for (const Box& cell : row) {
    extent.height = std::max(extent.height, cell.height);
    extent.depth = std::max(extent.depth, cell.depth);
  }
  return extent;
}

/// Adds a bracket, whose upright starts at x. The rules do not overlap, because overlaps would be darker.
/// @param lip  width of the two ends: positive to the right, negative to the left
void addBracket(Box& box, double x, double lip, double top, double bottom, double rule) {
  box.rules.push_back({x, bottom, rule, top - bottom});
  const double end = lip > 0 ? x + rule : x + lip;
  for (const double y : {top - rule, bottom}) box.rules.push_back({end, y, std::abs(lip), rule});
}

}  // namespace

Box bracketedMatrix(const std::vector<std::vector<Box>>& rows, const MathStyle& style) {
  const double scale = scaleOf(style.level), rule = scale * constants().fractionRuleThickness;
  const std::vector<double> widths = columnWidths(rows);
  std::vector<double> baselines;  // below the first one
  double depth = 0;
  for (const std::vector<Box>& row : rows) {
    const Extent extent = extentOf(row, scale);
    baselines.push_back(baselines.empty() ? 0
                                          : std::max(baselines.back() + scale * kRowsApart,
                                                     depth + scale * kLeastRowGap + extent.height));
    depth = baselines.back() + extent.depth;
  }
  const double height = extentOf(rows.front(), scale).height, beyond = scale * kBeyondRows;
  const double first = scale * constants().axisHeight + (depth - height) / 2;  // baseline of the first row
  const double top = first + height + beyond, bottom = first - depth - beyond;

  Box box;
  const double left = scale * kBesideBracket, lip = scale * kBracketLip;
  addBracket(box, left, lip, top, bottom, rule);
  double right = left + rule + lip + scale * kInBracket;
  std::vector<double> ends;  // right end of each column
  for (const double width : widths) {
    right += (ends.empty() ? 0 : scale * kColumnsApart) + width;
    ends.push_back(right);
  }
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < rows[row].size(); ++column)
      place(box, rows[row][column], ends[column] - rows[row][column].width, first - baselines[row]);
  right += scale * kInBracket + lip;
  addBracket(box, right, -lip, top, bottom, rule);
  box.width = right + rule + left;
  box.height = std::max(box.height, top);
  box.depth = std::max(box.depth, -bottom);
  box.accentX = box.width / 2;
  std::vector<std::vector<std::u32string>> plain;
  for (const std::vector<Box>& row : rows) {
    plain.emplace_back();
    for (const Box& cell : row) plain.back().push_back(cell.plain);
  }
  box.plain = plainMatrix(plain);
  return box;
}

std::optional<Box> squareRoot(const Box& content, const MathStyle& style) {
  const Font& font = Font::mathematics();
  const MathConstants& c = constants();
  const double scale = scaleOf(style.level);
  const double rule = scale * c.radicalRuleThickness;
  const double needed = content.height + content.depth + scale * c.radicalVerticalGap + rule;
  for (const GlyphId form : font.tallerForms(*font.glyph(U'√'))) {
    const GlyphMetrics sign = font.metrics(form);
    const double spare = scale * (sign.top - sign.bottom) - needed;
    if (spare < 0) continue;
    // If the root sign is taller than needed, half of the extra height is above the content and half below.
    const double top = content.height + scale * c.radicalVerticalGap + spare / 2 + rule;
    const double y = top - scale * sign.top;
    Box box;
    box.glyphs.push_back({form, 0, y, scale, U"√"});
    box.depth = std::max(0.0, -(y + scale * sign.bottom));
    box.height = top;
    // The bar starts at the right edge of the sign's ink. If they overlapped, the overlap would be darker.
    const double barStart = scale * sign.right;
    const double contentX = scale * sign.advance;
    box.rules.push_back({barStart, top - rule, contentX + content.width - barStart, rule});
    place(box, content, contentX, 0);
    box.height = top + scale * c.radicalExtraAscender;
    box.width = contentX + content.width;
    box.accentX = box.width / 2;
    box.plain = plainRoot(content.plain);
    return box;
  }
  return std::nullopt;
}

Box withIndex(const Box& root, const Box& index, const MathStyle& style) {
  const MathConstants& c = constants();
  const double scale = scaleOf(style.level);
  const double before = scale * c.radicalKernBeforeDegree;
  // The root sign moves right to make room for a wide index, but never left for a narrow index.
  const double signX = std::max(0.0, before + index.width + scale * c.radicalKernAfterDegree);
  const double signHeight = root.height - scale * c.radicalExtraAscender + root.depth;
  const double bottom = c.radicalDegreeBottomRaise * signHeight - root.depth;
  Box box;
  box.width = signX + root.width;
  place(box, index, before, bottom + index.depth);
  place(box, root, signX, 0);
  box.accentX = box.width / 2;
  box.plain = plainWithIndex(index.plain, root.plain);
  return box;
}

namespace {

// Space between two atoms: rows are the class of the left atom, columns the class of the right atom. Classes are
// in the order of AtomClass (ordinary, function, binary, relation, opening, closing, punctuation, inner).
// 0 means no space, 1 a thin space. t (thin), m (medium) and k (thick) are used outside scripts only. * cannot
// occur, because withSignsSettled() makes such binary operators ordinary.
constexpr char kSpaces[8][9] = {
    "01mk000t", "11*k000t", "mm**m**m", "kk*0k00k", "00*00000", "01mk000t", "tt*ttttt", "t1mkt0tt",
};

double mu(double count) { return count / 18; }

}  // namespace

double spaceBetween_em(AtomClass left, AtomClass right, bool inScript) {
  switch (kSpaces[static_cast<int>(left)][static_cast<int>(right)]) {
    case '1':
      return mu(3);
    case 't':
      return inScript ? 0 : mu(3);
    case 'm':
      return inScript ? 0 : mu(4);
    case 'k':
      return inScript ? 0 : mu(5);
    default:
      return 0;
  }
}

bool isSign(const AtomClass* left, const AtomClass* right) {
  if (left == nullptr || right == nullptr) return true;
  const bool afterOperator = *left == AtomClass::kBinary || *left == AtomClass::kRelation ||
                             *left == AtomClass::kOpening || *left == AtomClass::kPunctuation ||
                             *left == AtomClass::kFunction;
  const bool beforeEnd =
      *right == AtomClass::kRelation || *right == AtomClass::kClosing || *right == AtomClass::kPunctuation;
  return afterOperator || beforeEnd;
}

}  // namespace poinsot::text
