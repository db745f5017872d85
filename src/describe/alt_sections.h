// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

/// The sentences of altText().
namespace poinsot::describe {

using Sentences = std::vector<std::string>;

/// The names of the principal axes, "e1" to "e3".
std::string axisName(int axis);

/// Describes the body: shape, size, mass, moments.
Sentences bodySentences(const scene::Scene& scene);
/// Describes the motion: what acts on the body, its rates and periods, what is conserved.
Sentences motionSentences(const scene::Scene& scene);
/// Describes the picture: what is drawn, in which colour, from where; the film's length and pace.
Sentences pictureSentences(const scene::Scene& scene);

/// To three digits: "0.0123", "12800", "8.01 × 10³⁷"; "0" for anything so small that it is rounding beside
/// `scale`.
std::string numberWords(double value, double scale = 0);

/// With the unit that suits it: "12 ms", "8.4 s", "312 days". Infinite: "an infinite time".
std::string timeWords(double time_s);

/// "17 cm", "12800 m".
std::string lengthWords(double length_m);

/// "25.3°"
std::string angleWords(double angle_rad);

/// "3.78 rad/s"
std::string rateWords(double rate);

/// "3.78 rad/s, one turn in 1.66 s", or so many turns a second.
std::string turningWords(double rate);

/// "a", "a and b", "a, b and c"
std::string listWords(const std::vector<std::string>& words);

}  // namespace poinsot::describe
