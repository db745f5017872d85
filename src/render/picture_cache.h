// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

namespace poinsot::render {

/// Values that are costly to make, kept while pictures in a row use them: a film shows much the same things in
/// every frame.
template <typename Key, typename Value>
class PictureCache {
 public:
  /// From here on, what the picture before did not use is forgotten.
  void beginPicture() {
    std::swap(last_, current_);
    current_.clear();
  }

  /// The value for `key`, from `make()` when neither this picture nor the one before has it. Stays at its address
  /// until beginPicture().
  template <typename Make>
  const Value& get(const Key& key, Make&& make) {
    if (const auto known = current_.find(key); known != current_.end()) return known->second;
    if (auto kept = last_.extract(key)) return current_.insert(std::move(kept)).position->second;
    return current_.emplace(key, make()).first->second;
  }

 private:
  std::map<Key, Value> last_, current_;
};

}  // namespace poinsot::render
