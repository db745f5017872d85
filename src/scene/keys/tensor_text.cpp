// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/tensor_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "core/error.h"
#include "core/text.h"
#include "physics/possible_inertia.h"
#include "physics/principal_axes.h"

namespace poinsot::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Words = std::vector<std::string>;

bool isNumber(const Node& node) { return node.as<std::int64_t>() || node.as<double>() || node.as<std::string>(); }

/// Returns the numbers of a row as the scene writes them. Empty if the node is not an array of numbers.
Words numbersOf(const Node& row) {
  const auto* array = row.as<Node::Array>();
  if (!array || !std::ranges::all_of(*array, isNumber)) return {};
  Words words;
  for (const Node& number : *array) words.push_back(describe(number));
  return words;
}

std::string rowsOf(const Words& words, const std::array<std::size_t, 9>& places) {
  const auto word = [&](std::size_t i) -> const std::string& { return words[places[i]]; };
  return fmt::format("[[{}, {}, {}], [{}, {}, {}], [{}, {}, {}]]", word(0), word(1), word(2), word(3), word(4),
                     word(5), word(6), word(7), word(8));
}

constexpr std::array<std::size_t, 9> kInRows{0, 1, 2, 3, 4, 5, 6, 7, 8}, kUpperTriangle{0, 1, 2, 1, 3, 4, 2, 4, 5},
    kLowerTriangle{0, 1, 3, 1, 2, 4, 3, 4, 5}, kDiagonalFirst{0, 3, 4, 3, 1, 5, 4, 5, 2},
    kUpperOfNine{0, 1, 2, 1, 4, 5, 2, 5, 8}, kLowerOfNine{0, 3, 6, 3, 4, 7, 6, 7, 8};

std::string flatAdvice(const Words& words) {
  if (words.size() == 3)
    return fmt::format(
        "; for a diagonal tensor write [[{0}, 0, 0], [0, {1}, 0], [0, 0, {2}]], or principal_moments = "
        "[{0}, {1}, {2}]",
        words[0], words[1], words[2]);
  if (words.size() == 6)
    return fmt::format(
        "; for the order ixx, ixy, ixz, iyy, iyz, izz (URDF, Gazebo) write {}; for the order ixx, iyy, "
        "izz, ixy, ixz, iyz (MuJoCo's fullinertia) write {}",
        rowsOf(words, kUpperTriangle), rowsOf(words, kDiagonalFirst));
  return words.size() == 9 ? "; write " + rowsOf(words, kInRows) : "";
}

/// Formats numbers with as few digits as possible, but at least six, so that isPossible() accepts the rounded
/// numbers. A user who copies them into a scene then gets no error.
template <std::size_t kCount, class IsPossible>
std::array<std::string, kCount> acceptedDecimals(const std::array<double, kCount>& values, IsPossible isPossible) {
  constexpr int kFewest = 6, kAll = 17;
  std::array<std::string, kCount> texts;
  for (int digits = kFewest; digits <= kAll; ++digits) {
    std::array<double, kCount> read{};
    for (std::size_t i = 0; i < kCount; ++i) {
      texts[i] = fmt::format("{:.{}g}", values[i] + 0., digits);  // + 0. turns -0 into 0
      read[i] = std::strtod(texts[i].c_str(), nullptr);
    }
    if (isPossible(read)) break;
  }
  return texts;
}

bool isPossible(const Matrix3d& inertia) {
  try {
    physics::PrincipalAxes axes(inertia);
    return true;
  } catch (const core::Error&) {
    return false;
  }
}

Matrix3d matrixOf(const std::array<double, 6>& e) {
  Matrix3d matrix;
  matrix << e[0], e[1], e[2], e[1], e[3], e[4], e[2], e[4], e[5];
  return matrix;
}

std::string signAdvice(const Matrix3d& inertia) {
  Matrix3d turned = -inertia;
  turned.diagonal() = inertia.diagonal();
  if (turned == inertia || !isPossible(turned)) return "";
  return "; the tensor is possible if its products of inertia change sign (an off-diagonal element is -(sum of m "
         "x y))";
}

}  // namespace

std::string layoutAdvice(const Node& given) {
  const auto* rows = given.as<Node::Array>();
  if (!rows) return "";
  if (const Words flat = numbersOf(given); !flat.empty()) return flatAdvice(flat);
  Words words;
  std::vector<std::size_t> lengths;
  for (const Node& row : *rows) {
    const Words numbers = numbersOf(row);
    lengths.push_back(numbers.size());
    std::ranges::copy(numbers, std::back_inserter(words));
  }
  if (lengths == std::vector<std::size_t>{3, 2, 1}) return "; write " + rowsOf(words, kUpperTriangle);
  if (lengths == std::vector<std::size_t>{1, 2, 3}) return "; write " + rowsOf(words, kLowerTriangle);
  return "";
}

std::string triangleAdvice(const Node& rows, std::span<const double> values) {
  const bool upper = values[3] == 0 && values[6] == 0 && values[7] == 0;
  const bool lower = values[1] == 0 && values[2] == 0 && values[5] == 0;
  if (upper == lower) return "";
  Words words;
  for (const Node& row : *rows.as<Node::Array>()) std::ranges::copy(numbersOf(row), std::back_inserter(words));
  return fmt::format("; repeat the {} triangle {} the diagonal: write {}", upper ? "upper" : "lower",
                     upper ? "below" : "above", rowsOf(words, upper ? kUpperOfNine : kLowerOfNine));
}

std::string triangleMessage(const Vector3d& moments) {
  int largest = 0;
  moments.maxCoeff(&largest);
  const int other = largest == 0 ? 2 : 1, another = largest == 2 ? 2 : 3;
  return fmt::format(
      "I{} must not exceed I{} + I{}, got ({:g}, {:g}, {:g}) kg·m²; a solid body cannot have these values",
      largest + 1, other, another, moments[0], moments[1], moments[2]);
}

std::string nearestMomentsText(std::span<const double> moments) {
  const Vector3d given(moments[0], moments[1], moments[2]);
  const auto nearest = isPossible(given.asDiagonal()) ? std::nullopt : physics::nearestPossibleMoments(given);
  if (!nearest) return "";
  const auto texts = acceptedDecimals(
      std::array{(*nearest)[0], (*nearest)[1], (*nearest)[2]},
      [](const auto& read) { return isPossible(Vector3d(read[0], read[1], read[2]).asDiagonal()); });
  return fmt::format("[{}]", core::joined(texts, ", "));
}

std::string nearestMomentsAdvice(std::span<const double> moments) {
  const std::string nearest = nearestMomentsText(moments);
  return nearest.empty() ? "" : "; the nearest possible moments in kg·m² are " + nearest;
}

std::string nearestTensorAdvice(const Matrix3d& inertia) {
  const auto nearest = physics::nearestPossibleTensor(inertia);
  if (!nearest) return "";
  const Matrix3d& n = *nearest;
  const auto texts = acceptedDecimals(std::array{n(0, 0), n(0, 1), n(0, 2), n(1, 1), n(1, 2), n(2, 2)},
                                      [](const auto& read) { return isPossible(matrixOf(read)); });
  return fmt::format("; the nearest possible tensor in kg·m² is {}{}",
                     rowsOf({texts.begin(), texts.end()}, kUpperTriangle), signAdvice(inertia));
}

std::string whyImpossible(const Matrix3d& inertia) {
  try {
    physics::PrincipalAxes axes(inertia);
    return "";
  } catch (const core::Error& error) {
    return error.message() + nearestTensorAdvice(inertia);
  }
}

}  // namespace poinsot::scene
