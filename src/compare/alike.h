// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/picture_diff.h"

namespace poinsot::compare {

/// Pictures that changed in the same way, for example because another version of a library draws text differently.
struct AlikeGroup {
  std::string kind;                  ///< kind of the change, see kindOf()
  std::vector<std::size_t> members;  ///< indices of the pictures, by falling FLIP mean; at least two
};

/// Groups pictures whose changes are alike: the same verdict and kind, the same place, and about the same size.
/// Two changes are at the same place if their bounding boxes, as fractions of their pictures, overlap by half.
/// They have about the same size if the mean FLIP error of one is at most twice that of the other. Each picture is
/// compared with the most changed picture of a group, so the order of the pictures has no influence.
/// @returns the groups of two or more pictures, the largest group first
std::vector<AlikeGroup> alikeChanges(const std::vector<const PictureDiff*>& diffs);

}  // namespace poinsot::compare
