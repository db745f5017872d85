// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace poinsot::reference {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNearlyWhole = 0.25;  // an exponent this close to 1 is called "linear", and so on

constexpr std::string_view kRow = "{:<18} {:>9} {:<{}} {:>11} {:>10} {:>10}   {}\n";

std::string growthText(const Drift& drift) {
  if (drift.growth == Growth::kExponential)
    return fmt::format(", by a factor of e every {:.3g} s", 1 / drift.rate);
  if (drift.growth == Growth::kUnclear) return "";
  constexpr std::array kNames{", then level", ", linear", ", quadratic", ", cubic"};
  const double whole = std::round(drift.order);
  if (std::abs(drift.order - whole) < kNearlyWhole && whole >= 0 && whole < kNames.size())
    return kNames[static_cast<std::size_t>(whole)];
  return fmt::format(", as t^{:.2g}", drift.order);
}

std::string driftText(const Drift& drift) {
  switch (drift.kind) {
    case DriftKind::kTooFewRows:
      return "unknown: too few rows";
    case DriftKind::kRounding:
      return "none: rounding";
    case DriftKind::kLevel:
      return "none: level";
    case DriftKind::kDrift:
      return fmt::format("from t = {:.6g}{}", drift.from_s, growthText(drift));
  }
  return "";
}

constexpr std::array kTrendWords{"none", "loses", "gains"};

constexpr const char* trendWord(Trend trend) { return kTrendWords[static_cast<std::size_t>(trend)]; }

/// Returns the error at the last row, such as "-5.91e-02". Errors within rounding get no sign.
std::string finalText(const ErrorSummary& errors) {
  const bool hasSign = errors.signedFinal && errors.drift.kind != DriftKind::kRounding;
  return hasSign ? fmt::format("{:+.2e}", *errors.signedFinal) : fmt::format("{:.2e}", errors.final);
}

std::string_view unitWord(const GradedQuantity& quantity) {
  if (!quantity.errors) return "";
  return quantity.unit == "1" ? "rel" : quantity.unit;
}

std::string row(const GradedQuantity& quantity, std::size_t unitWidth) {
  if (!quantity.errors) return fmt::format("{:<18}{:>10}\n", quantity.label, "absent");
  const ErrorSummary& e = *quantity.errors;
  const std::string trend = e.trend == Trend::kNone ? "" : fmt::format(" ({})", trendWord(e.trend));
  return fmt::format(kRow, quantity.label, fmt::format("{:.2e}", e.largest), unitWord(quantity), unitWidth,
                     fmt::format("{:.6g}", e.largestAt_s), finalText(e), fmt::format("{:.2e}", e.rms),
                     driftText(e.drift) + trend);
}

/// Returns a sentence about errors with a trend, with texts such as "T -5.9e-02 (loses), |L| -3.0e-02 (loses)".
std::string trendText(const Grade& grade) {
  std::string text;
  for (const GradedQuantity& quantity : grade.quantities) {
    if (!quantity.errors || quantity.errors->trend == Trend::kNone) continue;
    text += fmt::format("{}{} {:+.1e}{} ({})", text.empty() ? "" : ", ", quantity.label,
                        *quantity.errors->signedFinal, unitAfter(quantity), trendWord(quantity.errors->trend));
  }
  return text.empty() ? "" : "At the last row, against the motion: " + text + ".\n";
}

std::string sentence(const std::string& note) {
  return fmt::format("Note: {}{}\n", note, note.ends_with('?') || note.ends_with('.') ? "" : ".");
}

/// Returns a line for each quantity that is computed from other columns.
std::string derivedText(const Grade& grade) {
  std::string text;
  for (const GradedQuantity& quantity : grade.quantities)
    if (quantity.errors && quantity.from.find("omega") != std::string::npos && !quantity.key.starts_with("omega"))
      text += fmt::format("{} is computed from {}.\n", quantity.label, quantity.from);
  return text;
}

constexpr const char* kindWord(DriftKind kind) {
  constexpr std::array kWords{"too_few_rows", "rounding", "level", "drift"};
  return kWords[static_cast<std::size_t>(kind)];
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json driftJson(const Drift& drift) {
  Json json{{"kind", kindWord(drift.kind)}, {"from_s", finite(drift.from_s)}};
  constexpr std::array kGrowths{"unclear", "power", "exponential"};
  json["growth"] =
      drift.kind == DriftKind::kDrift ? Json(kGrowths[static_cast<std::size_t>(drift.growth)]) : Json();
  json["order"] = finite(drift.order);
  json["rate_per_s"] = finite(drift.rate);
  return json;
}

Json quantityJson(const GradedQuantity& quantity) {
  if (!quantity.errors) return {};
  const ErrorSummary& e = *quantity.errors;
  Json json{{"unit", quantity.unit},         {"from", quantity.from},    {"largest", finite(e.largest)},
            {"largest_at_s", e.largestAt_s}, {"final", finite(e.final)}, {"rms", finite(e.rms)},
            {"drift", driftJson(e.drift)}};
  if (!e.signedFinal) return json;
  json["signed_final"] = finite(*e.signedFinal);
  json["trend"] = e.trend == Trend::kNone ? Json() : Json(trendWord(e.trend));
  return json;
}

Json quantitiesJson(const std::vector<GradedQuantity>& quantities) {
  Json json = Json::object();
  for (const GradedQuantity& quantity : quantities) json[std::string(quantity.key)] = quantityJson(quantity);
  return json;
}

Json fitJson(const std::optional<Fit>& fit) {
  if (!fit) return {};
  Json causes = Json::array();
  for (const FitCause& cause : fit->causes) causes.push_back({{"if", cause.condition}, {"remark", cause.remark}});
  return {{"causes", causes}, {"quantities", quantitiesJson(fit->quantities)}};
}

}  // namespace

std::string gradeTable(const Grade& grade) {
  std::string text = fmt::format("{} row{}, t = {} to {} s\n\n", grade.rows, grade.rows == 1 ? "" : "s",
                                 grade.first_s, grade.last_s);
  std::size_t unitWidth = 0;
  for (const GradedQuantity& quantity : grade.quantities)
    unitWidth = std::max(unitWidth, unitWord(quantity).size());
  text += fmt::format(kRow, "error of", "largest", "", unitWidth, "at t (s)", "final", "rms", "drift");
  for (const GradedQuantity& quantity : grade.quantities) text += row(quantity, unitWidth);
  text += "\nrel: relative to the largest true value of the run.\n" + derivedText(grade) + trendText(grade);
  for (const std::string& note : grade.notes) text += sentence(note);
  return text;
}

std::string gradeJson(const Grade& grade, const std::string& fileName, const std::string& sceneName) {
  const Json json{{"file", fileName},           {"scene", sceneName},
                  {"rows", grade.rows},         {"from_s", grade.first_s},
                  {"to_s", grade.last_s},       {"quantities", quantitiesJson(grade.quantities)},
                  {"fits", fitJson(grade.fit)}, {"notes", grade.notes}};
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace poinsot::reference
