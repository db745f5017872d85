// SPDX-License-Identifier: Apache-2.0
#include "job/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/json.h"

namespace poinsot::job {
namespace {

/// Returns the time between two updates: short on a terminal, long in a log, medium for a program.
double interval_s(ProgressStyle style) {
  switch (style) {
    case ProgressStyle::kBar:
      return 0.1;
    case ProgressStyle::kPlain:
      return 5;
    case ProgressStyle::kJson:
      return 0.5;
    case ProgressStyle::kNone:
      break;
  }
  return HUGE_VAL;
}

int percent(const ProgressState& state) { return static_cast<int>(100 * state.done / state.total); }

std::string bar(const ProgressState& state, int cells) {
  const auto filled = static_cast<std::size_t>(cells * state.done / state.total);
  std::string text(filled, '=');
  if (state.done < state.total) text += '>';
  text.resize(static_cast<std::size_t>(cells), ' ');
  return "[" + text + "]";
}

}  // namespace

ProgressStyle progressStyle(std::string_view word, bool terminal) {
  if (word == "json") return ProgressStyle::kJson;
  if (word == "none") return ProgressStyle::kNone;
  return word == "auto" && terminal ? ProgressStyle::kBar : ProgressStyle::kPlain;
}

double ProgressState::left_s() const {
  if (done == total) return 0;
  return framesPerSecond > 0 ? static_cast<double>(total - done) / framesPerSecond : -1;
}

std::string clockText(double seconds) {
  if (seconds < 0) return "-:--";
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string barLine(const ProgressState& state, int columns) {
  const std::string figures =
      fmt::format(" {:3} %  {}/{} frames  {:.1f} frames/s  {} left", percent(state), state.done, state.total,
                  state.framesPerSecond, clockText(state.left_s()));
  // The bar has at most 40 cells, which show enough detail. It is omitted if there is no room for 10 cells.
  const int cells = std::min(40, columns - static_cast<int>(figures.size()) - 2);
  const std::string line = cells >= 10 ? bar(state, cells) + figures : figures.substr(1);
  return line.substr(0, static_cast<std::size_t>(std::max(columns, 0)));
}

std::string plainLine(const ProgressState& state) {
  return fmt::format("{} of {} frames ({} %), {:.1f} frames/s, {} left", state.done, state.total, percent(state),
                     state.framesPerSecond, clockText(state.left_s()));
}

std::string jsonLine(const ProgressState& state) {
  const std::string left = state.left_s() >= 0 ? fmt::format("{:.3f}", state.left_s()) : "null";
  return fmt::format(
      R"({{"event":"progress","done":{},"total":{},"elapsed_s":{:.3f},"frames_per_second":{:.3f},"left_s":{}}})",
      state.done, state.total, state.elapsed_s, state.framesPerSecond, left);
}

std::string jsonLine(const core::FileError& error) {
  return nlohmann::ordered_json{
      {"event", "failed"}, {"errno", error.code()}, {"file", core::utf8FromBytes(error.file().native())}}
      .dump();
}

Progress::Progress(ProgressStyle style, std::int64_t totalFrames, int columns, Writer write)
    : style_(style), total_(totalFrames), columns_(columns), write_(std::move(write)) {
  // A bar and JSON start with the first frame. In a log, a short render prints only its last line.
  if (style == ProgressStyle::kBar || style == ProgressStyle::kJson) shownAt_s_ = -interval_s(style);
}

double Progress::rate(std::int64_t made, bool last, double elapsed_s) const {
  // The last update reports the average rate of the whole run.
  if (last) return elapsed_s > 0 ? static_cast<double>(made) / elapsed_s : 0;
  const double since_s = elapsed_s - firstAt_s_;
  return since_s > 0 ? static_cast<double>(made - firstMade_) / since_s : 0;
}

void Progress::update(std::int64_t done, std::int64_t reused, double elapsed_s) {
  const std::int64_t made = done - reused;
  if (firstMade_ == 0) {
    // Measures the rate from here on, because the first frame includes several seconds of compiling shaders.
    firstMade_ = made;
    firstAt_s_ = elapsed_s;
  }
  const bool last = done == total_ && style_ != ProgressStyle::kNone && shown_ != done;
  if (!last && elapsed_s - shownAt_s_ < interval_s(style_)) return;
  shownAt_s_ = elapsed_s;
  shown_ = done;
  const ProgressState state{done, total_, elapsed_s, rate(made, done == total_, elapsed_s)};
  if (style_ == ProgressStyle::kJson) return write_(jsonLine(state) + "\n");
  if (style_ == ProgressStyle::kPlain) return write_("poinsot: " + plainLine(state) + "\n");
  // Writes the new line over the old one and then erases the rest of the old line. This order avoids flicker.
  write_("\r" + barLine(state, columns_ - 1) + "\x1b[K");
  lineOpen_ = true;
}

void Progress::end() {
  if (lineOpen_) write_("\n");
  lineOpen_ = false;
}

}  // namespace poinsot::job
