// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/expect.h"
#include "physics/unaligned_types.h"
#include "scene/keys/keys.h"

/// Functions that assign a checked value to a field of the draft. The type of the field selects the conversion.
namespace poinsot::scene {

inline void assign(double& to, const Checked& value) { to = std::get<double>(value); }
inline void assign(bool& to, const Checked& value) { to = std::get<bool>(value); }
inline void assign(int& to, const Checked& value) {
  const auto* word = std::get_if<Word>(&value);
  to = word ? word->index : static_cast<int>(std::get<std::int64_t>(value));
}
inline void assign(std::uint32_t& to, const Checked& value) {
  to = static_cast<std::uint32_t>(std::get<std::int64_t>(value));
}
inline void assign(std::string& to, const Checked& value) { to = std::get<std::string>(value); }
inline void assign(core::Rational& to, const Checked& value) { to = std::get<core::Rational>(value); }
inline void assign(Eigen::Vector3d& to, const Checked& value) {
  const auto& v = std::get<std::vector<double>>(value);
  POINSOT_EXPECT(v.size() == 3);
  to = {v[0], v[1], v[2]};
}
inline void assign(Eigen::Vector2i& to, const Checked& value) {
  const auto& v = std::get<std::vector<double>>(value);
  POINSOT_EXPECT(v.size() == 2);
  to = {static_cast<int>(v[0]), static_cast<int>(v[1])};
}
inline void assign(Eigen::Matrix3d& to, const Checked& value) {
  const auto& v = std::get<std::vector<double>>(value);
  POINSOT_EXPECT(v.size() == 9);
  to << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
}
inline void assign(std::vector<std::string>& to, const Checked& value) {
  to = std::get<std::vector<std::string>>(value);
}
inline void assign(std::vector<int>& to, const Checked& value) {
  to.clear();
  for (const Word& word : std::get<std::vector<Word>>(value)) to.push_back(word.index);
}
inline void assign(std::vector<double>& to, const Checked& value) { to = std::get<std::vector<double>>(value); }
inline void assign(physics::Quaternion& to, const Checked& value) {
  const auto& v = std::get<std::vector<double>>(value);
  POINSOT_EXPECT(v.size() == 4);
  to = physics::Quaternion(v[0], v[1], v[2], v[3]).normalized();
}
template <class E>
requires std::is_enum_v<E>
void assign(E& to, const Checked& value) {
  to = static_cast<E>(std::get<Word>(value).index);  // the words are in the order of the enumerators
}
template <class E>
requires std::is_enum_v<E>
void assign(std::vector<E>& to, const Checked& value) {
  to.clear();
  for (const Word& word : std::get<std::vector<Word>>(value)) to.push_back(static_cast<E>(word.index));
}
/// Assigns a number, or nullopt if the value is a word such as "auto".
inline void assign(std::optional<double>& to, const Checked& value) {
  const auto* number = std::get_if<double>(&value);
  to = number ? std::optional(*number) : std::nullopt;
}
template <class T>
void assign(std::optional<T>& to, const Checked& value) {
  assign(to.emplace(), value);
}

/// Returns the function Key::put for a field of the draft.
/// @param place  returns the address of the field; for an array of tables, also takes the index of the element
template <class F>
std::function<void(Draft&, std::size_t, const Checked&)> into(F place) {
  return [place](Draft& draft, std::size_t element, const Checked& value) {
    if constexpr (std::is_invocable_v<F, Draft&, std::size_t>)
      assign(*place(draft, element), value);
    else
      assign(*place(draft), value);
  };
}

}  // namespace poinsot::scene
