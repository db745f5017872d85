// SPDX-License-Identifier: Apache-2.0
#include "faults/tiny_film.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "image/png_file.h"
#include "output/film.h"

namespace poinsot::faults {
namespace {

constexpr const char* kMark = ".harness-mark";

}  // namespace

const char* const kTinyScene =
    "[body]\nprincipal_moments = [1, 2, 3]\n"
    "[motion]\nomega_body = [0.1, 2, 0.1]\n"
    "[time]\nduration = 1.8\nfps = 10\n"
    "[show]\nellipsoid = false\nplane = false\nherpolhode = false\npolhode = false\ncontact = false\nlabels = "
    "false\n"
    "L = false\nomega = false\nprincipal_axes = false\n";

std::string kindOf(const testing::TestParamInfo<Output>& info) {
  return info.param.isFilm() ? "Film" : "Sequence";
}

std::vector<std::string> renderArguments(const Output& output, const std::vector<std::string>& more) {
  std::vector<std::string> words{"render",    "tiny.toml",
                                 "-o",        output.name,
                                 "--segment", std::to_string(output.segmentFrames),
                                 "-D",        "time.duration=" + std::to_string(output.seconds)};
  const auto unless = [&](const char* option, const std::string& value) {
    if (std::ranges::find(more, option) == more.end()) words.insert(words.end(), {option, value});
  };
  unless("--size", output.size);
  unless("-j", "1");
  unless("--progress", "json");
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<std::string> environmentOf(const Fault& fault, int n, const ScratchFolder& folder) {
  return {"LD_PRELOAD=" POINSOT_FAULT_INJECTOR, "FAULT_CALL=" + fault.call,
          "FAULT_KIND=" + fault.kind,           "FAULT_AT=" + std::to_string(n) + (fault.onwards ? "+" : ""),
          "FAULT_ROLE=" + fault.role,           "FAULT_FOLDER=" + folder.path().string(),
          "FAULT_WITHOUT=" + fault.without,     "FAULT_MARK=" + (folder / kMark).string()};
}

std::string callOf(const testing::TestParamInfo<Fault>& info) { return info.param.call + "_" + info.param.role; }

bool struck(const ScratchFolder& folder) { return std::filesystem::remove(folder / kMark); }

std::vector<std::pair<std::string, std::string>> filesOf(const std::filesystem::path& folder) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string& name : namesIn(folder))
    if (name != "tiny.toml" && !name.starts_with('.')) files.emplace_back(name, bytesOf(folder / name));
  return files;
}

void expectAllWhole(const std::filesystem::path& folder, const std::string& where) {
  for (const auto& [name, bytes] : filesOf(folder)) {
    if (name.ends_with(".png"))
      EXPECT_TRUE(image::textsOfWholePng(folder / name)) << name << ' ' << where;
    else
      EXPECT_TRUE(output::isOwnFilm(folder / name)) << name << ' ' << where;
  }
}

const std::vector<std::pair<std::string, std::string>>& undisturbed(const Output& output) {
  static std::map<std::string, std::vector<std::pair<std::string, std::string>>> made;
  const auto [place, isNew] = made.try_emplace(output.name + std::to_string(output.seconds));
  if (isNew) {
    const ScratchFolder folder;
    folder.put("tiny.toml", kTinyScene);
    EXPECT_EQ(run(folder, renderArguments(output)).exitCode, 0);
    place->second = filesOf(folder.path());
    EXPECT_FALSE(place->second.empty());
  }
  return place->second;
}

double secondsOfARun(const Output& output) {
  undisturbed(output);  // the first run takes longer, because it compiles the shaders
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  const auto before = std::chrono::steady_clock::now();
  EXPECT_EQ(run(folder, renderArguments(output, {"-j", "2"})).exitCode, 0);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

}  // namespace poinsot::faults
