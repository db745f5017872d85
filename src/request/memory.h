// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image/image.h"
#include "output/film_format.h"
#include "request/output_target.h"
#include "request/picture_options.h"
#include "request/requested_scene.h"
#include "scene/limits.h"
#include "scene/scene.h"

namespace poinsot::request {

/// Estimates the peak memory of a worker process in bytes, without the meshes of its scene. The estimate is based
/// on measurements; see memory.cpp.
/// @param film  format of the film; nullopt if the worker writes pictures
/// @param bits  bits per sample, 8 or 16
double workerMemory_bytes(image::PixelSize size, const std::optional<output::FilmFormat>& film, int bits = 8);

/// Estimates the peak memory of a worker process in bytes for one output, without the meshes of its scene.
double workerMemory_bytes(const OutputTarget& target, const scene::Output& asked, const PictureOptions& form);

/// Returns the memory that the meshes of a scene need in each worker process, in bytes.
double meshMemory_bytes(const scene::Scene& scene);

/// Estimates the peak memory of a worker process in bytes for one output, with the meshes of its scene. For a
/// sweep, counts the meshes of all cells.
double workerMemory_bytes(const OutputTarget& target, const RequestedScene& requested, const PictureOptions& form);

/// Returns the subject of an error about memory, such as "a worker that makes pictures of 640x360".
std::string pictureText(image::PixelSize size);

std::string memoryText(double bytes);

/// Checks that an estimate is within Limit::kMemory.
/// @param what  subject of the error, such as "a worker that makes pictures of 640x360"
/// @throws core::Error(kLimit) with the estimate, if the estimate exceeds the limit.
void expectWithinMemory(double bytes, const std::string& what, const scene::Limits& limits);

/// Memory that is free for new processes.
struct FreeMemory {
  double machine_bytes = 0;  ///< free for all processes together, in the machine and the control group
  double process_bytes = 0;  ///< free for one process, by ulimit -v
};

/// Reads the free memory from the kernel. A value is infinite if the kernel does not report it.
/// @param root  root of the file system; a test can give another folder
FreeMemory freeMemory(const std::filesystem::path& root = "/");

/// Returns how many workers fit into the free memory, at most `wanted`.
/// @param each_bytes  memory of one worker
int workersThatFit(int wanted, double each_bytes, const FreeMemory& free);

}  // namespace poinsot::request
