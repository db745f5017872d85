// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "output/file_kind.h"
#include "output/frame_pattern.h"

namespace poinsot::output {

/// Fails early, before any frame is drawn, where an output could not or should not be written: its folder is
/// missing or not writable; it is a folder, link, device or pipe; or a file that is not an earlier output of its
/// kind, unless `force`. Commands enter their outputs in RunFiles, which calls this.
/// @throws core::Error(kIo) naming the path, the reason and the way out.
void checkTarget(const std::filesystem::path& target, bool force, const FileKind& kind = drawnKind());

/// Likewise where missing folders above the target are made for it: the nearest one that exists must be writable.
void checkTargetInNewFolder(const std::filesystem::path& target, bool force, const FileKind& kind);

/// Fails early where text could not or should not be added to a file, or the file could not be made: a regular
/// file that is there must be empty or of the kind, unless `force`. @throws core::Error(kIo) as checkTarget().
void checkAddedTo(const std::filesystem::path& target, bool force, const FileKind& kind);

/// Likewise checks every frame first..last of a sequence. Its folder may be missing if the folder above exists.
void checkSequence(const FramePattern& pattern, std::int64_t first, std::int64_t last, bool force);

}  // namespace poinsot::output
