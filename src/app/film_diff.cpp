// SPDX-License-Identifier: Apache-2.0
#include "app/film_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "app/parallel.h"
#include "core/error.h"
#include "output/film_reader.h"

namespace poinsot::app {
namespace {

struct FramePair {
  DiffPicture reference, test;
};

DiffPicture diffPicture(image::AnyImage pixels) {
  const int channels = std::visit([](const auto& p) { return p.channels; }, pixels);
  return {std::move(pixels), channels};
}

/// Two films that are read side by side.
class FilmPair {
 public:
  FilmPair(const std::filesystem::path& reference, const std::filesystem::path& test)
      : reference_(reference), test_(test) {}

  core::Rational fps() const { return reference_.fps(); }

  /// Why they do not go together, before their frames are counted.
  std::string mismatch() const {
    const image::PixelSize a = reference_.size(), b = test_.size();
    if (a != b) return fmt::format("the size is {}x{}, not {}x{}", b.width, b.height, a.width, a.height);
    if (reference_.fps() != test_.fps())
      return fmt::format("the film has {} frames a second, not {}", core::toString(test_.fps()),
                         core::toString(reference_.fps()));
    return "";
  }

  /// The next pairs, as many as there are up to `most`.
  std::vector<FramePair> next(std::size_t most) {
    std::vector<FramePair> pairs;
    while (pairs.size() < most) {
      auto a = reference_.next(), b = test_.next();
      framesOfReference_ += a ? 1 : 0;
      framesOfTest_ += b ? 1 : 0;
      if (!a || !b) break;
      pairs.push_back({diffPicture(std::move(*a)), diffPicture(std::move(*b))});
    }
    return pairs;
  }

  /// After the last pair.
  std::string lengthMismatch() {
    while (reference_.next()) ++framesOfReference_;
    while (test_.next()) ++framesOfTest_;
    if (framesOfReference_ == framesOfTest_) return "";
    return fmt::format("the film has {} frames, not {}", framesOfTest_, framesOfReference_);
  }

 private:
  output::FilmReader reference_, test_;
  std::int64_t framesOfReference_ = 0, framesOfTest_ = 0;
};

}  // namespace

image::Verdict FilmDiff::verdict() const {
  image::Verdict worst = mismatch.empty() ? image::Verdict::kIdentical : image::Verdict::kDifferent;
  for (const PictureDiff& frame : frames) worst = std::max(worst, frame.verdict);
  return worst;
}

std::size_t FilmDiff::worst() const {
  const auto mean = [](const PictureDiff& frame) { return frame.figures.flip.mean; };
  return static_cast<std::size_t>(std::ranges::max_element(frames, {}, mean) - frames.begin());
}

FilmDiff diffFilms(const std::filesystem::path& reference, const std::filesystem::path& test,
                   const DiffRequest& request, int jobs) {
  FilmPair films(reference, test);
  FilmDiff diff{films.mismatch(), films.fps(), {}};
  if (!diff.mismatch.empty()) return diff;
  for (auto pairs = films.next(static_cast<std::size_t>(jobs)); !pairs.empty();
       pairs = films.next(static_cast<std::size_t>(jobs))) {
    const std::size_t first = diff.frames.size();
    diff.frames.resize(first + pairs.size());
    forEachIndex(pairs.size(), jobs, [&](std::size_t i) {
      auto& [a, b] = pairs[i];
      diff.frames[first + i] = comparePictures(std::move(a), std::move(b), request).diff;
      diff.frames[first + i].name = fmt::format("{}", first + i);
    });
  }
  diff.mismatch = films.lengthMismatch();
  if (!diff.frames.empty() && (request.map || request.difference))
    forFrames(reference, test, {diff.worst()}, request,
              [&](std::size_t, const ComparedPictures& compared) { writeMaps(compared, request); });
  return diff;
}

void forFrames(const std::filesystem::path& reference, const std::filesystem::path& test,
               const std::vector<std::size_t>& frames, const DiffRequest& request,
               const std::function<void(std::size_t, const ComparedPictures&)>& visit) {
  FilmPair films(reference, test);
  std::size_t next = 0;
  for (const std::size_t frame : frames) {
    for (; next < frame; ++next) films.next(1);
    auto pairs = films.next(1);
    if (pairs.empty()) throw core::Error(core::ErrorKind::kIo, "a film became shorter while it was read");
    visit(next++, comparePictures(std::move(pairs[0].reference), std::move(pairs[0].test), request));
  }
}

}  // namespace poinsot::app
