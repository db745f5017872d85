// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "draw/picture.h"
#include "stage/moment.h"
#include "stage/type/lettering.h"

namespace poinsot::stage {

/// Interface for composing the pictures of a film as plain values. compose() is a pure function of the moment.
class Composer {
 public:
  virtual ~Composer() = default;

  /// Returns the picture at a moment.
  /// @param size_px  width and height
  /// @param sizing  sizes of text and lines, such as printSizing()
  /// @pre the film time is finite and not negative; width, height > 0.
  /// @throws core::Error(kLimit) beyond the film's end.
  virtual draw::Picture compose(const Moment& moment, glm::ivec2 size_px, const Sizing& sizing) const = 0;
  /// Returns the picture at a moment. Text and lines are large enough to be legible from a distance.
  draw::Picture compose(const Moment& moment, glm::ivec2 size_px) const {
    return compose(moment, size_px, screenSizing(size_px));
  }

 protected:
  Composer() = default;
  Composer(const Composer&) = default;
  Composer(Composer&&) = default;
  Composer& operator=(const Composer&) = default;
  Composer& operator=(Composer&&) = default;
};

}  // namespace poinsot::stage
