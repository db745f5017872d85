// SPDX-License-Identifier: Apache-2.0
#include "figure/visibility_pieces.h"

#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

namespace poinsot::figure {
namespace {

// Number of points in a chunk of a line, with about one point per pixel. If two chunks overlap, they are so short
// that one lies over the other along their whole length.
constexpr std::size_t kChunkPoints = 32;

/// Points `first` to `last` of a piece, including both. Neighbouring chunks have one point in common.
struct Chunk {
  std::size_t piece = 0;
  std::size_t first = 0;
  std::size_t last = 0;
};

Piece unrolled(Piece piece) {
  if (piece.closed) piece.points.push_back(piece.points.front());
  return piece;
}

std::vector<Chunk> chunksOf(const std::vector<Piece>& pieces) {
  std::vector<Chunk> chunks;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t first = 0; first + 1 < pieces[i].points.size(); first += kChunkPoints)
      chunks.push_back({i, first, std::min(first + kChunkPoints, pieces[i].points.size() - 1)});
  return chunks;
}

/// Finds the pairs of chunks that overlap, by comparing points that are near each other.
class Overlaps {
 public:
  Overlaps(const std::vector<Piece>& pieces, const std::vector<Chunk>& chunks)
      : pieces_(pieces), chunks_(chunks), cell_px_(widest() + kSoft_px) {
    for (std::size_t c = 0; c < chunks.size(); ++c)
      for (std::size_t i = chunks[c].first; i <= chunks[c].last; ++i) compareAndKeep(c, point(c, i));
  }

  /// Returns the pairs of overlapping chunks, the lower chunk first.
  std::vector<std::pair<std::size_t, std::size_t>> pairs() const {
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (const auto& [pair, nearness] : nearness_) {
      if (nearness > 0) all.push_back(pair);
      if (nearness < 0) all.emplace_back(pair.second, pair.first);
    }
    return all;
  }

 private:
  static constexpr double kSoft_px = 1;  // width of the soft edges of two lines together
  using Cell = std::pair<int, int>;
  struct Kept {
    std::size_t chunk;
    PiecePoint at;
  };

  const Piece& pieceOf(std::size_t chunk) const { return pieces_[chunks_[chunk].piece]; }
  const PiecePoint& point(std::size_t chunk, std::size_t i) const { return pieceOf(chunk).points[i]; }
  double widest() const {
    double widest = 0;
    for (const Piece& piece : pieces_) widest = std::max(widest, piece.width_px);
    return widest;
  }

  void compareAndKeep(std::size_t chunk, const PiecePoint& at) {
    const glm::dvec2 place = glm::floor(at.p_px / cell_px_);
    const Cell home{static_cast<int>(place.x), static_cast<int>(place.y)};
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        if (const auto found = cells_.find({home.first + dx, home.second + dy}); found != cells_.end())
          for (const Kept& other : found->second) compare(other, chunk, at);
    cells_[home].push_back({chunk, at});
  }

  void compare(const Kept& other, std::size_t chunk, const PiecePoint& at) {
    const Piece &a = pieceOf(other.chunk), &b = pieceOf(chunk);
    if (a.color == b.color) return;
    const double reach = 0.5 * (a.width_px + b.width_px) + kSoft_px;
    if (glm::distance(other.at.p_px, at.p_px) < reach)
      nearness_[{other.chunk, chunk}] += other.at.depth - at.depth;
  }

  const std::vector<Piece>& pieces_;
  const std::vector<Chunk>& chunks_;
  double cell_px_;
  std::map<Cell, std::vector<Kept>> cells_;
  // For each pair of chunks, the sum of depth differences (first chunk minus second chunk) over their near points.
  std::map<std::pair<std::size_t, std::size_t>, double> nearness_;
};

/// Sorts chunks for painting: each chunk after all chunks below it. Chunks of a curve stay together if possible.
class Sorter {
 public:
  Sorter(std::size_t count, const std::vector<std::pair<std::size_t, std::size_t>>& pairs)
      : upper_(count), waitsFor_(count, 0), taken_(count, false) {
    for (const auto& [lower, upper] : pairs) {
      upper_[lower].push_back(upper);
      ++waitsFor_[upper];
    }
    for (std::size_t c = 0; c < count; ++c)
      if (waitsFor_[c] == 0) ready_.insert(c);
  }

  std::vector<std::size_t> sorted() {
    std::vector<std::size_t> order;
    while (order.size() < taken_.size()) {
      order.push_back(next(order));
      take(order.back());
    }
    return order;
  }

 private:
  std::size_t next(const std::vector<std::size_t>& order) const {
    if (!order.empty() && ready_.contains(order.back() + 1)) return order.back() + 1;
    return ready_.empty() ? leastWaiting() : *ready_.begin();
  }

  // Returns the chunk to take if every chunk waits for another, as for lines that overlap in a ring: the chunk
  // that waits for the fewest.
  std::size_t leastWaiting() const {
    std::size_t best = taken_.size();
    for (std::size_t c = 0; c < taken_.size(); ++c)
      if (!taken_[c] && (best == taken_.size() || waitsFor_[c] < waitsFor_[best])) best = c;
    return best;
  }

  void take(std::size_t c) {
    taken_[c] = true;
    ready_.erase(c);
    for (const std::size_t upper : upper_[c])
      if (--waitsFor_[upper] == 0 && !taken_[upper]) ready_.insert(upper);
  }

  std::vector<std::vector<std::size_t>> upper_;
  std::vector<std::size_t> waitsFor_;
  std::vector<bool> taken_;
  std::set<std::size_t> ready_;
};

/// Returns part of a piece, from point `first` to `last`. It starts one point earlier to avoid a gap.
Piece stretch(const Piece& whole, std::size_t first, std::size_t last) {
  Piece part{{}, false, whole.width_px, whole.color};
  const bool all = first == 0 && last + 1 == whole.points.size();
  const auto at = [&](std::size_t i) { return whole.points.begin() + static_cast<std::ptrdiff_t>(i); };
  part.points.assign(at(first > 0 ? first - 1 : 0), at(last + 1));
  part.closed = whole.closed && all;
  if (part.closed) part.points.pop_back();
  return part;
}

}  // namespace

std::vector<Piece> inPaintingOrder(const std::vector<Piece>& pieces) {
  std::vector<Piece> open;
  for (const Piece& piece : pieces) open.push_back(unrolled(piece));
  const std::vector<Chunk> chunks = chunksOf(open);
  const auto order = Sorter(chunks.size(), Overlaps(open, chunks).pairs()).sorted();
  std::vector<Piece> painted;
  for (std::size_t i = 0; i < order.size();) {
    const Chunk& begin = chunks[order[i]];
    std::size_t end = i + 1;
    while (end < order.size() && order[end] == order[end - 1] + 1 && chunks[order[end]].piece == begin.piece)
      ++end;
    painted.push_back(stretch(open[begin.piece], begin.first, chunks[order[end - 1]].last));
    i = end;
  }
  return painted;
}

}  // namespace poinsot::figure
