// SPDX-License-Identifier: Apache-2.0
#include "reference/grade_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "core/text.h"
#include "reference/trajectory.h"

namespace poinsot::reference {
namespace {

struct Vector {
  TrajectoryPlace place;
  std::size_t length;
};

constexpr Vector kVectors[] = {{kQAt, 4},  {kOmegaBAt, 3}, {kOmegaWAt, 3},
                               {kLWAt, 3}, {kRateBAt, 3},  {kRateWAt, 3}};

std::string namesOf(const Vector& vector) {
  std::string names;
  for (const TrajectoryColumn& column : std::span(kTrajectoryColumns).subspan(vector.place, vector.length))
    names.append(names.empty() ? "" : ", ").append(column.name);
  return names;
}

/// Returns whether a column name probably means the time: "time", "Time [s]", "t_s", "t (s)".
bool meansTime(std::string_view name) {
  const auto startsWith = [&](std::string_view word) {
    return std::ranges::equal(name.substr(0, word.size()), word, {}, [](char c) { return c | 0x20; });
  };
  return startsWith("time") ||
         (startsWith("t") && name.size() > 1 && std::string_view("_ ([/").find(name[1]) != std::string_view::npos);
}

}  // namespace

std::size_t GradeColumns::columnNamed(std::string_view name) {
  const auto* found = std::ranges::find(kTrajectoryColumns, name, &TrajectoryColumn::name);
  return found == kTrajectoryColumns.end() ? kForeign
                                           : static_cast<std::size_t>(found - kTrajectoryColumns.begin());
}

GradeColumns::GradeColumns(const std::vector<std::string>& names) : names_(names) {
  for (const std::string& name : names) {
    all_.push_back(columnNamed(name));
    if (all_.back() != kForeign) known_.push_back(all_.back());
  }
}

bool GradeColumns::has(std::size_t column) const { return std::ranges::find(known_, column) != known_.end(); }

std::optional<std::size_t> GradeColumns::repeated() const {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const auto end = all_.begin() + static_cast<std::ptrdiff_t>(i);
    if (all_[i] != kForeign && std::find(all_.begin(), end, all_[i]) != end) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> GradeColumns::timeAt() const {
  const auto found = std::ranges::find(all_, std::size_t{kTimeAt});
  return found == all_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all_.begin()));
}

std::string GradeColumns::timeHint() const {
  const auto found = std::ranges::find_if(names_, meansTime);
  return found == names_.end() ? "" : fmt::format("; if '{}' is the time, name it t", core::printable(*found));
}

std::string GradeColumns::lack() const {
  for (const Vector& vector : kVectors) {
    std::size_t count = 0, missing = 0;
    for (std::size_t i = vector.place; i < vector.place + vector.length; ++i) {
      count += has(i);
      if (!has(i)) missing = i;
    }
    if (count > 0 && count < vector.length)
      return fmt::format("column {} is missing; give all of {}", kTrajectoryColumns[missing].name,
                         namesOf(vector));
  }
  if (has(kQAt) || has(kOmegaBAt) || has(kOmegaWAt)) return "";
  return "no motion to grade: expected the columns q_w, q_x, q_y, q_z or omega_B_x, omega_B_y, omega_B_z" +
         foreignText();
}

/// Returns ", got qx, qy" with up to eight unknown column names. Returns an empty text if there are none.
std::string GradeColumns::foreignText() const {
  constexpr std::size_t kMost = 8;
  std::string names;
  for (std::size_t i = 0, count = 0; i < names_.size() && count < kMost; ++i)
    if (all_[i] == kForeign && ++count > 0) names += (names.empty() ? "" : ", ") + core::printable(names_[i]);
  return names.empty() ? "" : ", got " + names;
}

}  // namespace poinsot::reference
