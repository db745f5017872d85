// SPDX-License-Identifier: Apache-2.0
#include "compare/film_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "compare/memory.h"
#include "core/error.h"
#include "core/expect.h"
#include "core/interruption.h"
#include "core/parallel.h"
#include "core/text.h"
#include "image/png_file.h"
#include "output/film_reader.h"
#include "request/memory.h"

namespace poinsot::compare {
namespace {

struct FramePair {
  DiffPicture reference, test;
};

DiffPicture diffPicture(output::ShownPicture&& shown) { return {std::move(shown.picture)}; }

std::string filmsText(image::PixelSize size) {
  return fmt::format("comparing films of {}x{}", size.width, size.height);
}

/// Opens a film, unless the size in its header is too large to compare within the limits. Larger pictures in the
/// film are not decoded.
output::FilmReader opened(const std::filesystem::path& film, const scene::Limits& limits) {
  core::checkInterruption();
  const image::PixelSize size = output::FilmReader::declaredSize(film);
  core::checkInterruption();
  request::expectWithinMemory(compareFilmsMemory_bytes(size), filmsText(size), limits);
  const auto most_bytes = static_cast<double>(limits[scene::Limit::kMemory]);
  return output::FilmReader(film,
                            static_cast<std::int64_t>(std::min(1e18, largestFilmPicture_pixels(most_bytes))));
}

class FilmPair {
 public:
  FilmPair(const std::filesystem::path& reference, const std::filesystem::path& test, const scene::Limits& limits)
      : reference_(opened(reference, limits)),
        test_(opened(test, limits)),
        times_(reference_.timeStep_s()),
        timesOfTest_(test_.timeStep_s()) {
    if (sizeMismatch().empty()) request::expectWithinMemory(memory_bytes(1), filmsText(reference_.size()), limits);
  }

  core::Rational fps() const { return reference_.fps(); }
  const FilmTimes& times() const { return times_; }

  std::string sizeMismatch() const {
    const image::PixelSize a = reference_.size(), b = test_.size();
    return a == b ? "" : fmt::format("the size is {}x{}, not {}x{}", b.width, b.height, a.width, a.height);
  }

  /// Returns how many frames, at most `jobs`, can be compared at a time within the memory limit.
  int jobsWithin(const scene::Limits& limits, int jobs) const {
    const double one_bytes = memory_bytes(1), each_bytes = memory_bytes(2) - one_bytes;
    const double left_bytes = static_cast<double>(limits[scene::Limit::kMemory]) - one_bytes;
    return static_cast<int>(std::clamp(1 + left_bytes / each_bytes, 1.0, std::max(1.0, 1.0 * jobs)));
  }

  std::vector<FramePair> next(std::size_t most) {
    std::vector<FramePair> pairs;
    while (pairs.size() < most) {
      auto a = read(reference_, times_), b = read(test_, timesOfTest_);
      if (!a || !b) break;
      pairs.push_back({diffPicture(std::move(*a)), diffPicture(std::move(*b))});
    }
    return pairs;
  }

  /// Reads both films to their ends and returns why they do not match; empty if they do. Call after the last pair.
  std::string mismatch() {
    while (read(reference_, times_)) continue;
    while (read(test_, timesOfTest_)) continue;
    const std::string times = timesMismatch(times_, timesOfTest_);
    if (times_.frames() == timesOfTest_.frames()) return times;
    return fmt::format("the film has {} frames, not {}{}{}", timesOfTest_.frames(), times_.frames(),
                       times.empty() ? "" : "; ", times);
  }

 private:
  double memory_bytes(int jobs) const {
    const PixelKind kind{reference_.isTransparent() || test_.isTransparent(),
                         reference_.isDeep() || test_.isDeep()};
    return compareFilmsMemory_bytes(reference_.size(), kind, reference_.memory_bytes() + test_.memory_bytes(),
                                    jobs);
  }

  static std::optional<output::ShownPicture> read(output::FilmReader& film, FilmTimes& times) {
    core::checkInterruption();
    auto shown = film.next();
    if (shown) times.add(*shown);
    return shown;
  }

  output::FilmReader reference_, test_;
  FilmTimes times_, timesOfTest_;
};

/// Compares the default pictures of two animated PNGs, which viewers without animation show. A default picture
/// need not be one of the frames. Returns an empty string if there is no mismatch.
std::string defaultPictureMismatch(const std::filesystem::path& reference, const std::filesystem::path& test,
                                   const DiffRequest& request) {
  if (!image::isAnimatedPng(reference) || !image::isAnimatedPng(test)) return "";
  const auto picture = [](const auto& file) { return DiffPicture{image::readPngAsStored(file).picture}; };
  if (comparePictures(picture(reference), picture(test), request).diff.passes(false)) return "";
  return "the default picture, which viewers without animation show, is different";
}

}  // namespace

Verdict FilmDiff::verdict() const {
  Verdict worst = mismatch.empty() ? Verdict::kIdentical : Verdict::kDifferent;
  for (const PictureDiff& frame : frames) worst = std::max(worst, frame.verdict);
  return worst;
}

std::size_t FilmDiff::worst() const {
  POINSOT_EXPECT(!frames.empty());
  return static_cast<std::size_t>(std::ranges::max_element(frames, {}, badness) - frames.begin());
}

std::size_t FilmDiff::first() const {
  const Verdict verdict = frames[worst()].verdict;
  return static_cast<std::size_t>(std::ranges::find(frames, verdict, &PictureDiff::verdict) - frames.begin());
}

FilmDiff diffFilms(const std::filesystem::path& reference, const std::filesystem::path& test,
                   const DiffRequest& request, int jobs) {
  FilmPair films(reference, test, request.limits);
  FilmDiff diff{films.sizeMismatch(), films.fps(), films.times(), {}};
  if (!diff.mismatch.empty()) return diff;
  const int together = films.jobsWithin(request.limits, jobs);
  for (auto pairs = films.next(static_cast<std::size_t>(together)); !pairs.empty();
       pairs = films.next(static_cast<std::size_t>(together))) {
    const std::size_t first = diff.frames.size();
    diff.frames.resize(first + pairs.size());
    core::forEachIndex(pairs.size(), together, [&](std::size_t i) {
      auto& [a, b] = pairs[i];
      diff.frames[first + i] = comparePictures(std::move(a), std::move(b), request).diff;
      diff.frames[first + i].ignored = {};  // not stored per frame: all frames ignore the same pixels
      diff.frames[first + i].name = fmt::format("{}", first + i);
    });
  }
  diff.mismatch = films.mismatch();
  if (diff.mismatch.empty()) diff.mismatch = defaultPictureMismatch(reference, test, request);
  diff.times = films.times();
  return diff;
}

PictureDiff summaryOf(const FilmDiff& diff) {
  PictureDiff summary;
  if (!diff.frames.empty()) {
    const std::size_t worst = diff.worst(), first = diff.first();
    summary = diff.frames[worst];
    const auto differing = std::ranges::count(diff.frames, summary.verdict, &PictureDiff::verdict);
    summary.film =
        FilmSummary{diff.frames.size(), static_cast<std::size_t>(differing), worst, first, diff.time_s(worst),
                    diff.time_s(first)};
  }
  summary.name.clear();
  summary.mismatch = diff.mismatch;
  summary.verdict = diff.verdict();
  return summary;
}

void forFrames(const std::filesystem::path& reference, const std::filesystem::path& test,
               const std::vector<std::size_t>& frames, const DiffRequest& request,
               const std::function<void(std::size_t, const ComparedPictures&)>& visit) {
  FilmPair films(reference, test, request.limits);
  std::size_t next = 0;
  for (const std::size_t frame : frames) {
    POINSOT_EXPECT(frame >= next);
    for (; next < frame; ++next) films.next(1);
    auto pairs = films.next(1);
    if (pairs.empty())
      throw core::ioError(fmt::format("{} or {} became shorter while they were read",
                                      core::printable(reference.native()), core::printable(test.native())));
    visit(next++, comparePictures(std::move(pairs[0].reference), std::move(pairs[0].test), request));
  }
}

}  // namespace poinsot::compare
