// SPDX-License-Identifier: Apache-2.0
#include "app/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <type_traits>

#include "core/text.h"

namespace poinsot::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLabelWidth = 42, kValueWidth = 61;  // three numbers and kg m^2/s

template <typename T>
constexpr bool kIsList = std::is_same_v<T, std::vector<double>> || std::is_same_v<T, Eigen::Vector3d>;

/// A zero has no sign here.
std::string numberText(double value) { return fmt::format("{:.10g}", value == 0 ? 0 : value); }

/// Whether the fact's numbers are components along axes: the frame stands at the end of its key.
bool isOfComponents(const Fact& fact) { return fact.key.ends_with("_B") || fact.key.ends_with("_W"); }

/// The same without the components that are the rounding of the others: what a rotation leaves of a zero.
template <typename T>
T withoutRounding(T components) {
  constexpr double kRounding = 0x1p-50;  // four units in the last place of the largest
  const double least = kRounding * components.cwiseAbs().maxCoeff();
  return components.unaryExpr([&](double c) { return std::abs(c) <= least ? 0.0 : c; });
}

FactValue shownValue(const Fact& fact) {
  if (!fact.inWords.empty()) return fact.inWords;
  if (!isOfComponents(fact)) return fact.value;
  if (const auto* vector = std::get_if<Eigen::Vector3d>(&fact.value)) return withoutRounding(*vector);
  if (const auto* matrix = std::get_if<Eigen::Matrix3d>(&fact.value)) return withoutRounding(*matrix);
  return fact.value;
}

template <typename List>
std::string listText(const List& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "(" : ", ") + numberText(value);
  return text + ")";
}

std::string rowText(const Eigen::Matrix3d& m, int row) {
  return fmt::format("{:>14}{:>14}{:>14}", fmt::format("{:.6g}", m(row, 0)), fmt::format("{:.6g}", m(row, 1)),
                     fmt::format("{:.6g}", m(row, 2)));
}

/// What stands in the second column, a line each.
std::vector<std::string> valueLines(const FactValue& value) {
  return std::visit(
      [](const auto& v) -> std::vector<std::string> {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, double>)
          return {numberText(v)};
        else if constexpr (kIsList<T>)
          return {listText(v)};
        else if constexpr (std::is_same_v<T, Eigen::Matrix3d>)
          return {rowText(v, 0), rowText(v, 1), rowText(v, 2)};
        else if constexpr (std::is_same_v<T, bool>)
          return {v ? "yes" : "no"};
        else if constexpr (std::is_same_v<T, int>)
          return {std::to_string(v)};
        else
          return {core::printable(v)};
      },
      value);
}

std::string inDegrees(const Fact& fact) {
  const double* angle = std::get_if<double>(&fact.value);
  if (!angle || fact.unit != "rad" || !std::isfinite(*angle)) return "";
  return fmt::format(" ({:.8g} deg)", *angle * 180 / std::numbers::pi);
}

std::string factText(const Fact& fact) {
  const std::vector<std::string> lines = factLines(fact);
  std::string text = fmt::format("  {:<{}} ", fact.label, kLabelWidth);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) text += lines[i] + '\n' + std::string(kLabelWidth + 3, ' ');
  if (fact.from.empty()) return text + lines.back() + '\n';
  return text + fmt::format("{:<{}}  {}\n", lines.back(), kValueWidth, fact.from);
}

Json finite(double value) { return std::isfinite(value) ? Json(value == 0 ? 0.0 : value) : Json(); }

Json listJson(const double* values, std::size_t count) {
  Json list = Json::array();
  for (std::size_t i = 0; i < count; ++i) list.push_back(finite(values[i]));
  return list;
}

Json valueJson(const FactValue& value) {
  return std::visit(
      [](const auto& v) -> Json {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, double>) return finite(v);
        if constexpr (kIsList<T>) return listJson(v.data(), static_cast<std::size_t>(v.size()));
        if constexpr (std::is_same_v<T, Eigen::Matrix3d>) {
          const Eigen::Matrix3d columns = v.transpose();  // Eigen stores columns, JSON wants rows
          return {listJson(columns.data(), 3), listJson(columns.data() + 3, 3), listJson(columns.data() + 6, 3)};
        }
        if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int> || std::is_same_v<T, std::string>)
          return v;
      },
      value);
}

}  // namespace

std::vector<std::string> factLines(const Fact& fact) {
  std::vector<std::string> lines = valueLines(shownValue(fact));
  if (!fact.unit.empty()) lines.back() += ' ' + fact.unit;
  lines.back() += inDegrees(fact);
  return lines;
}

std::string reportTable(const Report& report) {
  std::string text = core::printable(report.scene) + '\n';
  for (const Section& section : report.sections) {
    if (section.facts.empty()) continue;
    text += fmt::format("\n{}\n", section.title);
    for (const Fact& fact : section.facts) text += factText(fact);
  }
  return text;
}

std::string reportJson(const Report& report) {
  Json json{{"scene", report.scene}}, units = Json::object(), from = Json::object();
  for (const Section& section : report.sections)
    for (const Fact& fact : section.facts) {
      json[fact.key] = valueJson(fact.value);
      if (!fact.unit.empty()) units[fact.key] = fact.unit;
      if (!fact.from.empty()) from[fact.key] = fact.from;
    }
  json["units"] = units;
  json["from"] = from;
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace poinsot::app
