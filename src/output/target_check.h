// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "output/frame_pattern.h"

namespace poinsot::output {

/// Fails early, before any frame is drawn, where an output could not or should not be written: its folder is
/// missing or not writable; it is a folder, link, device or pipe; or a file that is not an earlier output of this
/// program (a picture, film, figure or page with our mark), unless `force`.
/// @throws core::Error(kIo) naming the path, the reason and the way out.
void checkTarget(const std::filesystem::path& target, bool force);

/// Checks that the folder of `target` exists and can be written to.
/// @throws core::Error(kIo) with the message of checkTarget().
void checkFolderOf(const std::filesystem::path& target);

/// Whether a regular file is empty, so that nothing is lost, or begins like that: how data are known again.
bool beginsWith(const std::filesystem::path& file, std::string_view mark);

/// The same for every frame first..last of a sequence. Its folder may be missing if the folder above exists.
void checkSequence(const FramePattern& pattern, std::int64_t first, std::int64_t last, bool force);

}  // namespace poinsot::output
