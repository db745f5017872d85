// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

namespace poinsot::render {

/// Cache of values that are costly to make. A value stays as long as every picture uses it, because a film shows
/// much the same things in every frame.
template <typename Key, typename Value>
class PictureCache {
 public:
  /// Starts a picture and drops the values that the previous picture did not use.
  void beginPicture() {
    std::swap(last_, current_);
    current_.clear();
  }

  /// Returns the value for `key`, or the result of `make()` if neither this nor the previous picture has used it.
  /// The reference is valid until beginPicture().
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
