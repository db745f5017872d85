// SPDX-License-Identifier: Apache-2.0
#include "stage/type/matrix_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "scene/body_matrix.h"
#include "stage/type/written_number.h"

namespace poinsot::stage {
namespace {

constexpr int kMatrixDecimals = 3;         // of a largest number below 100
constexpr double kTurnRounding = 0x1p-49;  // rounding error of a turned tensor, relative to its largest element

/// Returns the largest number of all matrices of a picture that have the same unit as this one. Their numbers then
/// have the same unit and the same decimals, so that a reader can add them.
double largestElement(scene::BodyMatrix matrix, const scene::Scene& scene) {
  double largest = scene::bodyMatrix(scene.body, matrix).cwiseAbs().maxCoeff();
  for (const scene::Note& note : scene.notes)
    if (note.matrix && scene::isTensor(*note.matrix) == scene::isTensor(matrix))
      largest = std::max(largest, scene::bodyMatrix(scene.body, *note.matrix).cwiseAbs().maxCoeff());
  return largest;
}

WrittenUnit matrixUnit(scene::BodyMatrix matrix, double largest) {
  constexpr double kSmall = 0.1;  // a matrix has more numbers than fit with zeros before their digits
  WrittenUnit unit = writtenUnit(scene::QuantityUnit::kBare, largest < kSmall ? std::min(largest, 9e-3) : largest);
  if (scene::isTensor(matrix)) unit.tex = "\\mathrm{kg\\,m^2}";
  return unit;
}

int matrixDecimals(double largest) {
  if (!(largest >= 100)) return kMatrixDecimals;
  return std::max(0, kMatrixDecimals - static_cast<int>(std::floor(std::log10(largest))));
}

/// Returns the name and the equals sign, as the start of a formula.
std::string matrixName(const scene::Note& note, const scene::Body& body) {
  if (note.lines.empty()) return fmt::format("${} = ", scene::bodyMatrixTex(body, *note.matrix));
  return note.lines.front() + " $= ";
}

}  // namespace

std::string matrixText(const scene::Note& note, const scene::Scene& scene) {
  POINSOT_EXPECT(note.matrix);
  const Eigen::Matrix3d matrix = scene::bodyMatrix(scene.body, *note.matrix);
  const double largest = largestElement(*note.matrix, scene), own = matrix.cwiseAbs().maxCoeff();
  const WrittenUnit unit = matrixUnit(*note.matrix, largest);
  const int decimals = matrixDecimals(unit.written(largest));
  std::string rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const double value = matrix(row, column);
      const bool zero = std::abs(value) <= kTurnRounding * own;
      const std::string digits = zero ? "0" : fixedDigits(unit.written(value), decimals);
      rows += digitsInFormula(digits, scene.style.decimalSign) + (column < 2 ? " & " : row < 2 ? " \\\\ " : "");
    }
  const std::string suffix = unitSuffix(unit);
  return fmt::format("{}\\begin{{bmatrix}} {} \\end{{bmatrix}}{}", matrixName(note, scene.body), rows,
                     suffix.empty() ? "$" : suffix.substr(1));
}

}  // namespace poinsot::stage
