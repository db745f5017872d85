// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "job/assembly.h"

/// Messages about an incomplete output, with the reason and the command to run next.
namespace poinsot::job {

/// Work that is left to do for an output that is made in parts.
struct WorkLeft {
  std::vector<int> shards;  ///< numbers of the shards with missing segments, from 1
  bool joining = false;     ///< the film is not yet joined, or the work folder of the sequence still exists

  bool none() const { return shards.empty() && !joining; }
};

/// Returns the work that is left, for a given number of shards. A finished film needs no segments.
WorkLeft workLeft(const JobRecord& job, const JobStatus& status, int shards, const request::OutputTarget& output);

/// Returns shard numbers in the format of Slurm's --array: "2,7-9".
std::string shardsText(const std::vector<int>& shards);

/// Returns whether the target is an undamaged film of poinsot. If the job is known, use isFinished() instead.
bool isReadyFilm(const request::OutputTarget& output);

/// Returns the reason why an output cannot be joined or reported on, and the command that makes the output.
/// Reasons are: the output is missing, finished, damaged or from another program, or the work folder lacks
/// job.json.
std::string nothingUnderWayText(const request::OutputTarget& output, const std::filesystem::path& workFolder);

/// Returns the command that makes the missing segments, as advice to the user.
std::string makeText(const JobRecord& job, const JobStatus& status, const request::OutputTarget& output);

}  // namespace poinsot::job
