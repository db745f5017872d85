// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "scene/document/document.h"
#include "scene/keys/keys.h"

namespace poinsot::scene {

/// The value in SI if it has the key's type, dimension and range; otherwise empty, and `problems` says why, at the
/// value (at the element where that is one of several). `path` names it: the key's, with an index for each [].
/// Of a range with a limit, `limits` has the end.
std::optional<Checked> check(const Key& key, std::string_view path, const Node& node, Problems& problems,
                             const Limits& limits = {});

}  // namespace poinsot::scene
