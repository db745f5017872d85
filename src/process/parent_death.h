// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

namespace poinsot::process {

/// In a new process: it is killed when `parent`, the process that forked it, ends in whatever way.
void dieWith(pid_t parent);

}  // namespace poinsot::process
