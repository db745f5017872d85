// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace poinsot::figure {

/// Returns a label's TeX as a word for an identifier, without fonts: "omega" for "$\boldsymbol{\omega}$",
/// "hat-e-1" for "$\hat{\mathbf{e}}_1$". Letters and digits are ASCII; everything else becomes a hyphen.
std::string wordOf(std::string_view tex);

/// Identifiers of the groups in one SVG, each used once.
class SvgNames {
 public:
  /// Returns the name, with -2, -3 and so on if it is already taken.
  std::string take(const std::string& name);

 private:
  std::set<std::string> taken_;
};

}  // namespace poinsot::figure
