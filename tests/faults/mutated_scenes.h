// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace poinsot::faults {

/// The text of every scene of the gallery.
std::vector<std::string> galleryScenes();

/// One of them with one to three changes: numbers become extreme, values change their kind, lines go, come twice
/// or from another scene, bytes are turned, the end is cut off. The same number is the same text.
std::string mutatedScene(const std::vector<std::string>& scenes, std::uint32_t number);

}  // namespace poinsot::faults
