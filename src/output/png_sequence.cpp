// SPDX-License-Identifier: Apache-2.0
#include "output/png_sequence.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "output/atomic_file.h"

namespace poinsot::output {
namespace {

void createFolder(const std::filesystem::path& folder) {
  std::error_code failure;
  if (std::filesystem::is_directory(folder, failure)) return;
  std::filesystem::create_directory(folder, failure);
  // Two workers may create it at once; either success will do.
  if (!failure || std::filesystem::is_directory(folder)) return;
  throw core::Error(core::ErrorKind::kIo, fmt::format("{}: folder cannot be created: {}",
                                                      core::printable(folder.native()), failure.message()));
}

}  // namespace

void writePng(const std::filesystem::path& target, const image::Image& picture,
              const std::vector<image::PngText>& texts, double dpi) {
  writeFileAtomically(target, image::encodePng(picture, texts, dpi));
}

PngSequence::PngSequence(FramePattern pattern, std::vector<image::PngText> texts)
    : pattern_(std::move(pattern)), texts_(std::move(texts)) {
  createFolder(folderOf(pattern_.path(0)));
}

void PngSequence::write(const image::Image& picture, std::int64_t k) {
  const auto target = pattern_.path(k);
  writeFileAtomically(target, image::encodePng(picture, texts_), Durability::kRenamed);
  unsynced_.push_back(target);
}

void PngSequence::finish() {
  if (unsynced_.empty()) return;
  for (const auto& file : unsynced_) syncFile(file);
  syncFolderOf(unsynced_.front());  // all frames share one folder
  unsynced_.clear();
}

}  // namespace poinsot::output
