// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/program_run.h"

/// Renders that are over in about a second, to be broken in every way.
namespace poinsot::faults {

/// A scene of which the driver compiles little.
extern const char* const kTinyScene;

/// A render of "tiny.toml" at 10 frames a second: a film, or a sequence.
struct Output {
  std::string name;  ///< what -o is told
  double seconds = 1.8;
  std::string size = "64x36";
  int segmentFrames = 3;

  bool isFilm() const { return name.ends_with(".mp4"); }
};

inline const Output kFilm{"t.mp4"}, kSequence{"t_{frame:03}.png"};
/// Of two segments.
inline const Output kShortFilm{"t.mp4", 0.6}, kShortSequence{"t_{frame:03}.png", 0.6};
/// Of which more than half of the time goes into frames: 900 in 90 segments.
inline const Output kLongFilm{"t.mp4", 90, "160x90", 10}, kLongSequence{"t_{frame:03}.png", 90, "160x90", 10};

/// For the names of parametrised tests.
std::string kindOf(const testing::TestParamInfo<Output>& info);

/// Its arguments. One worker, unless `more` says otherwise.
std::vector<std::string> renderArguments(const Output& output, const std::vector<std::string>& more = {});

/// One call that goes wrong, as fault_injector.cpp has it.
struct Fault {
  std::string call, role, kind;
  bool onwards = false;      ///< all later ones too, as of a full disk
  std::string without = {};  ///< what the file system cannot do
};

/// For the names of parametrised tests.
std::string callOf(const testing::TestParamInfo<Fault>& info);

/// What the environment of a run is told of it; struck() says afterwards whether there was an n-th call.
std::vector<std::string> environmentOf(const Fault& fault, int n, const ScratchFolder& folder);
bool struck(const ScratchFolder& folder);

/// What of the output stands under final names: name and bytes, in order.
std::vector<std::pair<std::string, std::string>> filesOf(const std::filesystem::path& folder);

/// Each that stands under a final name is whole: a PNG with all its pixels, a film with all its frames.
void expectAllWhole(const std::filesystem::path& folder, const std::string& where);

/// What an uninterrupted run makes of it; made once.
const std::vector<std::pair<std::string, std::string>>& undisturbed(const Output& output);

/// How long a run is on this machine, with two workers.
double secondsOfARun(const Output& output);

}  // namespace poinsot::faults
