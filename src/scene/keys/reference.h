// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"

namespace poinsot::scene {

/// JSON Schema, draft 4, of a scene file, for editors; pretty, newline at the end.
std::string schemaJson();

/// docs/scene.md: every key with type, range, default and help; units, presets and limits.
std::string referenceMarkdown();

}  // namespace poinsot::scene
