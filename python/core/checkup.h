// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "loaded_scene.h"

namespace poinsot::python {

/// A remark and its place; the line is 0 if it has none.
struct Remark {
  std::string file;
  int line = 0, column = 0;
  std::string message;
};

/// Holds the remarks of `check` on a scene that was loaded, and the memory that its pictures take.
struct Checkup {
  std::vector<Remark> problems;    ///< reasons why nothing can be drawn; empty if all is well
  std::vector<Remark> notes;       ///< values that are allowed and may be slips
  double filmMemory_bytes = 0;     ///< that a worker needs for its film, an MP4
  double pictureMemory_bytes = 0;  ///< that drawing one picture needs
};

/// Returns the remarks and the memory; draws nothing.
Checkup checkupOf(const LoadedScene& scene);

}  // namespace poinsot::python
