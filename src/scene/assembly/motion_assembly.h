// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "scene/keys/draft.h"
#include "scene/keys/findings.h"

namespace poinsot::scene {

/// A body that does not turn, and that nothing sets going: the key that says so, and its value.
struct Rest {
  std::string path, value;
};

/// The start that the keys of [motion] describe together, into `motion`, whose forcing is known; what is wrong
/// goes to `findings`. `body` is null where that is wrong itself.
std::optional<Rest> assembleStart(const Draft& draft, const Body* body, Findings& findings, Motion& motion);

}  // namespace poinsot::scene
