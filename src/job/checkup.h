// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// Checks of the machine, such as OpenGL, codecs and memory, which `poinsot doctor` prints.
namespace poinsot::job {

struct Finding {
  enum class State {
    kGood,
    kAbsent,  ///< an optional feature is unavailable
    kBad,     ///< no film can be made
  };

  State state = State::kGood;
  std::string subject;  ///< name of the check, for example "film hevc"
  std::string text;     ///< result, or the problem and its fix: a package, environment variable or kernel
};

/// Runs all checks, including the render of a film of one second. Takes some seconds if shaders must be compiled.
/// Opens OpenGL in this process.
std::vector<Finding> checkup();

}  // namespace poinsot::job
