// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"

/// Identifiers of the running kernel and the PID namespace. Each is read once and cached, so that a process can
/// still use it after it has entered a sandbox.
namespace poinsot::core {

/// Returns the boot ID of the kernel, which is the same in all containers of a machine. Empty without /proc.
const std::string& kernelStart();

/// Returns twelve hexadecimal digits that identify the boot and the PID namespace. Processes with the same digits
/// see the same PIDs. Empty without /proc.
const std::string& processSpace();

}  // namespace poinsot::core
