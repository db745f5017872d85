// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// What of this machine poinsot can use, for people whose film does not come.
namespace poinsot::job {

struct Finding {
  enum class State {
    kGood,
    kAbsent,  ///< something that most do without
    kBad,     ///< no film can be made
  };

  State state = State::kGood;
  std::string subject;  ///< "films HEVC"
  std::string
      text;  ///< what there is; else what is wrong, and the package, the variable or the kernel that mends it
};

/// Goes through all of it; at the end of that makes a film of a second. Takes some seconds where shaders have to
/// be compiled. Opens GL in this process.
std::vector<Finding> checkup();

}  // namespace poinsot::job
