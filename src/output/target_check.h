// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include "output/file_kind.h"
#include "output/frame_pattern.h"

namespace poinsot::output {

/// Checks, before any frame is drawn, that an output can be written and may replace an existing file. The folder
/// of the target must exist and be writable. The target must not be a folder, link, device or pipe. An existing
/// file must be an earlier output of the same kind, unless `force` is true. Commands call this function through
/// RunFiles.
/// @throws core::Error(kIo) naming the path, the reason and the remedy.
void checkTarget(const std::filesystem::path& target, bool force, const FileKind& kind = drawnKind());

/// Checks a target like checkTarget(), but its parent folders may be missing, because they will be created. The
/// nearest existing folder must be writable.
void checkTargetInNewFolder(const std::filesystem::path& target, bool force, const FileKind& kind);

/// Checks that text may be appended to a file, or that the file can be created. An existing regular file must be
/// empty or an earlier output of the kind, unless `force` is true. @throws core::Error(kIo) as checkTarget().
void checkAddedTo(const std::filesystem::path& target, bool force, const FileKind& kind);

/// Checks the frames first..last of a sequence like checkTarget(). Their folder may be missing if its parent
/// exists.
void checkSequence(const FramePattern& pattern, std::int64_t first, std::int64_t last, bool force);

}  // namespace poinsot::output
