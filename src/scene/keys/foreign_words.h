// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot::scene {

/// Returns a word in small letters with underscores: "rugby_ball" for "Rugby-Ball" and "rugby ball".
std::string plainWord(std::string_view text);

/// Returns the word of a key that a word of other programs stands for, such as "box" for "cuboid" and "middle" for
/// "intermediate"; otherwise empty.
std::string_view wordElsewhere(std::string_view word);

/// Returns all words that a word of other programs may stand for: "LAM" and "smallest" for "long_axis".
std::vector<std::string_view> wordsElsewhere(std::string_view word);

/// Returns the quantity of a plot for the name of another program, such as "E" for "total_energy"; otherwise
/// empty.
std::string_view quantityElsewhere(std::string_view word);

/// Returns a colour such as "#ffffff" for a name such as "white", or for "r" and "C1" as in matplotlib. Empty for
/// an unknown name.
std::string_view namedColor(std::string_view name);

/// Returns the acceleration of gravity in m/s² on a planet or on the Moon, as text; empty for another word.
std::string_view gravityOn(std::string_view world);

/// Returns the density of a material in kg/m³, as text; empty for an unknown material.
std::string_view densityOf(std::string_view material);

}  // namespace poinsot::scene
