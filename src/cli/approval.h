// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/scene_options.h"

namespace poinsot::cli {

/// A picture is approved by somebody who looked at it.
/// @throws core::Error(kUsage) where the environment says CI, and for what is not trusted.
void expectMayApprove(const AllowanceOptions& options);

}  // namespace poinsot::cli
