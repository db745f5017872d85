// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

namespace poinsot::process {

/// Makes the kernel kill this process when `parent` ends. Call it in a new fork of `parent`.
void dieWith(pid_t parent);

}  // namespace poinsot::process
