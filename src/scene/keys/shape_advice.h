// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "scene/keys/leaves.h"
#include "scene/shapes.h"

namespace poinsot::scene {

/// Returns an example of the key `size` for a shape, as TOML.
std::string_view sizeExample(const NamedShape& shape);

/// Returns the shape of this program for a word such as "cuboid", "spinning top" or "sphear"; empty if none is
/// near.
std::string nearestShape(std::string_view word);

/// Returns whether a shape is round about its z axis.
bool isRound(std::string_view shape);

/// Returns advice for a value that is not a shape, as the end of a message: a shape with the keys that the scene
/// lacks, or two parts in place of a dumbbell.
/// @param path  path of the key, such as "body.shape"
std::string shapeAdvice(const std::string& path, const Node& given, const Leaves& leaves);

/// Returns a spin axis as TOML: "3" for a round shape or for two equal moments, otherwise the axis of the largest
/// moment.
std::string spinAxisText(const Leaves& leaves);

/// Returns a pivot below the body's centre of mass as TOML, by the size of the body if the scene gives it.
std::string pivotText(const Leaves& leaves);

}  // namespace poinsot::scene
