// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {

/// A passage of a source file, and what a slip would make of it.
struct Fault {
  const char* name;
  const char* file;
  const char* from;
  const char* to;
};

// What GoogleTest and ctest print of a case.
void PrintTo(const Fault& fault, std::ostream* out);

/// The file beneath `folder` with the fault in it; fails the test where the passage is not there any more.
std::string textWith(const Fault& fault, const std::string& folder);

/// Tests of the golden suite that have between them every kind of thing that is drawn.
inline constexpr const char* kTestsOfEverything =
    "gallery_poinsot_rolling gallery_tennis_racket gallery_football gallery_heavy_top body_box body_parts "
    "body_t_handle "
    "cones_in_the_ellipsoid plane_of_L trace view_isometric view_precession";

/// The exit code of a golden suite and what it printed; new pictures go into a folder of the scratch folder.
ShellResult runSuite(const ScratchFolder& folder, const std::string& program, const std::string& manifest,
                     const std::string& tests, const std::vector<std::string>& environment = {});

/// It was drawn, and looked wrong: a program or shader that does not work would prove nothing.
void expectCaught(const ShellResult& suite);

}  // namespace poinsot
