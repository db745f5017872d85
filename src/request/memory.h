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

/// What a render takes of memory, known before it begins.
namespace poinsot::request {

/// Bytes that a worker process holds at its peak, of the picture's size, the bits of its samples and the film's
/// encoder; a picture has none. Measured; meshes come on top. See memory.cpp.
double workerMemory_bytes(image::PixelSize size, const std::optional<output::FilmFormat>& film, int bits = 8);

/// The same of an output as it is asked for.
double workerMemory_bytes(const OutputTarget& target, const scene::Output& asked, const PictureOptions& form);

/// What the meshes of a scene add to that.
double meshMemory_bytes(const scene::Scene& scene);

/// Both; of a sweep with the meshes of all its cells.
double workerMemory_bytes(const OutputTarget& target, const RequestedScene& requested, const PictureOptions& form);

/// "a worker that makes pictures of 640x360", for what follows.
std::string pictureText(image::PixelSize size);

/// "1.5 GiB".
std::string memoryText(double bytes);

/// @throws core::Error(kLimit) with the estimate, if it is above Limit::kMemory. @param what  takes so much:
/// "a worker that makes pictures of 640x360"
void expectWithinMemory(double bytes, const std::string& what, const scene::Limits& limits);

/// Bytes that may be had.
struct FreeMemory {
  double machine_bytes = 0;  ///< by all processes together: the machine's, or what this control group has left
  double process_bytes = 0;  ///< by one process (ulimit -v)
};

/// As the kernel says now; infinite where it says nothing. @param root  of the file system, for tests.
FreeMemory freeMemory(const std::filesystem::path& root = "/");

/// How many workers of `each_bytes` fit, `wanted` at most.
int workersThatFit(int wanted, double each_bytes, const FreeMemory& free);

}  // namespace poinsot::request
