// SPDX-License-Identifier: Apache-2.0
#include "faults/mutated_scenes.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace poinsot::faults {
namespace {

namespace fs = std::filesystem;

class Mutation {
 public:
  Mutation(const std::vector<std::string>& scenes, std::uint32_t number) : scenes_(scenes), random_(number) {
    lines_ = linesOf(scenes_[number % scenes_.size()]);
  }

  std::string text() {
    for (std::size_t i = 0, changes = 1 + below(3); i < changes; ++i) change();
    std::string text;
    for (const std::string& line : lines_) text += line + "\n";
    if (below(16) == 0) turnBytes(text);
    if (below(16) == 0) text.resize(below(text.size() + 1));
    return text;
  }

 private:
  static std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  const std::string& oneOf(const std::vector<std::string>& words) { return words[below(words.size())]; }

  void change() {
    if (lines_.empty()) return;
    const std::size_t at = below(lines_.size());
    const auto place = lines_.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(6)) {
      case 0:
        lines_.erase(place);
        break;
      case 1:
        lines_.insert(place, lines_[below(lines_.size())]);
        break;
      case 2: {
        const auto others = linesOf(oneOf(scenes_));
        if (!others.empty()) lines_.insert(place, others[below(others.size())]);
        break;
      }
      case 3:
        std::swap(lines_[at], lines_[below(lines_.size())]);
        break;
      default:
        changeValue();
    }
  }

  /// Changes the value of a random line that has one: the whole value, or its first number.
  void changeValue() {
    std::vector<std::size_t> withValue;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (lines_[i].find('=') != std::string::npos && !lines_[i].starts_with('#')) withValue.push_back(i);
    if (withValue.empty()) return;
    std::string& line = lines_[withValue[below(withValue.size())]];
    const std::size_t value = line.find('=') + 1;
    const std::size_t digit = line.find_first_of("0123456789", value);
    if (digit == std::string::npos || below(3) == 0) {
      line = line.substr(0, value) + " " + oneOf(kValues);
      return;
    }
    std::size_t end = digit;
    while (end < line.size() && (std::isalnum(static_cast<unsigned char>(line[end])) || line[end] == '.')) ++end;
    line.replace(digit, end - digit, oneOf(kNumbers));
  }

  void turnBytes(std::string& text) {
    for (std::size_t i = 0, bytes = 1 + below(8); i < bytes && !text.empty(); ++i)
      text[below(text.size())] = static_cast<char>(random_());
  }

  static inline const std::vector<std::string> kNumbers{"0",
                                                        "1",
                                                        "-1",
                                                        "2",
                                                        "0.0",
                                                        "-0.0",
                                                        "1e-300",
                                                        "1e300",
                                                        "1e308",
                                                        "1e-12",
                                                        "1e12",
                                                        "1e6",
                                                        "nan",
                                                        "inf",
                                                        "-inf",
                                                        "255",
                                                        "65536",
                                                        "2147483648",
                                                        "9223372036854775807",
                                                        "0.1",
                                                        "1e-6",
                                                        "3.141592653589793",
                                                        "1000000",
                                                        "0x7f",
                                                        "1e400"};
  static inline const std::vector<std::string> kValues{"true",        "false",
                                                       "\"\"",        "\"x\"",
                                                       "[]",          "[1]",
                                                       "[1, 2, 3]",   "[[1, 2], [3, 4]]",
                                                       "{}",          "\"1 kg\"",
                                                       "\"1 rad/s\"", "\"90 deg\"",
                                                       "\"1e300 m\"", "\"-1 s\"",
                                                       "1979-05-27",  "'''a'''",
                                                       "[nan, 1, 2]", "[0, 0, 0]",
                                                       "{ a = 1 }",   "\"$\\\\omega$\"",
                                                       "\"body\"",    "[1e12, 1e12, 1e12]"};

  const std::vector<std::string>& scenes_;
  std::mt19937 random_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> galleryScenes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(POINSOT_SOURCE_DIR "/scenes"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> scenes;
  for (const fs::path& file : files) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    scenes.push_back(text.str());
  }
  return scenes;
}

std::string mutatedScene(const std::vector<std::string>& scenes, std::uint32_t number) {
  return Mutation(scenes, number).text();
}

}  // namespace poinsot::faults
