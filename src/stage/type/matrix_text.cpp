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

constexpr int kMatrixDigits = 4;
constexpr double kTurnRounding = 0x1p-49;  // rounding error of a turned tensor, relative to its largest element

WrittenUnit matrixUnit(scene::BodyMatrix matrix, double largest) {
  WrittenUnit unit = writtenUnit(scene::QuantityUnit::kBare, largest);
  if (scene::isTensor(matrix)) unit.tex = "\\mathrm{kg\\,m^2}";
  return unit;
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
  const double largest = matrix.cwiseAbs().maxCoeff();
  const WrittenUnit unit = matrixUnit(*note.matrix, largest);
  const double size = std::max(unit.written(largest), 1e-300);
  const int decimals = std::max(0, kMatrixDigits - 1 - static_cast<int>(std::floor(std::log10(size))));
  std::string rows;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const double value = matrix(row, column);
      const bool zero = std::abs(value) <= kTurnRounding * largest;
      const std::string digits = zero ? "0" : fixedDigits(unit.written(value), decimals);
      rows += digitsInFormula(digits, scene.style.decimalSign) + (column < 2 ? " & " : row < 2 ? " \\\\ " : "");
    }
  const std::string suffix = unitSuffix(unit);
  return fmt::format("{}\\begin{{bmatrix}} {} \\end{{bmatrix}}{}", matrixName(note, scene.body), rows,
                     suffix.empty() ? "$" : suffix.substr(1));
}

}  // namespace poinsot::stage
