// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

/// Sentences of which altText() consists, and functions that write values with units in words.
namespace poinsot::describe {

using Sentences = std::vector<std::string>;

/// Returns the name of a principal axis: "e1" to "e3" for axis 0 to 2.
std::string axisName(int axis);

Sentences bodySentences(const scene::Scene& scene);
Sentences motionSentences(const scene::Scene& scene);
Sentences pictureSentences(const scene::Scene& scene);

/// Returns a number with three digits, such as "0.0123", "12800" or "8.01 × 10³⁷".
/// @param scale  typical magnitude; a value of at most 1e-12 times this size is a rounding error and becomes "0"
std::string numberWords(double value, double scale = 0);

/// Returns a time in a suitable unit, such as "12 ms", "8.4 s" or "312 days". Returns "an infinite time" for
/// infinity.
std::string timeWords(double time_s);

/// Returns a length in centimetres if it is below 1 m, otherwise in metres: "17 cm", "12800 m".
std::string lengthWords(double length_m);

/// Returns an angle in degrees, such as "25.3°".
std::string angleWords(double angle_rad);

std::string rateWords(double rate);

/// Returns a rate of rotation in rad/s and the time of a turn, such as "3.78 rad/s, one turn in 1.66 s". If a turn
/// takes less than 0.5 s, returns the turns a second instead of the time.
std::string turningWords(double rate);

/// Returns a list in words: "a", "a and b", "a, b and c".
std::string listWords(const std::vector<std::string>& words);

}  // namespace poinsot::describe
