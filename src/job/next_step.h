// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "job/assembly.h"

/// Words about an output that is not ready: why, and the command to run next.
namespace poinsot::job {

/// Returns why there is nothing to tell or to join of an output: nothing is there, a file of somebody else, a film
/// that was damaged, or a work folder without its job.json. With the command that makes the output.
std::string nothingUnderWayText(const request::OutputTarget& output, const std::filesystem::path& workFolder);

/// Returns the command that makes the segments that are missing.
std::string makeText(const JobRecord& job, const JobStatus& status, const request::OutputTarget& output);

}  // namespace poinsot::job
