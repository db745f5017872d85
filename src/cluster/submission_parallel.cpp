// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "cluster/submission.h"
#include "cluster/submission_text.h"
#include "core/shell_word.h"

/// Text of parallel.sh. The script puts the command of a task into a shell function. In a command line, GNU
/// parallel would replace {} and other strings of the command.
extern "C" const char poinsot_parallel_script[], poinsot_parallel_script_end[];

namespace poinsot::cluster {

std::string parallelScript(const Submission& submission) {
  const Division& division = submission.division;
  return filled({poinsot_parallel_script, poinsot_parallel_script_end},
                {{"what", whatText(submission, " of GNU parallel; then the script " + lastStep(submission))},
                 {"status", statusCommand(submission)},
                 {"retries", std::to_string(submission.retries)},
                 {"said", core::shellWord(tasksFolderOf(submission).string())},
                 {"indented", placeText(submission, "  ")},
                 {"shard", shardCommand(submission, "$1")},
                 {"place", placeText(submission)},
                 {"percent", std::to_string(std::max(1, 100 / division.cpus))},
                 {"tries", std::to_string(submission.retries + 1)},
                 {"shards", std::to_string(division.shards)},
                 {"join", joinCommand(submission)}});
}

}  // namespace poinsot::cluster
