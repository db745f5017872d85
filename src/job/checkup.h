// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// Checks of what poinsot needs from this machine, as `poinsot doctor` prints them.
namespace poinsot::job {

struct Finding {
  enum class State {
    kGood,
    kAbsent,  ///< an optional part is missing
    kBad,     ///< films cannot be made
  };

  State state = State::kGood;
  std::string subject;  ///< for example "film hevc"
  std::string
      text;  ///< what was found, or what is wrong and the package, variable or kernel that fixes the problem
};

/// Runs all checks, which include rendering a film of one second. Takes some seconds if shaders have to be
/// compiled. Opens OpenGL in this process.
std::vector<Finding> checkup();

}  // namespace poinsot::job
