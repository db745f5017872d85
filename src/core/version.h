// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::core {

/// "0.1.0".
const char* version();

}  // namespace poinsot::core
