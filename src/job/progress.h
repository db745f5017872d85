// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/file_error.h"

namespace poinsot::job {

/// Format in which a render reports its progress on stderr.
enum class ProgressStyle {
  kBar,    ///< one line, redrawn in place
  kPlain,  ///< a line every few seconds
  kJson,   ///< one JSON object a line
  kNone,
};

/// Converts "auto", "plain", "json" or "none" to a style. "auto" gives a bar on a terminal, else plain lines.
/// @param terminal  whether stderr is a terminal that can redraw a line
ProgressStyle progressStyle(std::string_view word, bool terminal);

struct ProgressState {
  std::int64_t done = 0;   ///< frames
  std::int64_t total = 0;  ///< frames, > 0
  double elapsed_s = 0;    ///< wall time since the start

  double framesPerSecond = 0;  ///< rate since the first frame; at the end, rate of the whole run; 0 if unknown

  /// Returns the estimated wall time to the end at this rate; negative if unknown.
  double left_s() const;
};

/// Returns a time as "0:07", "12:34" or "1:02:03", rounded up to whole seconds; "-:--" if negative.
std::string clockText(double seconds);

/// Returns "[=======>      ]  50 %  150/300 frames  41.2 frames/s  0:04 left", cut to `columns` characters.
std::string barLine(const ProgressState& state, int columns);

/// Returns "150 of 300 frames (50 %), 41.2 frames/s, 0:04 left".
std::string plainLine(const ProgressState& state);

/// Returns {"event":"progress","done":150,"total":300,"elapsed_s":3.641,"frames_per_second":41.2,"left_s":3.641};
/// left_s is null if unknown.
std::string jsonLine(const ProgressState& state);

/// Returns {"event":"failed","errno":2,"file":"out/a.mp4"}, which tells programs why a render failed. Each byte of
/// the file name becomes one character.
std::string jsonLine(const core::FileError& error);

/// Decides when to show progress, formats the progress and passes the text to a writer.
class Progress {
 public:
  using Writer = std::function<void(std::string_view)>;

  Progress(ProgressStyle style, std::int64_t totalFrames, int columns, Writer write);

  /// Call after every frame.
  /// @param reused  how many of the `done` frames existed already; they do not count towards the rate
  /// @param elapsed_s  wall time since the start
  void update(std::int64_t done, std::int64_t reused, double elapsed_s);
  /// Ends the bar's line, so that later output starts on a new line. Further calls do nothing.
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
  std::int64_t shown_ = -1;  // frames done when progress was last shown
  bool lineOpen_ = false;
};

}  // namespace poinsot::job
