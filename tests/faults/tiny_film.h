// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/program_run.h"

/// Renders that take about a second, as targets of every kind of fault.
namespace poinsot::faults {

/// Scene for which the driver compiles little.
extern const char* const kTinyScene;

/// Render of "tiny.toml" at 10 frames a second: a film or a sequence.
struct Output {
  std::string name;  ///< argument of -o
  double seconds = 1.8;
  std::string size = "64x36";
  int segmentFrames = 3;

  bool isFilm() const { return name.ends_with(".mp4"); }
};

inline const Output kFilm{"t.mp4"}, kSequence{"t_{frame:03}.png"};
/// Outputs of two segments.
inline const Output kShortFilm{"t.mp4", 0.6}, kShortSequence{"t_{frame:03}.png", 0.6};
/// Outputs with 900 frames in 90 segments, for which frames take more than half of the time.
inline const Output kLongFilm{"t.mp4", 90, "160x90", 10}, kLongSequence{"t_{frame:03}.png", 90, "160x90", 10};

std::string kindOf(const testing::TestParamInfo<Output>& info);

/// Returns the arguments of a render, with one worker unless `more` sets another number.
std::vector<std::string> renderArguments(const Output& output, const std::vector<std::string>& more = {});

/// A call that fails or is changed; fault_injector.cpp describes the values.
struct Fault {
  std::string call, role, kind;
  bool onwards = false;      ///< includes all later calls, as on a full disk
  std::string without = {};  ///< abilities that the file system lacks
};

std::string callOf(const testing::TestParamInfo<Fault>& info);

/// Returns the environment of a run with the fault at the n-th call. After the run, struck() returns whether there
/// was such a call.
std::vector<std::string> environmentOf(const Fault& fault, int n, const ScratchFolder& folder);
bool struck(const ScratchFolder& folder);

/// Returns the output files with final names: name and bytes, in order.
std::vector<std::pair<std::string, std::string>> filesOf(const std::filesystem::path& folder);

/// Expects every file with a final name to be complete: a PNG with all its pixels, a film with all its frames.
void expectAllWhole(const std::filesystem::path& folder, const std::string& where);

/// Returns the files of an uninterrupted render; made once.
const std::vector<std::pair<std::string, std::string>>& undisturbed(const Output& output);

double secondsOfARun(const Output& output);

}  // namespace poinsot::faults
