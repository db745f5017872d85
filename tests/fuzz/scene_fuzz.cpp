// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "fuzz/input.h"
#include "scene/scene_file.h"

// The input is a scene file, then overrides (-D), each after a NUL. The scene can refer to tests/scene/data.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> words = poinsot::fuzz::wordsOf({data, size}, '\0');
  const std::string text = std::move(words.front());
  words.erase(words.begin());
  try {
    poinsot::scene::parseScene(text, POINSOT_SOURCE_DIR "/tests/scene/data/fuzz.toml", words);
  } catch (const poinsot::scene::SceneErrors& errors) {
    poinsot::fuzz::expectPrintable(errors.what());
  }
  return 0;
}
