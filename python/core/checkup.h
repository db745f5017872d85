// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "loaded_scene.h"

namespace poinsot::python {

/// A remark, and where it was found: line 0 of what has no line.
struct Remark {
  std::string file;
  int line = 0, column = 0;
  std::string message;
};

/// What `check` says of a scene that was loaded, and what a film of it takes.
struct Checkup {
  std::vector<Remark> problems;    ///< why nothing can be drawn; empty where all is well
  std::vector<Remark> notes;       ///< what is allowed and may be a slip
  double filmMemory_bytes = 0;     ///< of a worker that makes its film, an MP4
  double pictureMemory_bytes = 0;  ///< of drawing one picture
};

Checkup checkupOf(const LoadedScene& scene);

}  // namespace poinsot::python
