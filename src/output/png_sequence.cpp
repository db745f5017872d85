// SPDX-License-Identifier: Apache-2.0
#include "output/png_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/file_error.h"
#include "core/text.h"

namespace poinsot::output {
namespace {

constexpr const char* kDigestKey = "Frame-SHA256";

void createFolder(const std::filesystem::path& folder) {
  std::error_code failure;
  if (std::filesystem::is_directory(folder, failure)) return;
  std::filesystem::create_directory(folder, failure);
  // Two workers may create the folder at the same time. The failure of the second one is ignored.
  if (!failure || std::filesystem::is_directory(folder)) return;
  throw core::FileError(
      core::ErrorKind::kIo,
      fmt::format("{}: folder cannot be created: {}", core::printable(folder.native()), failure.message()), folder,
      failure.value());
}

std::vector<std::uint8_t> encoded(const image::AnyImage& any, const std::vector<image::PngText>& texts, double dpi,
                                  core::StepLedger* steps) {
  const core::StepScope timing(steps, core::Step::kEncode);
  return std::visit([&](const auto& picture) { return image::encodePng(picture, texts, dpi); }, any);
}

}  // namespace

image::PngText digestText(const std::string& digest) { return {kDigestKey, digest}; }

std::vector<std::int64_t> framesThere(const FramePattern& pattern) {
  std::vector<std::int64_t> frames;
  std::error_code failure;
  const auto folder = core::folderOf(pattern.path(0));
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
    if (const auto k = pattern.frameOf(entry->path().filename()); k && image::isOwnPng(entry->path(), kDigestKey))
      frames.push_back(*k);
  std::ranges::sort(frames);
  return frames;
}

void writePng(const std::filesystem::path& target, const image::AnyImage& picture,
              const std::vector<image::PngText>& texts, double dpi, core::StepLedger* steps,
              core::Durability durability) {
  const auto bytes = encoded(picture, texts, dpi, steps);
  const core::StepScope timing(steps, core::Step::kWrite);
  core::writeFileAtomically(target, bytes, durability);
}

PngSequence::PngSequence(FramePattern pattern, SequenceOptions options)
    : pattern_(std::move(pattern)), options_(std::move(options)) {
  createFolder(core::folderOf(pattern_.path(0)));
}

bool PngSequence::has(std::int64_t k) const {
  if (!options_.resume || !options_.digestOf) return false;
  const auto texts = image::textsOfWholePng(pattern_.path(k));
  const auto said = [&](const image::PngText& text) {
    return text.key == kDigestKey && text.value == options_.digestOf(k);
  };
  return texts && std::ranges::any_of(*texts, said);
}

void PngSequence::write(const image::Frame& frame, std::int64_t k) {
  const auto target = pattern_.path(k);
  std::vector<image::PngText> texts = options_.texts;
  if (options_.digestOf) texts.push_back(digestText(options_.digestOf(k)));
  const auto bytes = encoded(frame.picture, texts, 0, options_.steps);
  const core::StepScope timing(options_.steps, core::Step::kWrite);
  core::AtomicFile file(target, options_.temporaryFolder);
  file.write(bytes);
  file.commit(core::Durability::kRenamed);
  unsynced_.push_back(target);
}

void PngSequence::finish() {
  if (unsynced_.empty()) return;
  const core::StepScope timing(options_.steps, core::Step::kWrite);
  for (const auto& file : unsynced_) core::syncFile(file);
  core::syncFolderOf(unsynced_.front());  // all frames share one folder
  unsynced_.clear();
}

}  // namespace poinsot::output
