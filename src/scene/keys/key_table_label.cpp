// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/label_text.h"
#include "scene/keys/put.h"

namespace poinsot::scene {

std::vector<Key> labelKeys() {
  std::vector<Key> keys;
  for (std::size_t i = 0; i < kLabelCount; ++i) {
    const LabelDefault& label = labelDefaults()[i];
    keys.push_back({.path = "label." + std::string(label.key),
                    .type = ValueType::kText,
                    .range = {.least = 0, .most = 80},
                    .fallback = label.fallback,
                    .example = label.example,
                    .help = label.help,
                    .isTex = true,
                    .put = into([i](Draft& d) { return &d.scene.labels[static_cast<LabelName>(i)]; })});
  }
  return keys;
}

}  // namespace poinsot::scene
