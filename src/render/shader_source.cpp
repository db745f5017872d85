// SPDX-License-Identifier: Apache-2.0
#include "render/shader_source.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "core/error.h"

namespace poinsot::render {
namespace {

struct EmbeddedShader {
  const char* name;
  const unsigned char* begin;
  const unsigned char* end;
};
#include "embedded_shaders.inc"

[[noreturn]] void noShader(const std::string& file) { throw core::graphicsError("no shader named " + file); }

std::string embedded(const std::string& file) {
  for (const EmbeddedShader& shader : kEmbeddedShaders)
    if (file == shader.name) return {shader.begin, shader.end};
  noShader(file);
}

std::string fromDisk(const std::string& folder, const std::string& file) {
  std::ifstream stream(folder + "/" + file);
  if (!stream) noShader(folder + "/" + file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string load(const std::string& file) {
  const char* folder = std::getenv("POINSOT_SHADERS");
  return folder && *folder ? fromDisk(folder, file) : embedded(file);
}

}  // namespace

std::string shaderSource(const std::string& file, const std::string& defines) {
  const std::string directive = "#include \"";
  std::istringstream lines(load(file));
  std::string text = defines, line;
  while (std::getline(lines, line)) {
    if (line.starts_with(directive))
      text += shaderSource(line.substr(directive.size(), line.rfind('"') - directive.size()));
    else
      text += line;
    text += '\n';
  }
  return text;
}

}  // namespace poinsot::render
