// SPDX-License-Identifier: Apache-2.0
#include "hull.h"

#include <algorithm>
#include <cmath>

namespace poinsot::render {

double hullArea(std::vector<glm::vec2> p) {
  std::sort(p.begin(), p.end(), [](glm::vec2 a, glm::vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  const auto cross = [](glm::vec2 o, glm::vec2 a, glm::vec2 b) {
    return (double(a.x) - o.x) * (double(b.y) - o.y) - (double(a.y) - o.y) * (double(b.x) - o.x);
  };
  std::vector<glm::vec2> hull(2 * p.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    while (k >= 2 && cross(hull[k - 2], hull[k - 1], p[i]) <= 0) --k;
    hull[k++] = p[i];
  }
  const std::size_t lower = k + 1;
  for (std::size_t i = p.size() - 1; i-- > 0;) {
    while (k >= lower && cross(hull[k - 2], hull[k - 1], p[i]) <= 0) --k;
    hull[k++] = p[i];
  }
  double twice = 0;
  for (std::size_t i = 0; i + 1 < k; ++i)
    twice += double(hull[i].x) * hull[i + 1].y - double(hull[i + 1].x) * hull[i].y;
  return std::abs(twice) / 2;
}

}  // namespace poinsot::render
