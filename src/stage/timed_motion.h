// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/step_times.h"
#include "physics/motion.h"

namespace poinsot::stage {

/// The motion, with the time of its states entered into the ledger: then it is of one thread. Without a ledger as
/// it is.
std::shared_ptr<const physics::Motion> timed(std::shared_ptr<const physics::Motion> motion,
                                             core::StepLedger* steps);

}  // namespace poinsot::stage
