// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "core/abi.h"
#include "scene/scene.h"

namespace poinsot::describe {

using FactValue =
    std::variant<double, Eigen::Vector3d, std::vector<double>, Eigen::Matrix3d, int, bool, std::string>;

/// A quantity of a scene with its value. Values are in SI units and radians.
struct Fact {
  std::string key;    ///< name in JSON; snake_case, stable
  std::string label;  ///< name in the table
  FactValue value;
  std::string unit;          ///< empty for bare numbers and words
  std::string from;          ///< equation of the lecture, or another source
  std::string inWords = {};  ///< text for the table, if the value is an identifier for programs
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

constexpr int kUsualDigits = 6;  ///< significant digits of the table; JSON has full precision
constexpr int kAllDigits = 17;   ///< significant digits that distinguish all doubles

/// Returns a fact's value with its unit as text, formatted as in reportTable(). A matrix has one line per row.
std::vector<std::string> factLines(const Fact& fact, int digits = kUsualDigits);

/// Returns a table of three columns: quantity, value with unit, source. Angles appear also in degrees. Components
/// that are rounding errors of the largest one in their vector are printed as 0.
/// @pre digits from 1 to kAllDigits: significant ones, zeros at the end left out
std::string reportTable(const Report& report, int digits = kUsualDigits);

/// Returns a JSON object: the scene's name, each key with its value in full precision (infinity as null), the
/// units by key and the sources by key. Bare numbers, words and booleans have no unit.
std::string reportJson(const Report& report);

/// Returns the facts about a scene that one would work out by hand, all computed by the physics library.
/// @throws core::Error(kPhysics) for a motion that has no solution
Report sceneReport(const scene::Scene& scene);

}  // namespace poinsot::describe
