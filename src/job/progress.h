// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/file_error.h"

namespace poinsot::job {

/// How a render tells of itself on stderr.
enum class ProgressStyle {
  kBar,    ///< one line, redrawn in place
  kPlain,  ///< a line every few seconds
  kJson,   ///< one JSON object a line
  kNone,
};

/// "auto", "plain", "json" or "none" to a style: auto is a bar on a terminal that can redraw, else plain.
ProgressStyle progressStyle(std::string_view word, bool terminal);

/// A moment of a render.
struct ProgressState {
  std::int64_t done = 0;   ///< frames
  std::int64_t total = 0;  ///< frames, > 0
  double elapsed_s = 0;    ///< wall time since the start

  double framesPerSecond = 0;  ///< after the first frame; of the whole run at the end; 0 while unknown

  /// Wall time to the end at this rate; negative while unknown.
  double left_s() const;
};

/// "0:07", "12:34", "1:02:03"; rounded up to whole seconds, "-:--" when negative.
std::string clockText(double seconds);

/// "[=======>      ]  50 %  150/300 frames  41.2 frames/s  0:04 left", at most `columns` wide.
std::string barLine(const ProgressState& state, int columns);

/// "150 of 300 frames (50 %), 41.2 frames/s, 0:04 left".
std::string plainLine(const ProgressState& state);

/// {"event":"progress","done":150,"total":300,"elapsed_s":3.641,"frames_per_second":41.2,"left_s":3.641};
/// left_s is null while unknown.
std::string jsonLine(const ProgressState& state);

/// {"event":"failed","errno":2,"file":"out/a.mp4"}: why a run that shows its progress as JSON ends. Each byte of
/// the file's name is a character.
std::string jsonLine(const core::FileError& error);

/// Decides when something is shown and how; the writer takes finished pieces of text.
class Progress {
 public:
  using Writer = std::function<void(std::string_view)>;

  Progress(ProgressStyle style, std::int64_t totalFrames, int columns, Writer write);

  /// Call after every frame, with the time since the start. `reused`: those of `done` that were there already,
  /// which says nothing about how long the others take.
  void update(std::int64_t done, std::int64_t reused, double elapsed_s);
  /// Ends the line, so that what follows on the terminal starts a new one. Called again it does nothing.
  void end();

 private:
  ProgressStyle style_;
  std::int64_t total_;
  int columns_;
  Writer write_;
  double rate(std::int64_t made, bool last, double elapsed_s) const;

  std::int64_t firstMade_ = 0;  // at the first update with one
  double firstAt_s_ = 0;
  double shownAt_s_ = 0;
  std::int64_t shown_ = -1;  // frames done at the last showing
  bool lineOpen_ = false;
};

}  // namespace poinsot::job
