// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace poinsot::cli {

constexpr std::size_t kColumns = 100;  ///< of text for a terminal

/// Broken at spaces to lines of at most `width` characters, each but the first after `indent`; a line end stays
/// one. `column` characters stand before the first. Ends without a line end.
std::string wrapped(std::string_view paragraph, std::size_t width = kColumns, std::size_t indent = 0,
                    std::size_t column = 0);

}  // namespace poinsot::cli
