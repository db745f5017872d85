// SPDX-License-Identifier: Apache-2.0
#include "stage/type/matrix_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_samples.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

const std::string kFile =
    "[body]\ninertia = [[2, 1, 0], [1, 2, 0], [0, 0, 3]]\n[body.own_axes]\nrotation = [1, 0, 0, 1]\n[motion]\n"
    "omega_body = [0, 0, 1]\n";

/// Returns the text of a note with single spaces.
std::string plainText(const scene::Scene& scene, std::size_t note) {
  std::string text = text::setTex(matrixText(scene.notes.at(note), scene)).plainText;
  while (text.find("  ") != std::string::npos) text.erase(text.find("  "), 1);
  return text;
}

std::string textOf(const std::string& note) {
  const scene::Scene scene = scene::parseScene(kFile + "[[note]]\n" + note + "\n", "s.toml");
  return plainText(scene, 0);
}

TEST(MatrixText, HasNameNumbersAndUnit) {
  EXPECT_EQ(textOf("matrix = 'inertia'"), "I = [2.000 1.000 0; 1.000 2.000 0; 0 0 3.000] kg m²");
  EXPECT_EQ(textOf("matrix = 'inertia_own'"),
            "I′ = UI U\u0303 = [2.000 −1.000 0; −1.000 2.000 0; 0 0 3.000] kg m²");
  EXPECT_EQ(textOf("matrix = 'U_own'"), "U = [0 1.000 0; −1.000 0 0; 0 0 1.000]");
  EXPECT_EQ(textOf("matrix = 'U_own'\ntext = 'axes'"), "axes = [0 1.000 0; −1.000 0 0; 0 0 1.000]");
}

TEST(MatrixText, HasThePowerOfTenOfItsLargestNumber) {
  const scene::Scene scene = scene::parseScene(
      "[body]\nprincipal_moments = [1.5e-3, 2e-3, 12.25e-4]\n[motion]\nomega_body = [0, 0, 1]\n[[note]]\n"
      "matrix = 'inertia'\n[style]\ndecimal_sign = 'comma'\n",
      "s.toml");
  EXPECT_EQ(plainText(scene, 0), "I = [1,500 0 0; 0 2,000 0; 0 0 1,225] × 10⁻³ kg m²");
}

// I = 0.002 about the centre, and 0.009 more about the pivot.
TEST(MatrixText, HasOneUnitInAllNotes) {
  const scene::Scene scene = scene::parseScene(
      "[body]\nprincipal_moments = [2e-3, 2e-3, 2e-3]\nmass = 1\npivot = [0, 0, 94.86832980505138e-3]\n[motion]\n"
      "omega_body = [0, 0, 1]\n[[note]]\nmatrix = 'inertia_centre'\n[[note]]\nmatrix = 'inertia'\n",
      "s.toml");
  EXPECT_THAT(plainText(scene, 0), ::testing::HasSubstr("= [2.000 0 0; 0 2.000 0; 0 0 2.000] × 10⁻³ kg m²"));
  EXPECT_THAT(plainText(scene, 1), ::testing::HasSubstr("= [11.000 0 0; 0 11.000 0; 0 0 2.000] × 10⁻³ kg m²"));
}

}  // namespace
}  // namespace poinsot::stage
