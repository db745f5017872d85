// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace poinsot::gl {

/// Returns whether the user turned the cache off, by POINSOT_CACHE=off.
bool isShaderCacheOff();

/// The folder in which Mesa keeps the machine code of shaders from one process to the next; made if need be. Empty
/// where there is none: compiling takes each process 0.5 to 3 s then.
///
/// It is $POINSOT_CACHE/shaders-..., else $XDG_CACHE_HOME/poinsot/..., else $HOME/.cache/poinsot/...; the name
/// ends in a hash of the profile and of what the CPU can do, since a home folder may be shared by many machines.
/// Code is run from there: it is not used if anybody else may write to $POINSOT_CACHE (or what stands for it), to
/// a folder or file beneath, or owns one. POINSOT_CACHE=off: none.
std::filesystem::path shaderCacheFolder(bool reproducible);

}  // namespace poinsot::gl
