// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/keys.h"

namespace poinsot::scene {

/// Returns the keys whose names, help texts and foreign names share the most words with an unknown name, the best
/// first and at most three. Words that few keys have count more than others. Keys of the same table come first;
/// keys of a view and of other arrays of tables never appear. Empty if no key is near.
/// @param path  path of the unknown name, such as "time.film_length"
/// @param takes  returns whether a key accepts the value of the name in some form; may be null
std::vector<const Key*> similarKeys(std::string_view path, const std::function<bool(const Key&)>& takes = nullptr);

/// Returns the first sentence of a key's help without its point, shortened at a colon, a comma or 60 characters:
/// "Length of the film" for time.duration.
std::string shortHelp(const Key& key);

}  // namespace poinsot::scene
