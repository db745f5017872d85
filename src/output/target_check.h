// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "output/file_kind.h"
#include "output/frame_pattern.h"

namespace poinsot::output {

/// Checks, before any frame is drawn, that an output can and may be written. Fails if its folder is missing or not
/// writable; if the target is a folder, link, device or pipe; or if it is a file that is not an earlier output of
/// its kind, unless `force`. Commands enter their outputs in RunFiles, which calls this function.
/// @throws core::Error(kIo) naming the path, the reason and the remedy.
void checkTarget(const std::filesystem::path& target, bool force, const FileKind& kind = drawnKind());

/// Checks as checkTarget(), for a target whose missing parent folders are created later: the nearest folder that
/// exists must be writable.
void checkTargetInNewFolder(const std::filesystem::path& target, bool force, const FileKind& kind);

/// Checks that text can and may be appended to a file, or that the file can be created. An existing regular file
/// must be empty or of the kind, unless `force`. @throws core::Error(kIo) as checkTarget().
void checkAddedTo(const std::filesystem::path& target, bool force, const FileKind& kind);

/// Checks the frames first..last of a sequence as checkTarget(). Their folder may be missing if its parent exists.
void checkSequence(const FramePattern& pattern, std::int64_t first, std::int64_t last, bool force);

}  // namespace poinsot::output
