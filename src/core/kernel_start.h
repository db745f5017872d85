// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"

/// Identifiers of the scope in which PIDs and locks are valid. Both are read only once, so that a sandboxed
/// process still has them if it read them before.
namespace poinsot::core {

/// Returns the boot ID of the kernel, which all its containers share. Empty without /proc.
const std::string& kernelStart();

/// Returns twelve hexadecimal digits that identify the boot and the PID namespace, so that two processes with the
/// same digits see the same PIDs. Empty without /proc.
const std::string& processSpace();

}  // namespace poinsot::core
