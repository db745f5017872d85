// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"

namespace poinsot::scene {

/// Returns the JSON Schema (draft 4) of a scene file, for editors. The text is indented and ends with a newline.
std::string schemaJson();

/// Returns docs/scene.md, which lists all keys with type, range, default and help, and units, presets and limits.
std::string referenceMarkdown();

}  // namespace poinsot::scene
