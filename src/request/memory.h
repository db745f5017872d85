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

/// Estimates the peak memory of a worker process in bytes, without meshes. The numbers were measured; see
/// memory.cpp.
/// @param film  format of the film; nullopt if the worker writes pictures
/// @param bits  bits per sample, 8 or 16
double workerMemory_bytes(image::PixelSize size, const std::optional<output::FilmFormat>& film, int bits = 8);

/// Estimates the peak memory of a worker in bytes, without meshes, for an output target.
double workerMemory_bytes(const OutputTarget& target, const scene::Output& asked, const PictureOptions& form);

/// Returns the memory that the meshes of a scene add to a worker, in bytes.
double meshMemory_bytes(const scene::Scene& scene);

/// Estimates the peak memory of a worker in bytes, including the meshes of the scene (of all cells in a sweep).
double workerMemory_bytes(const OutputTarget& target, const RequestedScene& requested, const PictureOptions& form);

/// Returns "a worker that makes pictures of 640x360", the subject of a message about memory.
std::string pictureText(image::PixelSize size);

std::string memoryText(double bytes);

/// Checks an estimate against Limit::kMemory.
/// @param what  subject of the message: "a worker that makes pictures of 640x360"
/// @throws core::Error(kLimit) with the estimate, if the estimate exceeds the limit.
void expectWithinMemory(double bytes, const std::string& what, const scene::Limits& limits);

/// Memory that is still available.
struct FreeMemory {
  double machine_bytes = 0;  ///< for all processes: free in the machine or, if less, in the control group
  double process_bytes = 0;  ///< for one process (ulimit -v)
};

/// Reads the available memory from the kernel. A value is infinite if the kernel reports none.
/// @param root  root of the file system; tests pass another folder
FreeMemory freeMemory(const std::filesystem::path& root = "/");

/// Returns how many workers of `each_bytes` fit into the available memory, at most `wanted`.
int workersThatFit(int wanted, double each_bytes, const FreeMemory& free);

}  // namespace poinsot::request
