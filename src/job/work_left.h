// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "job/assembly.h"

/// Words about an output that is not ready: why, and the command to run next.
namespace poinsot::job {

/// Work that remains of an output made in parts.
struct WorkLeft {
  std::vector<int> shards;  ///< numbers, from 1, of the shards that have a segment to make
  bool joining = false;     ///< the film does not stand whole under its name, or a sequence's work folder is there

  bool none() const { return shards.empty() && !joining; }
};

/// Returns the work that remains if the segments are divided among `shards`. A finished film needs no segments.
WorkLeft workLeft(const JobRecord& job, const JobStatus& status, int shards, const request::OutputTarget& output);

/// Returns "2,7-9", as the --array of Slurm takes it.
std::string shardsText(const std::vector<int>& shards);

/// Returns whether a whole film of this program stands there. Use isFinished() if its job is known.
bool isReadyFilm(const request::OutputTarget& output);

/// Returns why there is nothing to tell or to join of an output: nothing is there, a file of somebody else, a film
/// that was damaged, or a work folder without its job.json. With the command that makes the output.
std::string nothingUnderWayText(const request::OutputTarget& output, const std::filesystem::path& workFolder);

/// Returns the command that makes the segments that are missing.
std::string makeText(const JobRecord& job, const JobStatus& status, const request::OutputTarget& output);

}  // namespace poinsot::job
