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

/// Scripts that distribute a render over many machines. This library prints them; it does not start anything.
namespace poinsot::cluster {

/// Division of a render into tasks, with its estimates.
struct Division {
  int shards = 1;           ///< number of tasks; each renders one shard
  int cpus = 1;             ///< CPUs of each task
  double frame_s = 0;       ///< CPU seconds per frame: given by the user or guessed
  double task_s = 0;        ///< estimated wall seconds of the longest task
  std::int64_t memory = 0;  ///< MiB to request per CPU of a task
};

struct DivisionRequest {
  std::optional<int> shards = {};  ///< default: as many as make tasks of `task_s`
  int cpus = 1;
  double task_s = 600;  ///< wall seconds per task: long beside a worker's start (1 s), short beside queue limits
  std::optional<double> frame_s = {};  ///< CPU seconds per frame; default: a guess from the image size
};

/// Divides a render into at most as many shards as there are segments. Without a requested number, there are at
/// most 1000 shards, because Slurm limits array indices to about 1000 by default (MaxArraySize).
/// @param worker_bytes  memory of one worker, see request/memory.h
Division divisionOf(const DivisionRequest& request, const request::FrameRange& frames,
                    const std::vector<request::FrameRange>& segments, image::PixelSize size, double worker_bytes);

/// Validated input of a script. Relative file names and command words are relative to `folder`.
struct Submission {
  /// Absolute paths of the poinsot program and of the folder in which the user runs `submit`.
  std::filesystem::path program, folder;
  request::OutputTarget output;
  std::vector<std::string> render;  ///< arguments that render a shard, without --shard
  std::vector<std::string> assemble;
  std::vector<std::filesystem::path> inputs;  ///< the scene and the files that it names
  std::int64_t frames = 1, segments = 1;
  Division division;
  int retries = 3;
};

/// Returns the folder for the tasks' logs and completion marks: the output's name with ".tasks" appended.
std::filesystem::path tasksFolderOf(const Submission& submission);

/// Returns a bash script that submits a job array and a job that joins the results after the array.
/// @throws core::Error(kUsage) if Slurm cannot represent the output's name.
std::string slurmScript(const Submission& submission);

/// Returns a bash script that runs the tasks with GNU parallel, on this machine or on others by ssh.
std::string parallelScript(const Submission& submission);

/// Returns a makefile with one target per shard; the first target makes the output.
/// @throws core::Error(kUsage) if make cannot represent the name of a file.
std::string makeScript(const Submission& submission);

}  // namespace poinsot::cluster
