// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "cluster/submission.h"
#include "cluster/submission_text.h"
#include "core/shell_word.h"

namespace poinsot::cluster {

std::string linesScript(const Submission& submission) {
  std::string start = "cd -- " + core::shellWord(submission.folder.string()) + " && ";
  for (const std::string& command : submission.setup) start += setupLine(command) + " && ";
  const std::string program = core::shellWords(submission.program);
  std::string text;
  for (int k = 1; k <= submission.division.shards; ++k)
    text += start + shardCommand(submission, std::to_string(k), program) + "\n";
  return text + start + "{ " + joinCommand(submission, program) + "; }\n";
}

}  // namespace poinsot::cluster
