// SPDX-License-Identifier: Apache-2.0
#include "describe/report.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <type_traits>
#include <utility>

#include "core/expect.h"
#include "core/text.h"
#include "describe/report_sections.h"
#include "scene/motion/make_motion.h"
#include "stage/picture_motion.h"

namespace poinsot::describe {

namespace {

using Json = nlohmann::ordered_json;

template <typename T>
constexpr bool kIsList = std::is_same_v<T, std::vector<double>> || std::is_same_v<T, Eigen::Vector3d>;

/// Formats a number with `digits` significant digits; negative zero loses its sign.
std::string numberText(double value, int digits) { return fmt::format("{:.{}g}", value == 0 ? 0 : value, digits); }

/// Reports whether the numbers of a fact are components along axes, as in a vector. The keys of such facts end in
/// the letter of the frame. The components of a quaternion count too, because they share one length.
bool isOfComponents(const Fact& fact) {
  return fact.key.ends_with("_B") || fact.key.ends_with("_W") || fact.key.ends_with("_A") ||
         fact.key.starts_with("U_") || fact.key == "orientation";
}

/// Replaces components that are only rounding errors of the largest component by 0.
template <typename T>
T withoutRounding(T components) {
  constexpr double kRounding = 0x1p-50;  // four units in the last place of the largest component
  const double least = kRounding * components.cwiseAbs().maxCoeff();
  return components.unaryExpr([&](double c) { return std::abs(c) <= least ? 0.0 : c; });
}

std::vector<double> withoutRounding(const std::vector<double>& list) {
  const auto count = static_cast<Eigen::Index>(list.size());
  const Eigen::VectorXd shown = withoutRounding<Eigen::VectorXd>(Eigen::VectorXd::Map(list.data(), count));
  return {shown.begin(), shown.end()};
}

FactValue shownValue(const Fact& fact) {
  if (!fact.inWords.empty()) return fact.inWords;
  if (!isOfComponents(fact)) return fact.value;
  if (const auto* vector = std::get_if<Eigen::Vector3d>(&fact.value)) return withoutRounding(*vector);
  if (const auto* matrix = std::get_if<Eigen::Matrix3d>(&fact.value)) return withoutRounding(*matrix);
  if (const auto* list = std::get_if<std::vector<double>>(&fact.value)) return withoutRounding(*list);
  return fact.value;
}

constexpr std::size_t kMostListed = 5;  // numbers of a list in the table; JSON has all

template <typename List>
std::string listText(const List& values, int digits) {
  const auto count = static_cast<std::size_t>(values.size());
  const bool cut = count > kMostListed;
  std::string text;
  for (std::size_t i = 0; i < (cut ? kMostListed - 1 : count); ++i)
    text += (text.empty() ? "(" : ", ") + numberText(values.data()[i], digits);
  return cut ? fmt::format("{}, ..., {})", text, numberText(values.data()[count - 1], digits)) : text + ")";
}

/// Returns a matrix as three lines with right-aligned columns.
std::vector<std::string> rows(const Eigen::Matrix3d& m, int digits) {
  std::vector<std::string> lines(3);
  for (int column = 0; column < 3; ++column) {
    std::size_t width = 0;
    for (const double value : m.col(column)) width = std::max(width, numberText(value, digits).size());
    for (int row = 0; row < 3; ++row)
      lines[static_cast<std::size_t>(row)] +=
          fmt::format("{}{:>{}}", column == 0 ? "" : "  ", numberText(m(row, column), digits), width);
  }
  return lines;
}

std::vector<std::string> valueLines(const FactValue& value, int digits) {
  return std::visit(
      [digits](const auto& v) -> std::vector<std::string> {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, double>)
          return {numberText(v, digits)};
        else if constexpr (kIsList<T>)
          return {listText(v, digits)};
        else if constexpr (std::is_same_v<T, Eigen::Matrix3d>)
          return rows(v, digits);
        else if constexpr (std::is_same_v<T, bool>)
          return {v ? "yes" : "no"};
        else if constexpr (std::is_same_v<T, int>)
          return {std::to_string(v)};
        else
          return {core::printable(v)};
      },
      value);
}

/// Returns the number of values of a list that the table cuts, such as ", 17 in all".
std::string countOfList(const FactValue& value) {
  const auto* list = std::get_if<std::vector<double>>(&value);
  return list && list->size() > kMostListed ? fmt::format(", {} in all", list->size()) : "";
}

std::string inDegrees(const Fact& fact, int digits) {
  const double* angle = std::get_if<double>(&fact.value);
  if (!angle || fact.unit != "rad" || !std::isfinite(*angle)) return "";
  const double degrees = *angle * 180 / std::numbers::pi;
  constexpr double kArcminute = 1.0 / 60;  // below this, arcseconds are the usual unit
  if (*angle != 0 && std::abs(degrees) < kArcminute && std::abs(degrees) > 1e-9)
    return fmt::format(" ({} arcsec)", numberText(3600 * degrees, digits));
  return fmt::format(" ({} deg)", numberText(degrees, digits));
}

struct Row {
  std::string_view label, from;
  std::vector<std::string> lines;
};

struct Widths {
  std::size_t label = 0, value = 0;

  void include(const Row& row) {
    label = std::max(label, row.label.size());
    for (const std::string& line : row.lines) value = std::max(value, line.size());
  }
};

std::string rowText(const Row& row, const Widths& widths) {
  std::string text;
  for (std::size_t i = 0; i < row.lines.size(); ++i) {
    const bool last = i + 1 == row.lines.size();
    const std::string_view from = last ? row.from : "";
    text += fmt::format("  {:<{}}  {:<{}}", i == 0 ? row.label : "", widths.label, row.lines[i],
                        from.empty() ? 0 : widths.value);
    text += from.empty() ? "\n" : fmt::format("  {}\n", from);
  }
  return text;
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
          const Eigen::Matrix3d columns = v.transpose();  // Eigen stores a matrix by columns, JSON by rows
          return {listJson(columns.data(), 3), listJson(columns.data() + 3, 3), listJson(columns.data() + 6, 3)};
        }
        if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int> || std::is_same_v<T, std::string>)
          return v;
      },
      value);
}

}  // namespace

std::vector<std::string> factLines(const Fact& fact, int digits) {
  POINSOT_EXPECT(digits >= 1 && digits <= kAllDigits);
  std::vector<std::string> lines = valueLines(shownValue(fact), digits);
  if (!fact.unit.empty()) lines.back() += ' ' + fact.unit;
  lines.back() += inDegrees(fact, digits) + countOfList(fact.value);
  return lines;
}

std::string reportTable(const Report& report, int digits, TableExtent extent) {
  std::vector<std::vector<Row>> sections;
  Widths widths;
  int omitted = 0;
  for (const Section& section : report.sections) {
    std::vector<Row> rows;
    for (const Fact& fact : section.facts) {
      if (extent == TableExtent::kPage && fact.detail) {
        ++omitted;
        continue;
      }
      rows.push_back({fact.label, fact.from, factLines(fact, digits)});
      widths.include(rows.back());
    }
    sections.push_back(std::move(rows));
  }
  std::string text = core::printable(report.scene) + '\n';
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (!sections[i].empty()) text += fmt::format("\n{}\n", report.sections[i].title);
    for (const Row& row : sections[i]) text += rowText(row, widths);
  }
  if (omitted > 0) text += fmt::format("\n{} more with --all\n", omitted);
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

Report sceneReport(const scene::Scene& scene) {
  const double start_s = scene.time.start_s;
  const ReportSpan span{start_s, stage::filmClock(scene).motionTime_s(scene.time.duration_s)};
  const auto motion = scene::makeMotion(scene, span.from_s, span.to_s);
  return {
      scene.name,
      {bodySection(scene), ownAxesSection(scene), startSection(scene), forcesSection(scene, *motion, span),
       flightSection(scene), referencePointSection(scene), constructionSection(scene), symmetricSection(scene),
       heavyTopSection(scene), rollingSection(scene), lossSection(scene, *motion, span), stabilitySection(scene),
       loopSection(scene), eventsSection(scene, *motion, span), accuracySection(scene, *motion, span)}};
}

}  // namespace poinsot::describe
