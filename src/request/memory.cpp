// SPDX-License-Identifier: Apache-2.0
#include "request/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "core/error.h"
#include "request/output_target.h"

namespace poinsot::request {
namespace {

using std::filesystem::path;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Returns the text of a file; empty if the file cannot be read. Files of the kernel do not report their size.
std::string textOf(const path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::optional<double> numberAt(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<double> field(const std::string& text, const std::string& word) {
  const auto at = ("\n" + text).find("\n" + word);
  return at == std::string::npos ? std::nullopt : numberAt(std::string_view(text).substr(at + word.size()));
}

double ofMachine(const path& root) {
  const std::string text = textOf(root / "proc/meminfo");
  const auto available_kB = field(text, "MemAvailable:");
  return available_kB ? 1024 * (*available_kB + field(text, "SwapFree:").value_or(0)) : kInfinite;
}

/// Returns the free bytes of a control group. The file cache counts as free, because the kernel frees it on
/// demand.
double ofGroup(const path& group) {
  const auto most = numberAt(textOf(group / "memory.max"));  // nullopt if the file contains "max"
  if (!most) return kInfinite;
  const std::string text = textOf(group / "memory.stat");
  const double files = field(text, "file ").value_or(0) - field(text, "shmem ").value_or(0);
  return *most - numberAt(textOf(group / "memory.current")).value_or(0) + files;
}

/// Returns the free memory of this process according to its control group and all groups above it (cgroup version
/// 2). Containers and Slurm set such limits. The smallest value counts.
double ofGroups(const path& root) {
  const std::string text = "\n" + textOf(root / "proc/self/cgroup");
  const auto at = text.find("\n0::/");
  if (at == std::string::npos) return kInfinite;
  const std::string name = text.substr(at + 5, text.find('\n', at + 1) - at - 5);
  const path top = root / "sys/fs/cgroup";
  double least = ofGroup(top);
  path group = top;
  for (const path& part : path(name)) least = std::min(least, ofGroup(group /= part));
  return least;
}

double ofProcess() {
  rlimit limit{};
  const bool known = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return known ? static_cast<double>(limit.rlim_cur) : kInfinite;
}

/// Returns the memory that the encoder needs for each pixel of a frame, in bytes.
double encoderMemory_bytes(const output::FilmFormat& format) {
  constexpr std::array kOfCodec_bytes{48.0, 128.0, 12.0, 135.0, 130.0, 172.0, 172.0};  // in the order of FilmCodec
  double bytes = kOfCodec_bytes[static_cast<std::size_t>(format.codec)];
  if (format.chroma == output::Chroma::k444 || format.transparent) bytes *= 2;
  if (format.codec == output::FilmCodec::kH264 && format.effort == output::Effort::kSlow) bytes *= 1.6;
  return bytes;
}

}  // namespace

// The peak memory of a worker grows linearly with the number of pixels. The constant part is the memory of the
// libraries and of the driver's shaders. Each pixel of a picture needs:
// - 4 bytes of render target, or 8 at 16 bits (renderer.cpp);
// - up to 36 bytes of layers, or 60 at 16 bits, where solids fill the picture (solid_layers.h);
// - the bytes of the picture and of the frames that the encoder keeps.
// The values were measured from 640x360 to 8192x8192; see tests/faults/memory_nightly_test.cpp.
double workerMemory_bytes(image::PixelSize size, const std::optional<output::FilmFormat>& film, int bits) {
  const double start_bytes = film ? 148e6 : 115e6;  // only a film needs FFmpeg's libraries
  const double picture_bytes = bits == 8 ? 46 : 80;
  const double encoder_bytes = film ? encoderMemory_bytes(*film) : 0;
  return start_bytes + (picture_bytes + encoder_bytes) * size.width * size.height;
}

double workerMemory_bytes(const OutputTarget& target, const scene::Output& asked, const PictureOptions& form) {
  std::optional<output::FilmFormat> film;
  if (target.kind == OutputKind::kFilm) film = filmFormat(target, asked, form);
  return workerMemory_bytes({asked.width, asked.height}, film, form.bits);
}

// Each triangle needs memory for the scene's copy in doubles, the edges of the outline, and copies in floats in
// this program and in the driver. The value was measured; see tests/faults/memory_nightly_test.cpp.
double meshMemory_bytes(const scene::Scene& scene) {
  constexpr double kTriangle_bytes = 200;
  std::set<const geometry::Mesh*> meshes;
  for (const auto* parts : {&scene.body.parts, &scene.show.body.parts})
    for (const scene::Part& part : *parts)
      if (const auto* mesh = std::get_if<std::shared_ptr<const geometry::Mesh>>(&part.figure))
        meshes.insert(mesh->get());
  double bytes = 0;
  for (const geometry::Mesh* mesh : meshes) bytes += kTriangle_bytes * static_cast<double>(mesh->triangles.size());
  return bytes;
}

double workerMemory_bytes(const OutputTarget& target, const RequestedScene& requested,
                          const PictureOptions& form) {
  const double scenes = std::max(1.0, static_cast<double>(requested.cells.size()));
  return workerMemory_bytes(target, requested.scene.output, form) + scenes * meshMemory_bytes(requested.scene);
}

std::string pictureText(image::PixelSize size) {
  return fmt::format("a worker that makes pictures of {}x{}", size.width, size.height);
}

std::string memoryText(double bytes) { return fmt::format("{:.1f} GiB", bytes / (1 << 30)); }

void expectWithinMemory(double bytes, const std::string& what, const scene::Limits& limits) {
  constexpr auto kMemory = scene::Limit::kMemory;
  if (bytes <= static_cast<double>(limits[kMemory])) return;
  throw core::limitError(fmt::format("{}: about {} of memory, more than the allowed {}; {}", what,
                                     memoryText(bytes), limitText(kMemory, limits[kMemory]), howToRaise(kMemory)));
}

FreeMemory freeMemory(const path& root) { return {std::min(ofMachine(root), ofGroups(root)), ofProcess()}; }

int workersThatFit(int wanted, double each_bytes, const FreeMemory& free) {
  if (each_bytes > free.process_bytes) return 0;
  return static_cast<int>(std::clamp(free.machine_bytes / each_bytes, 0.0, static_cast<double>(wanted)));
}

}  // namespace poinsot::request
