// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"

namespace poinsot::scene {

/// Returns the JSON Schema (draft 4) of a scene file, for editors; indented, with a newline at the end.
std::string schemaJson();

/// Returns docs/scene.md: every key with type, range, default and help; units, presets and limits.
std::string referenceMarkdown();

}  // namespace poinsot::scene
