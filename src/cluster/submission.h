// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "request/frame_plan.h"
#include "request/output_target.h"

/// Scripts that distribute a render over many machines. This library only returns the text of the scripts.
namespace poinsot::cluster {

/// Division of a render into tasks, with the estimated time and memory.
struct Division {
  int shards = 1;           ///< number of tasks; each renders one shard
  int cpus = 1;             ///< CPUs of each task
  double frame_s = 0;       ///< CPU seconds per frame, from the user or guessed
  double task_s = 0;        ///< estimated wall-clock seconds of the longest task
  std::int64_t memory = 0;  ///< memory to request for each CPU of a task, in MiB
};

struct DivisionRequest {
  std::optional<int> shards = {};  ///< number of tasks; if unset, it follows from `task_s`
  int cpus = 1;
  double task_s = 600;  ///< wall-clock seconds per task: far above a worker's start (1 s), below queue limits
  std::optional<double> frame_s = {};  ///< CPU seconds per frame; if unset, guessed from the image size
};

/// Divides a render into shards, at most one per segment. If no number is requested, there are at most 1000
/// shards, because Slurm by default limits array indices to about 1000 (MaxArraySize).
/// @param worker_bytes  memory of one worker, see request/memory.h
Division divisionOf(const DivisionRequest& request, const request::FrameRange& frames,
                    const std::vector<request::FrameRange>& segments, image::PixelSize size, double worker_bytes);

/// Validated input for a script. Relative file names and command-line arguments are relative to `folder`.
struct Submission {
  std::vector<std::string> program;     ///< words that start poinsot in a task
  std::vector<std::string> setup = {};  ///< shell commands that a task runs first
  std::filesystem::path folder;         ///< absolute path of the folder in which the user ran `submit`
  request::OutputTarget output;
  std::vector<std::string> render;            ///< command that renders a shard, without --shard
  std::vector<std::string> assemble;          ///< empty for a series of films, which needs no joining
  std::vector<std::filesystem::path> inputs;  ///< the scene file and all files that it names
  std::int64_t frames = 1;
  std::string pieces;  ///< what the tasks share, such as "3 segments" or "200 films"
  Division division;
  int retries = 3;
};

/// Returns the folder for the tasks' logs and completion marks. Its name is the output's name with ".tasks"
/// appended.
std::filesystem::path tasksFolderOf(const Submission& submission);

/// Returns a bash script that submits two Slurm jobs: a job array that renders, and a job that then joins the
/// results.
/// @throws core::Error(kUsage) if Slurm cannot represent the output's name.
std::string slurmScript(const Submission& submission);

/// Returns a bash script that runs the tasks with GNU parallel, on this machine or on others by ssh.
std::string parallelScript(const Submission& submission);

/// Returns one command per line: one for each task, and then one that joins the results. The lines are independent
/// of the folder in which they run.
std::string linesScript(const Submission& submission);

/// Returns a makefile with one target for each shard. Its first target makes the output.
/// @throws core::Error(kUsage) if make cannot represent the name of a file.
std::string makeScript(const Submission& submission);

}  // namespace poinsot::cluster
