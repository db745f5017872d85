// SPDX-License-Identifier: Apache-2.0
#pragma once

// Includes the GLM types that pictures contain. Checks that they have the same layout as in the compiled library.
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/abi.h"

static_assert(sizeof(glm::vec2) == 8 && sizeof(glm::vec3) == 12 && sizeof(glm::mat3) == 36 &&
                  alignof(glm::vec2) == 4 && alignof(glm::vec3) == 4 && alignof(glm::mat3) == 4,
              "poinsot: GLM_FORCE_DEFAULT_ALIGNED_GENTYPES, or another of GLM's macros, changes the layout of "
              "GLM's vectors; omit it");
