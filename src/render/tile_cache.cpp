// SPDX-License-Identifier: Apache-2.0
#include "render/tile_cache.h"

#include <algorithm>
#include <utility>

namespace poinsot::render {
namespace {

int tileOf(float px) { return static_cast<int>(px) / kTile_px; }

}  // namespace

void TileCache::beginPicture(glm::ivec2 size_px, Constants common) {
  if (ended_ && size_px == size_px_ && common == common_) {
    last_ = std::exchange(current_, {});
  } else {
    size_px_ = size_px;
    tiles_ = (size_px + kTile_px - 1) / kTile_px;
    common_ = std::move(common);
    last_.clear();
    current_.clear();
    shown_.assign(static_cast<std::size_t>(tiles_.x) * static_cast<std::size_t>(tiles_.y), 0);
    names_ = 0;
  }
  ended_ = false;
}

// Returns a number that identifies a look: sheets and their constants. If the previous picture had the same look,
// its number is kept. A new look gets a new number, which no tile has yet.
int TileCache::nameOf(const SheetChoice& chosen, const Sheets& sheets) {
  const auto isChosen = [&](const Look& look) { return look.chosen == chosen; };
  if (const auto known = std::ranges::find_if(current_, isChosen); known != current_.end()) return known->name;
  Look look{chosen, sheets.constants(chosen), 0};
  const auto before = std::ranges::find_if(last_, isChosen);
  look.name = before != last_.end() && before->constants == look.constants ? before->name : ++names_;
  current_.push_back(std::move(look));
  return current_.back().name;
}

int& TileCache::shownAt(const PixelBounds& tile) { return shownAt(tileOf(tile.left), tileOf(tile.top)); }

int& TileCache::shownAt(int column, int row) {
  return shown_[static_cast<std::size_t>(row) * static_cast<std::size_t>(tiles_.x) +
                static_cast<std::size_t>(column)];
}

bool TileCache::shows(const PixelBounds& tile, const SheetChoice& chosen, const Sheets& sheets) {
  const int name = nameOf(chosen, sheets);
  return std::exchange(shownAt(tile), name) == name;
}

void TileCache::forget(const PixelBounds& place) {
  const PixelBounds p = place.clipped(size_px_);
  if (p.empty()) return;
  const auto beginsBefore = [](int tile, float end) { return static_cast<float>(tile * kTile_px) < end; };
  for (int row = tileOf(p.top); beginsBefore(row, p.bottom); ++row)
    for (int column = tileOf(p.left); beginsBefore(column, p.right); ++column) shownAt(column, row) = 0;
}

}  // namespace poinsot::render
