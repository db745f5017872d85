// SPDX-License-Identifier: Apache-2.0
#include "app/film_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "app/parallel.h"
#include "core/error.h"
#include "core/expect.h"
#include "core/text.h"
#include "output/film_format.h"
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

/// Frames of a GIF always have alpha: it is left out where it hides nothing.
void leaveOutIdleAlpha(DiffPicture& picture) {
  std::visit(
      [&](auto& p) {
        using Image = std::remove_reference_t<decltype(p)>;
        Image opaque(p.size, 3);
        for (std::size_t from = 0, to = 0; from < p.pixels.size(); from += 4, to += 3) {
          if (p.pixels[from + 3] != Image::kMost) return;
          std::copy_n(p.pixels.begin() + static_cast<std::ptrdiff_t>(from), 3,
                      opaque.pixels.begin() + static_cast<std::ptrdiff_t>(to));
        }
        p = std::move(opaque);
        picture.channels = 3;
      },
      picture.pixels);
}

FramePair framePair(image::AnyImage a, image::AnyImage b) {
  FramePair pair{diffPicture(std::move(a)), diffPicture(std::move(b))};
  if (pair.reference.channels == 4 && pair.test.channels == 3) leaveOutIdleAlpha(pair.reference);
  if (pair.reference.channels == 3 && pair.test.channels == 4) leaveOutIdleAlpha(pair.test);
  return pair;
}

/// Frames of a GIF are shown for whole hundredths of a second, so that its rate is not quite that of another
/// format.
bool sameRate(const core::Rational& a, const core::Rational& b, bool gif) {
  if (a.num == 0 || b.num == 0) return a == b;
  const double mostApart_s = gif ? 0.005 : 1e-4;
  return std::abs(1 / a.value() - 1 / b.value()) <= mostApart_s;
}

bool isGif(const std::filesystem::path& film) {
  return output::filmContainer(film) == output::FilmContainer::kGif;
}

/// Two films that are read side by side.
class FilmPair {
 public:
  FilmPair(const std::filesystem::path& reference, const std::filesystem::path& test)
      : reference_(reference), test_(test), gif_(isGif(reference) || isGif(test)) {}

  core::Rational fps() const { return reference_.fps(); }

  /// Why they do not go together, before their frames are counted.
  std::string mismatch() const {
    const image::PixelSize a = reference_.size(), b = test_.size();
    if (a != b) return fmt::format("the size is {}x{}, not {}x{}", b.width, b.height, a.width, a.height);
    if (!sameRate(reference_.fps(), test_.fps(), gif_))
      return fmt::format("the film has {:.6g} frames a second, not {:.6g}", test_.fps().value(),
                         reference_.fps().value());
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
      pairs.push_back(framePair(std::move(*a), std::move(*b)));
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
  bool gif_;  // one of them
  std::int64_t framesOfReference_ = 0, framesOfTest_ = 0;
};

}  // namespace

image::Verdict FilmDiff::verdict() const {
  image::Verdict worst = mismatch.empty() ? image::Verdict::kIdentical : image::Verdict::kDifferent;
  for (const PictureDiff& frame : frames) worst = std::max(worst, frame.verdict);
  return worst;
}

std::size_t FilmDiff::worst() const {
  return static_cast<std::size_t>(std::ranges::max_element(frames, {}, badness) - frames.begin());
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
    POINSOT_EXPECT(frame >= next);
    for (; next < frame; ++next) films.next(1);
    auto pairs = films.next(1);
    if (pairs.empty())
      throw core::Error(core::ErrorKind::kIo,
                        fmt::format("{} or {} became shorter while they were read",
                                    core::printable(reference.native()), core::printable(test.native())));
    visit(next++, comparePictures(std::move(pairs[0].reference), std::move(pairs[0].test), request));
  }
}

}  // namespace poinsot::app
