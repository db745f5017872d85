// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "physics/double_double.h"

namespace poinsot::physics {

/// Number stored without rounding, as a sum of doubles whose bits do not overlap, smallest first. Any sum of
/// products of doubles is exact, unless a product underflows. Used for L² - 2 T I, whose sign and last digits
/// decide the motion.
/// Source: J. R. Shewchuk, Discrete Comput. Geom. 18 (1997) 305, GROW-EXPANSION and SCALE-EXPANSION.
class Expansion {
 public:
  Expansion() = default;

  void add(double b) {
    for (double& term : terms_) {
      const DoubleDouble sum = twoSum(b, term);
      term = sum.lo;
      b = sum.hi;
    }
    terms_.push_back(b);
  }

  void add(const Expansion& other) {
    for (const double term : other.terms_) add(term);
  }

  void scale(double b) {
    const std::vector<double> before = std::move(terms_);
    terms_.clear();
    for (const double term : before) {
      const DoubleDouble product = twoProduct(term, b);
      add(product.lo);
      add(product.hi);
    }
  }

  /// Returns the value with a relative accuracy of 106 bits. The result is 0 only if the exact value is 0.
  DoubleDouble value() const {
    DoubleDouble sum;
    for (const double term : terms_) sum += DoubleDouble(term);
    return sum;
  }

 private:
  std::vector<double> terms_;
};

}  // namespace poinsot::physics
