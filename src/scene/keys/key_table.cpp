// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "scene/keys/key_tables.h"

namespace poinsot::scene {
namespace {

std::vector<Key> fileKeys() {
  return {{.path = "schema",
           .type = ValueType::kInteger,
           .range = {.least = 1, .most = 1},
           .fallback = "1",
           .example = "1",
           .help = "Version of this format; only 1 exists.",
           .put = [](Draft&, std::size_t, const Checked&) {}}};
}

}  // namespace

std::vector<Key> joined(std::vector<std::vector<Key>> parts) {
  std::vector<Key> all;
  for (std::vector<Key>& part : parts) std::move(part.begin(), part.end(), std::back_inserter(all));
  return all;
}

const std::vector<Key>& keys() {
  static const std::vector<Key> table =
      joined({fileKeys(), bodyKeys(), motionKeys(), forcingKeys(), timeKeys(), framesKeys(), cameraKeys(),
              showKeys(), markKeys(), viewKeys(), labelKeys(), namedKeys(), plotKeys(), noteKeys(), timelineKeys(),
              styleKeys(), outputKeys()});
  return table;
}

}  // namespace poinsot::scene
