// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "core/abi.h"
#include "scene/scene.h"

namespace poinsot::describe {

/// A number, a vector or list of them, a matrix, a count, yes or no, or a word.
using FactValue =
    std::variant<double, Eigen::Vector3d, std::vector<double>, Eigen::Matrix3d, int, bool, std::string>;

/// One thing to know of a scene. Values in SI units and radians.
struct Fact {
  std::string key;    ///< in JSON: snake_case, stable
  std::string label;  ///< for people
  FactValue value;
  std::string unit;          ///< empty for bare numbers and words
  std::string from;          ///< equation of the lecture, or what else it comes from
  std::string inWords = {};  ///< for people, in place of a value that is a word for programs
};

struct Section {
  std::string title;
  std::vector<Fact> facts;

  Fact& add(std::string key, std::string label, FactValue value, std::string unit, std::string from) {
    facts.push_back({std::move(key), std::move(label), std::move(value), std::move(unit), std::move(from)});
    return facts.back();
  }
};

struct Report {
  std::string scene;
  std::vector<Section> sections;
};

constexpr int kUsualDigits = 6;  ///< what a lecture needs; the JSON has them all
constexpr int kAllDigits = 17;   ///< that tell any double from any other

/// A fact's value with its unit, for people; of a matrix a line for each row. Numbers as in reportTable().
std::vector<std::string> factLines(const Fact& fact, int digits = kUsualDigits);

/// A table of three columns: quantity, value with its unit, where it comes from. Angles stand also in degrees; a
/// component that is the rounding of its vector's is 0.
/// @pre digits from 1 to kAllDigits: significant ones, zeros at the end left out
std::string reportTable(const Report& report, int digits = kUsualDigits);

/// One object: scene, each key with its value in full precision (infinite: null), units by key, from by key.
/// Bare numbers, words and truth values have no unit.
std::string reportJson(const Report& report);

/// What one would work out by hand about a scene: every number from the physics layer.
/// @throws core::Error(kPhysics) for a motion that has no solution.
Report sceneReport(const scene::Scene& scene);

}  // namespace poinsot::describe
