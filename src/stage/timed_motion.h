// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/step_times.h"
#include "physics/motion.h"

namespace poinsot::stage {

/// Returns a wrapper of `motion` that adds the time spent on computing its states to the ledger. Only one thread
/// may use the wrapper. Without a ledger, returns `motion` itself.
std::shared_ptr<const physics::Motion> timed(std::shared_ptr<const physics::Motion> motion,
                                             core::StepLedger* steps);

}  // namespace poinsot::stage
