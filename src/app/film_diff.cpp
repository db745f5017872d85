// SPDX-License-Identifier: Apache-2.0
#include "app/film_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "app/parallel.h"
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

/// Pictures of the worst frame: read again, since no film is kept in memory.
void writeWorst(const std::filesystem::path& reference, const std::filesystem::path& test, const FilmDiff& diff,
                const DiffRequest& request) {
  if (diff.frames.empty() || (!request.map && !request.difference)) return;
  FilmPair films(reference, test);
  for (std::size_t k = 0; k < diff.worst(); ++k) films.next(1);
  const FramePair pair = films.next(1).front();
  diffPictures(pair.reference, pair.test, request);
}

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
  const DiffRequest figuresOnly{request.rule, request.pixelsPerDegree};
  for (auto pairs = films.next(static_cast<std::size_t>(jobs)); !pairs.empty();
       pairs = films.next(static_cast<std::size_t>(jobs))) {
    const std::size_t first = diff.frames.size();
    diff.frames.resize(first + pairs.size());
    forEachIndex(pairs.size(), jobs, [&](std::size_t i) {
      diff.frames[first + i] = diffPictures(pairs[i].reference, pairs[i].test, figuresOnly);
      diff.frames[first + i].name = fmt::format("{}", first + i);
    });
  }
  diff.mismatch = films.lengthMismatch();
  writeWorst(reference, test, diff, request);
  return diff;
}

std::string curveCsv(const FilmDiff& diff) {
  std::string text = "frame,t,verdict,differing_pixels,max,mean,rmse,psnr_db,ssim_mean,flip_mean,flip_max\n";
  for (std::size_t k = 0; k < diff.frames.size(); ++k) {
    const PictureDiff& frame = diff.frames[k];
    const image::ImageDifference& d = frame.figures;
    const double t_s = diff.fps.num == 0 ? 0 : static_cast<double>(k) / diff.fps.value();
    text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{},{},{:.6g},{:.6g}\n", k, t_s,
                        image::toString(frame.verdict), d.differingPixels, d.maxAbs, d.meanAbs, d.rmse,
                        d.psnr_dB ? fmt::format("{:.6g}", *d.psnr_dB) : "",
                        d.ssim ? fmt::format("{:.9g}", d.ssim->mean) : "", d.flip.mean, d.flip.max);
  }
  return text;
}

}  // namespace poinsot::app
