// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Ways to give the start of the motion, and which of them combine. The parser, the reference and a test over all
/// pairs use this table.
namespace poinsot::scene {

/// Part of the start that a way gives: the rotation, a property of a spin that `spin` gives, or the attitude.
enum class StartPart { kRotation, kTilt, kTop, kAttitude };

struct StartWay {
  std::string_view name;  ///< name in messages and in the reference, such as "spin and spin_axis"
  StartPart part;
  /// Names of the keys below [motion]. A name that ends in a point is a table, and stands for its keys. A name may
  /// belong to two ways; it then counts for those of which the scene gives the first key.
  std::vector<std::string_view> keys;
  std::size_t required = 1;  ///< the first `required` keys must be given
};

std::span<const StartWay> startWays();

/// Returns the way with this name. @pre there is one
const StartWay& startWay(std::string_view name);

/// Returns whether a scene may give the start in both ways. @pre the two differ
bool combine(const StartWay& a, const StartWay& b);

/// Returns a table in Markdown: which rotations combine with which tilts, tops and attitudes. Two ways that give
/// the same part never combine.
std::string startWaysMarkdown();

}  // namespace poinsot::scene
