// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace poinsot {

/// A call that breaks a precondition of an installed header.
struct Breach {
  std::string header;            ///< for example "image/image.h"
  std::string condition;         ///< part of the text after @pre
  std::function<void()> commit;  ///< breaks the precondition; must throw std::logic_error
};

std::vector<Breach> breachesOfValues();    ///< breaches in physics, geometry, scene and image
std::vector<Breach> breachesOfPictures();  ///< breaches in all other layers

}  // namespace poinsot
