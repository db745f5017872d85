// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "loaded_scene.h"

namespace poinsot::python {

/// Remark with its place; the line is 0 if there is no place.
struct Remark {
  std::string file;
  int line = 0, column = 0;
  std::string message;
};

/// Remarks of `check` on a loaded scene, and the memory that its pictures need.
struct Checkup {
  std::vector<Remark> problems;    ///< reasons why nothing can be drawn; empty if there are none
  std::vector<Remark> notes;       ///< values that are allowed but may be mistakes
  double filmMemory_bytes = 0;     ///< needed by a worker that makes an MP4
  double pictureMemory_bytes = 0;  ///< needed to draw one picture
};

Checkup checkupOf(const LoadedScene& scene);

}  // namespace poinsot::python
