// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/keys/leaves.h"

namespace poinsot::scene {

/// Returns the message for a value that its key rejected: the message of check(), with the value in the form that
/// the key takes, as a line to paste.
/// @param message  message of check(), which begins with the path
std::string withAdvice(std::string message, const std::string& path, const Node& given, Leaves& leaves);

}  // namespace poinsot::scene
