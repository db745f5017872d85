// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace poinsot::faults {

std::vector<std::string> galleryScenes();

/// Returns one of the scenes with one to three changes. Numbers become extreme, values change their type, lines
/// are removed, repeated or taken from another scene, bytes change, the end is cut off. Equal numbers give equal
/// texts.
std::string mutatedScene(const std::vector<std::string>& scenes, std::uint32_t number);

}  // namespace poinsot::faults
