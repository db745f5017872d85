// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

namespace poinsot::render {

/// Cache of values that are expensive to compute, such as coverage maps. A value is kept as long as every picture
/// uses it, because most things are the same in every frame of a film.
template <typename Key, typename Value>
class PictureCache {
 public:
  /// Starts a picture and drops the values that the previous picture did not use.
  void beginPicture() {
    std::swap(last_, current_);
    current_.clear();
  }

  /// Returns the value for `key`. If neither this picture nor the previous one has used the key, computes the
  /// value with `make()`. The reference is valid until the next beginPicture().
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
