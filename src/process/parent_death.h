// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

namespace poinsot::process {

/// Makes the kernel kill this new process when `parent`, which forked it, ends in any way.
void dieWith(pid_t parent);

}  // namespace poinsot::process
