// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::gl {

/// Reports whether the user disabled the cache with POINSOT_CACHE=off.
bool isShaderCacheOff();

/// Returns the folder in which Mesa keeps compiled shaders for later processes. Creates the folder if necessary.
/// Returns an empty path if no folder can be used; each process then compiles its shaders, which takes 0.5 to 3 s.
///
/// The folder is $POINSOT_CACHE/shaders-..., otherwise $XDG_CACHE_HOME/poinsot/..., otherwise
/// $HOME/.cache/poinsot/.... POINSOT_CACHE=off means no folder. The name ends in a hash of the profile and of the
/// CPU's features, because several machines may have a home folder in common.
///
/// Mesa executes code from the folder. The folder is therefore not used if another user owns, or may write to,
/// $POINSOT_CACHE (or the folder that replaces it) or anything in it.
std::filesystem::path shaderCacheFolder(bool reproducible);

}  // namespace poinsot::gl
