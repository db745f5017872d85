// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"

/// Identifies what process numbers and locks are valid for. Both texts are read once, so that they are known in
/// a sandbox, too, if they were asked for before.
namespace poinsot::core {

/// Returns a text that differs from one start of a kernel to the next, and is the same in all its containers.
/// Empty without /proc.
const std::string& kernelStart();

/// Returns twelve hexadecimal digits: in two processes they are equal if both see the same process numbers, those
/// of one container or machine since its start. Empty without /proc.
const std::string& processSpace();

}  // namespace poinsot::core
