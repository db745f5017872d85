// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/file_error.h"

namespace poinsot::job {

/// Format of the progress reports of a render on stderr.
enum class ProgressStyle {
  kBar,    ///< one line that is redrawn
  kPlain,  ///< one line every few seconds
  kJson,   ///< one JSON object per line
  kNone,
};

/// Converts "auto", "plain", "json" or "none" to a style. "auto" selects the bar on a terminal, and plain lines
/// otherwise.
/// @param terminal  whether stderr is a terminal that can redraw a line
ProgressStyle progressStyle(std::string_view word, bool terminal);

struct ProgressState {
  std::int64_t done = 0;   ///< frames that are done
  std::int64_t total = 0;  ///< frames in total, > 0
  double elapsed_s = 0;    ///< wall time since the start of the render

  double framesPerSecond = 0;  ///< rate since the first frame, at the end of the whole render; 0 if unknown

  /// Returns the estimated wall time in s until the end of the render. Negative if unknown.
  double left_s() const;
};

/// Returns a time, rounded up to full seconds, as "0:07", "12:34" or "1:02:03". Returns "-:--" if negative.
std::string clockText(double seconds);

/// Returns "[=======>      ]  50 %  150/300 frames  41.2 frames/s  0:04 left", cut to `columns` characters.
std::string barLine(const ProgressState& state, int columns);

/// Returns "150 of 300 frames (50 %), 41.2 frames/s, 0:04 left".
std::string plainLine(const ProgressState& state);

/// Returns {"event":"progress","done":150,"total":300,"elapsed_s":3.641,"frames_per_second":41.2,"left_s":3.641}.
/// left_s is null if unknown.
std::string jsonLine(const ProgressState& state);

/// Returns {"event":"failed","errno":2,"file":"out/a.mp4"}, from which a program learns why a render failed. In
/// the file name, each byte becomes one character.
std::string jsonLine(const core::FileError& error);

/// Progress reports of a render. Decides when to report, and passes formatted text to a writer.
class Progress {
 public:
  using Writer = std::function<void(std::string_view)>;

  Progress(ProgressStyle style, std::int64_t totalFrames, int columns, Writer write);

  /// Reports progress if an update is due. Call after every frame.
  /// @param reused  number of the `done` frames that existed before the render; they do not count for the rate
  /// @param elapsed_s  wall time since the start of the render
  void update(std::int64_t done, std::int64_t reused, double elapsed_s);
  /// Ends the line of the bar, so that later output starts on a new line. Only the first call has an effect.
  void end();

 private:
  ProgressStyle style_;
  std::int64_t total_;
  int columns_;
  Writer write_;
  double rate(std::int64_t made, bool last, double elapsed_s) const;

  std::int64_t firstMade_ = 0;
  double firstAt_s_ = 0;
  double shownAt_s_ = 0;
  std::int64_t shown_ = -1;  // value of `done` in the last report
  bool lineOpen_ = false;
};

}  // namespace poinsot::job
