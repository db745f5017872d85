// SPDX-License-Identifier: Apache-2.0
#include "app/scene_request.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "app/file_handle.h"
#include "core/error.h"
#include "core/text.h"
#include "scene/scene_file.h"
#include "text/math_setter.h"

namespace poinsot::app {
namespace {

// The parser has the exact limit and the better message; this only bounds what is read into memory.
constexpr std::size_t kMostBytes = 8u << 20;

[[noreturn]] void fail(const std::string& fileName, const std::string& why) {
  throw core::Error(core::ErrorKind::kScene, why, core::SourceLocation{core::printable(fileName), 0, 0});
}

[[noreturn]] void failWithErrno(const std::string& fileName) {
  fail(fileName, fmt::format("cannot read the scene: {}", std::generic_category().message(errno)));
}

FileHandle openRegular(const std::string& fileName) {
  // Without O_NONBLOCK opening a FIFO would wait for its writer.
  FileHandle file(open(fileName.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat about {};
  if (!file || fstat(file.get(), &about) != 0) failWithErrno(fileName);
  if (!S_ISREG(about.st_mode)) fail(fileName, "a scene is a regular file, and this is none");
  return file;
}

std::string readText(const std::string& fileName) {
  const FileHandle file = openRegular(fileName);
  std::string text;
  std::array<char, 1 << 16> chunk;
  while (text.size() < kMostBytes) {
    const ssize_t got = read(file.get(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) failWithErrno(fileName);
    if (got == 0) return text;
    text.append(chunk.data(), static_cast<std::size_t>(got));
  }
  fail(fileName, "too long for a scene");
}

std::string texProblem(std::string_view tex) {
  try {
    text::setTex(tex);
    return "";
  } catch (const core::Error& error) {
    return error.message();
  }
}

}  // namespace

SceneRequest readSceneRequest(const std::string& fileName, std::vector<std::string> overrides) {
  return {fileName, readText(fileName), std::move(overrides), std::nullopt};
}

scene::Scene loadRequested(const SceneRequest& request) {
  scene::Scene scene = scene::parseScene(request.text, request.fileName, request.overrides, texProblem);
  if (request.size) {
    scene.output.width = request.size->width;
    scene.output.height = request.size->height;
  }
  return scene;
}

}  // namespace poinsot::app
