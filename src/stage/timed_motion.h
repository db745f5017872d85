// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/step_times.h"
#include "physics/motion.h"

namespace poinsot::stage {

/// Returns a motion that enters the time spent on its states into the ledger; only one thread may use the result.
/// Without a ledger, returns `motion` itself.
std::shared_ptr<const physics::Motion> timed(std::shared_ptr<const physics::Motion> motion,
                                             core::StepLedger* steps);

}  // namespace poinsot::stage
