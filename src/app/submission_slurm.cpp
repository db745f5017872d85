// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "app/submission.h"
#include "app/submission_text.h"
#include "core/error.h"
#include "core/shell_word.h"
#include "core/text.h"

namespace poinsot::app {
namespace {

/// Minutes a task may take: four times the estimate and ten, as CPUs differ and a limit ends a task.
int limit_min(const Division& division) { return static_cast<int>(std::ceil(10 + 4 * division.task_s / 60)); }

/// Absolute, as a % in the working folder would mean something to Slurm. A backslash anywhere switches the meaning
/// of all % off, and then each task's file would have the same name.
std::string saidFolder(const Submission& submission) {
  std::string folder = (submission.folder / tasksFolderOf(submission)).lexically_normal().string();
  if (folder.find('\\') != std::string::npos)
    throw core::Error(core::ErrorKind::kUsage,
                      fmt::format("{}: Slurm cannot hold the '\\' of this name; choose another output",
                                  core::printable(folder)));
  return folder;
}

/// A task's number within the array goes with the number of the whole: one task has that as $SLURM_JOB_ID, and a
/// requeue by it would be one of all tasks.
constexpr const char* kScript = R"BASH(#!/bin/bash
{what}#
#   bash SCRIPT                               submits both jobs
#   squeue --me                               what waits, what runs
#   poinsot status {output}
#   bash SCRIPT "$(poinsot status {output} --shards)"
#                                             again, only the tasks that have work left
#
# A task that fails, or is about to run out of time, goes back into the queue up to {retries} times, and on with the
# segment where it stopped; so does one whose node was lost. If one fails for good, nothing is joined.
# What the tasks say is kept in {said}.
set -eo pipefail

tasks=${{1-1-{shards}}}  # all, unless the first word of the command says which
options=()  # of yours for sbatch: --account=physics --partition=short

{place}said={said}

task() {{
  cat <<'TASK'
#!/bin/bash
late=
trap 'late=yes; kill -TERM "$!"' USR1  # Slurm says so a minute before the time is over
{place}{shard} &
render=$!
wait "$render"
code=$?
[[ $late ]] && wait "$render"
# 0: done. 2: the scene is wrong, and would be again. 129, 130, 143: somebody stopped it.
[[ $code =~ ^(0|2|129|130|143)$ && ! $late ]] && exit "$code"
again=$((${{SLURM_RESTART_COUNT:-0}} + 1))
((again <= {retries})) || exit "$code"
echo "poinsot: exit code $code: back into the queue, attempt $((again + 1))" >&2
scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID" && sleep 600  # Slurm ends it here
exit "$code"
TASK
}}

join() {{
  cat <<'JOIN'
#!/bin/bash
{place}exec {join}
JOIN
}}

if [[ -z $tasks ]]; then
  echo 'poinsot: no task has work left' >&2
  exit 0
fi
mkdir -p -- "$said"
log=${{said//%/%%}}  # a % means something in Slurm's names of files
array=$(task | sbatch --parsable --job-name={name} --array="$tasks" --requeue --ntasks=1 --cpus-per-task={cpus} \
  --mem-per-cpu={memory}M --time={minutes} --signal=B:USR1@60 --open-mode=append --output="$log/%A_%a.txt" \
  "${{options[@]}}")
array=${{array%%;*}}  # some say on which cluster, too
film=$(join | sbatch --parsable --job-name={name} --dependency="afterok:$array" --kill-on-invalid-dep=yes \
  --ntasks=1 --mem-per-cpu={memory}M --time={minutes} --open-mode=append --output="$log/%j_join.txt" \
  "${{options[@]}}")
echo "poinsot: tasks: job $array; then joined: job ${{film%%;*}}"
)BASH";

}  // namespace

std::string slurmScript(const Submission& submission) {
  const Division& division = submission.division;
  return fmt::format(
      kScript,
      fmt::arg("what",
               whatText(submission, " of a Slurm job array; a job that waits for them joins what they made")),
      fmt::arg("output", core::shellWord(outputFile(submission).string())),
      fmt::arg("retries", submission.retries), fmt::arg("said", core::shellWord(saidFolder(submission))),
      fmt::arg("shards", division.shards), fmt::arg("place", placeText(submission)),
      fmt::arg("shard", shardCommand(submission, "$SLURM_ARRAY_TASK_ID")),
      fmt::arg("join", joinCommand(submission)),
      fmt::arg("name", core::shellWord("poinsot " + submission.output.path.filename().string())),
      fmt::arg("cpus", division.cpus), fmt::arg("memory", division.memory),
      fmt::arg("minutes", limit_min(division)));
}

}  // namespace poinsot::app
