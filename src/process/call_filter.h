// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Filters of system calls (seccomp). A filter holds for this process and all processes that it starts, and cannot
/// be removed. A forbidden call fails with EPERM.
namespace poinsot::process {

/// Forbids system calls for networks, other programs, other processes, mounting and privileges, and rare
/// interfaces of the kernel.
/// @pre the process can gain no privileges. @throws core::Error(kGraphics) if the kernel does not support filters
void forbidCalls();

/// Forbids new processes. Call after forbidCalls(). Threads are still allowed.
void forbidProcesses();

}  // namespace poinsot::process
