// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {

struct Fault {
  const char* name;
  const char* file;
  const char* from;
  const char* to;
};

void PrintTo(const Fault& fault, std::ostream* out);

/// Returns the file below `folder` with the fault. Fails the test if the passage no longer exists.
std::string textWith(const Fault& fault, const std::string& folder);

/// Tests of the golden suite that together draw every kind of object.
inline constexpr const char* kTestsOfEverything =
    "gallery_poinsot_rolling gallery_tennis_racket gallery_football gallery_heavy_top body_box body_parts "
    "body_t_handle "
    "cones_in_the_ellipsoid plane_of_L trace view_isometric view_precession";

ShellResult runSuite(const ScratchFolder& folder, const std::string& program, const std::string& manifest,
                     const std::string& tests, const std::vector<std::string>& environment = {});

/// Expects that the pictures were drawn and look wrong. A program or shader that fails would prove nothing.
void expectCaught(const ShellResult& suite);

}  // namespace poinsot
