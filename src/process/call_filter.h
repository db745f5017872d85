// SPDX-License-Identifier: Apache-2.0
#pragma once

/// System calls that a renderer has no use for, refused by the kernel from here on, for good, in this process and
/// in all that it starts (seccomp). They fail with EPERM.
namespace poinsot::process {

/// Networks, other programs, other processes, file systems, privileges, and the kernel's rarer doors.
/// @pre the process can gain no privileges. @throws core::Error(kGraphics) where the kernel has no filters.
void forbidCalls();

/// Besides these, new processes; threads may be started.
void forbidProcesses();

}  // namespace poinsot::process
