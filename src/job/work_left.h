// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "job/assembly.h"

/// Messages about an output that is not ready: the reason, and the command to run next.
namespace poinsot::job {

/// Work that remains of an output made in parts.
struct WorkLeft {
  std::vector<int> shards;  ///< numbers, from 1, of the shards that have a segment to make
  bool joining = false;     ///< a film is not yet joined, or a sequence's work folder still exists

  bool none() const { return shards.empty() && !joining; }
};

/// Returns the work that remains if the segments are divided among `shards`. A finished film needs no segments.
WorkLeft workLeft(const JobRecord& job, const JobStatus& status, int shards, const request::OutputTarget& output);

/// Returns shard numbers in the format of Slurm's --array: "2,7-9".
std::string shardsText(const std::vector<int>& shards);

/// Returns whether the target is an undamaged film of this program. Use isFinished() if its job is known.
bool isReadyFilm(const request::OutputTarget& output);

/// Returns why an output has no render to report on or to join, and the command that makes the output. Reasons
/// are: the output is missing, finished, damaged or from another program, or the work folder lacks job.json.
std::string nothingUnderWayText(const request::OutputTarget& output, const std::filesystem::path& workFolder);

/// Returns advice with the command that makes the missing segments.
std::string makeText(const JobRecord& job, const JobStatus& status, const request::OutputTarget& output);

}  // namespace poinsot::job
