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

/// A render handed to many machines: what a script of it says. Nothing is started here.
namespace poinsot::cluster {

/// How the work is divided.
struct Division {
  int shards = 1;           ///< tasks, each one shard
  int cpus = 1;             ///< of a task
  double frame_s = 0;       ///< CPU time of a frame, as guessed or told
  double task_s = 0;        ///< wall time of the longest task by that
  std::int64_t memory = 0;  ///< MiB of a task for each of its CPUs
};

/// What a user may ask of it.
struct DivisionRequest {
  std::optional<int> shards = {};  ///< else as many as make tasks of `task_s`
  int cpus = 1;                    ///< of a task
  double task_s = 600;  ///< long against the second in which a worker starts, short against a queue's limits
  std::optional<double> frame_s = {};  ///< else of the picture's size
};

/// Never more shards than segments, and of itself at most 1000: Slurm numbers the tasks of an array up to 1000
/// unless its administrators say otherwise (MaxArraySize).
/// @param worker_bytes  as request/memory.h has it.
Division divisionOf(const DivisionRequest& request, const request::FrameRange& frames,
                    const std::vector<request::FrameRange>& segments, image::PixelSize size, double worker_bytes);

/// One submission, everything checked. Names and words are as typed, to be read in `folder`.
struct Submission {
  std::filesystem::path program, folder;      ///< absolute
  request::OutputTarget output;               ///< as typed
  std::vector<std::string> render;            ///< of a shard: all words but --shard
  std::vector<std::string> assemble;          ///< words that join the shards
  std::vector<std::filesystem::path> inputs;  ///< the scene and the files that it names
  std::int64_t frames = 1, segments = 1;
  Division division;
  int retries = 3;  ///< how often a task that fails is tried again
};

/// Beside the output: what the tasks say, and which of them are done.
std::filesystem::path tasksFolderOf(const Submission& submission);

/// A bash script that submits a job array and, depending on it, a job that joins.
/// @throws core::Error(kUsage) where the output has a name that Slurm cannot hold.
std::string slurmScript(const Submission& submission);

/// A bash script around GNU parallel, on this machine or by ssh on others.
std::string parallelScript(const Submission& submission);

/// A makefile with a target per shard and the film as the first one.
/// @throws core::Error(kUsage) where a file has a name that make cannot hold.
std::string makeScript(const Submission& submission);

}  // namespace poinsot::cluster
