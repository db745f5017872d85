// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "cluster/submission.h"
#include "cluster/submission_text.h"
#include "core/shell_word.h"

namespace poinsot::cluster {
namespace {

/// The task is a function with the words in it, so that parallel, which reads {} and the like in what it is told,
/// sees none of them.
constexpr const char* kParallelScript = R"BASH(#!/bin/bash
{what}#
#   bash SCRIPT                             on this machine
#   bash SCRIPT --sshloginfile NODES        on the machines that a file names
#   bash SCRIPT --jobs 8                    eight tasks at a time on each; all options of parallel work
#   {status}
#
# A task that fails is tried again up to {retries} times, and goes on with the segment where it stopped. If one fails for
# good, no more are begun and nothing is joined; the same command goes on from there, and makes nothing if the film is
# there. What became of each task is told in {said}/joblog.
set -eo pipefail

task() {{
{indented}  {shard}
}}
export -f task
export POINSOT

{place}said={said}
mkdir -p -- "$said"
parallel --env task --env POINSOT --jobs {percent}% --retries {tries} --halt soon,fail=1 --tag --line-buffer \
  --joblog "$said/joblog" "$@" task {{}} ::: {{1..{shards}}}
{join}
)BASH";

}  // namespace

std::string parallelScript(const Submission& submission) {
  const Division& division = submission.division;
  return fmt::format(kParallelScript, fmt::arg("what", whatText(submission, " of GNU parallel, and then joined")),
                     fmt::arg("status", statusCommand(submission)), fmt::arg("retries", submission.retries),
                     fmt::arg("said", core::shellWord(tasksFolderOf(submission).string())),
                     fmt::arg("indented", placeText(submission, "  ")),
                     fmt::arg("shard", shardCommand(submission, "$1")), fmt::arg("place", placeText(submission)),
                     fmt::arg("percent", std::max(1, 100 / division.cpus)),
                     fmt::arg("tries", submission.retries + 1), fmt::arg("shards", division.shards),
                     fmt::arg("join", joinCommand(submission)));
}

}  // namespace poinsot::cluster
