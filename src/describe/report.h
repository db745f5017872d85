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

/// Quantity of a scene, such as its mass, with the value in SI units and radians.
struct Fact {
  std::string key;    ///< name in JSON, in snake_case; never changes
  std::string label;  ///< name in the table
  FactValue value;
  std::string unit;          ///< empty for words and numbers without a unit
  std::string from;          ///< equation of the lecture, or another source
  std::string inWords = {};  ///< text for the table, if the value is only for programs
  bool detail = false;       ///< whether only the complete table has the fact
};

struct Section {
  std::string title;
  std::vector<Fact> facts;

  Fact& add(std::string key, std::string label, FactValue value, std::string unit, std::string from) {
    facts.push_back({std::move(key), std::move(label), std::move(value), std::move(unit), std::move(from)});
    return facts.back();
  }
  /// Adds a fact if only the complete table is to have it, such as a value that follows from another one.
  Fact& addDetail(std::string key, std::string label, FactValue value, std::string unit, std::string from) {
    Fact& fact = add(std::move(key), std::move(label), std::move(value), std::move(unit), std::move(from));
    fact.detail = true;
    return fact;
  }
};

struct Report {
  std::string scene;
  std::vector<Section> sections;
};

constexpr int kUsualDigits = 6;  ///< significant digits of the table; JSON has full precision
constexpr int kAllDigits = 17;   ///< significant digits that represent every double exactly

/// Returns a fact's value with its unit as text, in the format of reportTable(). A matrix has one line for each
/// row.
std::vector<std::string> factLines(const Fact& fact, int digits = kUsualDigits);

/// Facts of a table: one page for a reader, or everything.
enum class TableExtent { kPage, kAll };

/// Returns a table with three columns: quantity, value with unit, source. Angles are also in degrees. If a
/// component of a vector is only a rounding error of the largest one, it is printed as 0. A page ends with the
/// number of the facts that it omits.
/// @pre digits from 1 to kAllDigits: significant ones, zeros at the end left out
std::string reportTable(const Report& report, int digits = kUsualDigits, TableExtent extent = TableExtent::kAll);

/// Returns a JSON object with the scene's name, the values by key, the units by key and the sources by key. Values
/// have full precision; infinity is null. Words, booleans and numbers without a unit have no entry in the units.
std::string reportJson(const Report& report);

/// Returns facts about a scene that a person would otherwise work out by hand. All are computed by the physics
/// library.
/// @throws core::Error(kPhysics) for a motion that has no solution
Report sceneReport(const scene::Scene& scene);

}  // namespace poinsot::describe
