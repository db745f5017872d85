// SPDX-License-Identifier: Apache-2.0
#include "layering/layer_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "layering/source_scan.h"

namespace poinsot::layering {
namespace {

namespace fs = std::filesystem;

// Headers of a third party, and the files of src/ that may include them. Patterns match whole paths relative to
// src/.
struct Door {
  const char* header;
  const char* files;
};

constexpr Door kDoors[] = {
    {R"(openssl/.*)", R"(core/(sha256|base64)\.cpp)"},
    {R"(png\.h|pngconf\.h)", R"(image/png_file\.cpp)"},
    {R"(isa-l\.h|isa-l/.*)", R"(image/deflated_pixels\.cpp)"},
    {R"(lib(av|sw|post)\w+/.*)", R"(output/ffmpeg_library\.h)"},
    {R"(toml\+\+/.*|toml\.hpp)", R"(scene/[\w/]+\.cpp)"},
    {R"(ft2build\.h|freetype/.*|freetype2/.*|FT_\w+|hb[\w-]*\.h|harfbuzz/.*)", R"(text/\w+\.cpp)"},
    {R"(EGL/.*|GL/.*|KHR/.*)", R"(gl/.*)"},
    {R"(glad/.*)", R"(gl/.*|render/\w+\.cpp)"},
    {R"(cairo.*)", R"(figure/\w+\.cpp)"},
    {R"(httplib\.h)", R"(preview/listener\.h)"},
    {R"(seccomp\.h)", R"(process/call_filter\.cpp)"},
    {R"(linux/landlock\.h)", R"(process/landlock\.cpp)"},
    {R"(libimagequant\.h)", R"(output/imagequant_library\.h)"},
    // Packagers' tools see libraries that are linked, but not libraries that are opened, so that only one file
    // opens any.
    {R"(dlfcn\.h)", R"(core/shared_library\.cpp)"},
    {R"(CLI/.*)", R"(cli/.*)"},
    {R"(nlohmann/json_fwd\.hpp)", R"([\w/]+\.cpp|core/json\.h)"},
    {R"(nlohmann/json\.hpp)", R"([\w/]+\.cpp)"},
    // Vectors are doubles up to the draw list, and floats from there on.
    {R"(Eigen/.*|unsupported/Eigen/.*)",
     R"((physics|geometry|scene|stage|describe|reference|preview|cli)/.*|core/vector2\.h)"},
    {R"(glm/.*)", R"((gl|draw|figure|output|stage|render|request|job|cli)/.*)"},
};

std::string contentsOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

bool isSource(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".h" || extension == ".hpp" || extension == ".cpp" || extension == ".c" ||
         extension == ".in";
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const Layer& layer : layers()) result.push_back(layer.name);
  return result;
}

const Layer* findLayer(const std::string& name) {
  const auto found = std::ranges::find(layers(), name, &Layer::name);
  return found == layers().end() ? nullptr : &*found;
}

bool mayUse(const Layer& layer, const std::string& other) {
  return other == layer.name || std::ranges::find(layer.mayUse, other) != layer.mayUse.end();
}

class FileCheck {
 public:
  FileCheck(const fs::path& src, const fs::path& path, Findings& findings)
      : file_(path.lexically_relative(src).generic_string()), text_(contentsOf(path)), findings_(findings) {
    layer_ = findLayer(file_.substr(0, file_.find('/')));
    ++findings_.filesRead;
  }

  void checkIncludes() {
    if (layer_ == nullptr)
      return report(1, "a folder of src/ that is no layer; add it to docs/architecture.md and here");
    for (const Mention& include : includesOf(text_)) {
      ++findings_.includesRead;
      checkRank(include);
      checkDoors(include);
    }
  }

  void checkLinks() {
    if (layer_ == nullptr) return;
    for (const Mention& link : layersLinkedIn(text_, names()))
      if (!mayUse(*layer_, link.name))
        report(link.line, fmt::format("{} must not link poinsot::{}", layer_->name, link.name));
  }

 private:
  void checkRank(const Mention& include) {
    const std::string folder = include.name.substr(0, include.name.find('/'));
    const bool ofAnyLayer = include.name.find('/') != include.name.npos && findLayer(folder) != nullptr;
    if (ofAnyLayer && !mayUse(*layer_, folder))
      report(include.line, fmt::format("{} must not include {}", layer_->name, include.name));
    // A bare "file.h" would hide its folder from this check. An .inc is text that the build makes for its one
    // reader.
    if (include.quoted && !ofAnyLayer && !include.name.ends_with(".inc"))
      report(include.line, fmt::format("\"{}\" is in no layer; write \"layer/file.h\"", include.name));
  }

  void checkDoors(const Mention& include) {
    for (const Door& door : kDoors)
      if (std::regex_match(include.name, std::regex(door.header)) &&
          !std::regex_match(file_, std::regex(door.files)))
        report(include.line, fmt::format("{} may be included only in {}", include.name, door.files));
  }

  void report(int line, const std::string& what) {
    findings_.violations.push_back(fmt::format("{}:{}: {}", file_, line, what));
  }

  std::string file_;
  std::string text_;
  const Layer* layer_ = nullptr;
  Findings& findings_;
};

}  // namespace

const std::vector<Layer>& layers() {
  static const std::vector<Layer> kLayers = {
      {"core", {}},
      {"physics", {"core"}},
      {"geometry", {"core"}},
      {"image", {"core"}},
      {"gl", {"core"}},
      {"text", {"core"}},
      {"draw", {"core"}},
      {"process", {"core"}},
      {"scene", {"geometry", "physics", "core"}},
      {"stage", {"scene", "draw", "text", "geometry", "physics", "core"}},
      {"render", {"draw", "text", "gl", "image", "core"}},
      {"figure", {"draw", "text", "image", "core"}},
      {"output", {"figure", "image", "core"}},
      {"request", {"output", "figure", "stage", "scene", "text", "image", "core"}},
      {"compare", {"request", "output", "figure", "stage", "scene", "image", "core"}},
      {"describe", {"request", "stage", "scene", "draw", "text", "physics", "core"}},
      {"job",
       {"describe", "request", "output", "figure", "render", "stage", "scene", "process", "draw", "gl", "image",
        "core"}},
      {"suite", {"job", "compare", "request", "output", "scene", "gl", "image", "core"}},
      {"reference", {"output", "scene", "process", "physics", "core"}},
      {"cluster", {"request", "image", "core"}},
      {"preview", {"job", "describe", "request", "stage", "scene", "gl", "image", "core"}},
      {"cli",
       {"preview", "cluster", "reference", "suite", "job", "describe", "compare", "request", "output", "figure",
        "render", "stage", "scene", "process", "draw", "text", "gl", "image", "core"}},
  };
  return kLayers;
}

Findings checkSources(const fs::path& src) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src))
    if (entry.is_regular_file() && entry.path().parent_path() != src) paths.push_back(entry.path());
  std::ranges::sort(paths);  // a directory has no order of its own

  Findings findings;
  for (const fs::path& path : paths) {
    if (isSource(path)) FileCheck(src, path, findings).checkIncludes();
    if (path.filename() == "CMakeLists.txt") FileCheck(src, path, findings).checkLinks();
  }
  return findings;
}

}  // namespace poinsot::layering
