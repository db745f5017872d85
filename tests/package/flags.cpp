// SPDX-License-Identifier: Apache-2.0
#include "package/flags.h"

#include <gmock/gmock.h>

#include <regex>
#include <set>
#include <sstream>

#include "image/png_file.h"
#include "support/text_of.h"

namespace poinsot {
namespace {

/// Returns the features of the first CPU: "avx2", "fma".
std::set<std::string> cpuFeatures() {
  std::smatch found;
  const std::string text = textOf("/proc/cpuinfo");
  if (!std::regex_search(text, found, std::regex("\nflags\\s*: ([^\n]*)"))) return {};
  std::istringstream words(found[1]);
  return {std::istream_iterator<std::string>(words), {}};
}

const std::string kViewer = R"(
#include <glad/gl.h>  // its own
#include <cstdio>
#include "gl/offscreen_context.h"
#include "output/png_sequence.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"
static int calls = 0;
static void counted(GLbitfield) { ++calls; }
int main() {
  glad_glClear = counted;
  using namespace poinsot;
  const stage::Stage stage(scene::loadScene("top.toml"));
  const auto context = gl::openContext(gl::Backend::kAuto);
  render::Renderer renderer(*context);
  output::writePng("top.png", renderer.render(stage.compose({1, true}, {160, 90})));
  const int ours = calls;
  glClear(0);
  std::printf("%d calls by poinsot, %d by the program\n", ours, calls - ours);
}
)";

/// Returns the full names of the classes that a header defines, such as poinsot::physics::Flight, except
/// templates.
std::vector<std::string> classesOf(const std::string& header) {
  static const std::regex kSpace("^namespace (\\S+) \\{"),
      kClass("^(?:struct|class) (\\w+)(?: final)?(?: :[^;]*)? \\{");
  std::vector<std::string> classes;
  std::istringstream lines(header);
  std::string space;
  std::smatch found;
  for (std::string line, before; std::getline(lines, line); before = line) {
    if (std::regex_search(line, found, kSpace)) space = found[1];
    if (std::regex_search(line, found, kClass) && !before.starts_with("template"))
      classes.push_back(space + "::" + found[1].str());
  }
  return classes;
}

}  // namespace

bool Compilation::runsHere() const {
  static const std::set<std::string> has = cpuFeatures();
  static const std::vector<std::pair<std::string, std::vector<std::string>>> needs{
      {"-mavx512f", {"avx512f"}},
      {"-mavx2", {"avx2"}},
      {"-mfma", {"fma"}},
      {"-mavx", {"avx"}},
      {"x86-64-v3", {"avx2", "fma", "bmi2"}}};
  for (const auto& [flag, features] : needs)
    for (const std::string& feature : features)
      if ((flags + " ").find(flag + " ") != std::string::npos && !has.contains(feature)) return false;
  return true;
}

void Compilation::make(const InstalledTree& tree, const std::string& source, const std::string& modules,
                       const std::string& name) const {
  tree.run(text() + " -std=c++20 -o " + name + " " + source + " $(pkg-config --cflags --libs " + modules + ")");
}

std::string Compilation::refusal(const InstalledTree& tree, const std::string& source,
                                 const std::string& modules) const {
  return tree.run("! " + text() + " -std=c++20 -fsyntax-only -Wfatal-errors " + source +
                  " $(pkg-config --cflags " + modules + ") 2>&1");
}

std::string whyNoFlags() {
#ifndef __x86_64__
  return "the flags are those of x86-64";
#endif
  if (std::string(POINSOT_CXX_FLAGS).find("-fsanitize") != std::string::npos)
    return "what is built with a sanitizer links with that compiler and that sanitizer only";
  return "";
}

void expectKeepsItsGlad(const InstalledTree& tree, const Compilation& compilation, const std::string& version) {
  tree.folder().put("viewer.cpp", kViewer);
  tree.run("mkdir " + version + " && cd " + version +
           " && cp " POINSOT_SOURCE_DIR
           "/scenes/football.toml top.toml\n"
           "/usr/bin/glad --quiet --reproducible --api gl:core=" +
           version +
           " --extensions= --out-path . c\n"
           "cc -fPIC -Iinclude -c src/gl.c\n"
           "ar rc libown.a gl.o && cc -shared -o libshared.so gl.o\n" +
           compilation.text() + " -std=c++20 -Iinclude -c ../viewer.cpp $(pkg-config --cflags " + kPictures +
           ")\n"
           "$PREFIX/bin/poinsot still top.toml --time 1 --size 160x90 --quiet -o still.png");
  if (!compilation.runsHere()) return;
  for (const std::string library : {"own", "shared"}) {
    EXPECT_EQ(
        tree.run("cd " + version + " && " + compilation.compiler + " -o viewer viewer.o -L. -Wl,-rpath,$PWD -l" +
                 library + " $(pkg-config --libs " + kPictures + ") && ./viewer"),
        "0 calls by poinsot, 1 by the program\n")
        << version << ", " << library;
    EXPECT_EQ(image::readPng(tree.folder() / version / "top.png"),
              image::readPng(tree.folder() / version / "still.png"));
  }
}

void expectSameLayout(const InstalledTree& tree, const std::vector<Compilation>& compilations) {
  const std::filesystem::path root = tree.prefix() / "include" / "poinsot";
  std::string includes, shown;
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file()) continue;
    includes += "#include \"" + entry.path().lexically_relative(root).string() + "\"\n";
    for (const std::string& name : classesOf(textOf(entry.path()))) {
      shown += "show<" + name + ">(\"" + name + "\");\n";
      ++count;
    }
  }
  EXPECT_GT(count, 250) << "when it was written there were 290";
  tree.folder().put("sizes.cpp",
                    includes +
                        "#include <cstdio>\ntemplate <class T> void show(const char* name) {\n"
                        "std::printf(\"static_assert(sizeof(%s) == %zu && alignof(%s) == %zu);\\n\", name, "
                        "sizeof(T), name, alignof(T)); }\nint main() {\n" +
                        shown + "}\n");
  const std::string modules = "$(cd $PREFIX/lib/pkgconfig && ls | sed 's/[.]pc$//')";
  tree.run("g++ -std=c++20 -o sizes sizes.cpp $(pkg-config --cflags " + modules + ")");
  tree.folder().put("same.cpp", includes + tree.run("./sizes"));
  for (const Compilation& other : compilations)
    tree.run(other.text() + " -std=c++20 -fsyntax-only same.cpp $(pkg-config --cflags " + modules + ")");
}

}  // namespace poinsot
