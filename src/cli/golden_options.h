// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/allowance.h"

namespace poinsot::cli {

class Command;

/// Options of `poinsot golden`, as the user typed them.
struct GoldenOptions : AllowanceOptions {
  std::string manifest = "golden.toml", output = "out/golden", images, junit, report, markdown, outcome, variant,
              approveBy, backend = "auto";
  std::vector<std::string> only;
  std::vector<std::string> approved;  ///< after the word approve: report, then names of tests
  int jobs = 0;
  bool force = false, update = false, beside = false, exact = false, native = false, list = false, unused = false,
       quiet = false, json = false;
};

void addGoldenOptions(const Command& command, GoldenOptions& options);

}  // namespace poinsot::cli
