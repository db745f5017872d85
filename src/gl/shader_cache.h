// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::gl {

/// Reports whether the user turned the cache off with POINSOT_CACHE=off.
bool isShaderCacheOff();

/// Returns the folder in which Mesa keeps compiled shaders from one process to the next, and makes it if
/// necessary. Empty if there is none; compiling then takes each process 0.5 to 3 s.
///
/// The folder is $POINSOT_CACHE/shaders-..., otherwise $XDG_CACHE_HOME/poinsot/..., otherwise
/// $HOME/.cache/poinsot/.... Its name ends in a hash of the profile and of the CPU's features, because many
/// machines may share a home folder. Code is run from the folder, so it is not used if another user owns or may
/// write to $POINSOT_CACHE (or what replaces it) or anything beneath. POINSOT_CACHE=off means no folder.
std::filesystem::path shaderCacheFolder(bool reproducible);

}  // namespace poinsot::gl
