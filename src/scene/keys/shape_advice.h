// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

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

/// Returns the principal moments of the scene, or those in an example of a message, in kg m². Empty if the body is
/// given in another way.
std::vector<double> momentsIn(const Leaves& leaves);

/// Returns whether the scene has [motion.gravity], or an unknown name stands for a key of this table.
bool isUnderGravity(const Leaves& leaves);

/// Returns a spin axis as TOML: the axis of symmetry of a round shape or of two equal moments. Otherwise "3" for a
/// top under gravity, and the axis of the largest moment for other bodies.
std::string spinAxisText(const Leaves& leaves);

/// Returns a pivot below the body's centre of mass as TOML, by the size of the body if the scene gives it.
std::string pivotText(const Leaves& leaves);

}  // namespace poinsot::scene
