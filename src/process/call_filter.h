// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Filters of system calls (seccomp), which stay for good in this process and all that it starts. A forbidden call
/// fails with EPERM.
namespace poinsot::process {

/// Forbids calls for networks, other programs and processes, mounting, privileges and rare parts of the kernel.
/// @pre the process can gain no privileges. @throws core::Error(kGraphics) if the kernel has no such filters
void forbidCalls();

/// Forbids new processes, in addition to forbidCalls(). Threads may still be started.
void forbidProcesses();

}  // namespace poinsot::process
