// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::stage {

/// Returns the name of the point at the tip of an arrow (draw::NamedPoint), made from the arrow's label in TeX:
/// "omega1" for "$\omega_1$", "vP" for "$\mathbf{v}_P$", "my-arrow" for "my arrow". Alphabets, accents and
/// everything but ASCII letters, digits and hyphens are left out. Spaces become hyphens. A name that would begin
/// with a digit begins with "v", and an empty name is "vector".
std::string pointName(std::string_view tex);

}  // namespace poinsot::stage
