// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "cluster/submission.h"
#include "cluster/submission_text.h"
#include "core/error.h"
#include "core/shell_word.h"
#include "core/text.h"

namespace poinsot::cluster {
namespace {

/// Minutes a task may take: four times the estimate and ten, as CPUs differ and a limit ends a task.
int limit_min(const Division& division) { return static_cast<int>(std::ceil(10 + 4 * division.task_s / 60)); }

/// Absolute, as a % in the working folder would mean something to Slurm. A backslash anywhere switches the meaning
/// of all % off, and then each task's file would have the same name.
std::string saidFolder(const Submission& submission) {
  std::string folder = (submission.folder / tasksFolderOf(submission)).lexically_normal().string();
  if (folder.find('\\') != std::string::npos)
    throw core::usageError(fmt::format("{}: Slurm cannot hold the '\\' of this name; choose another output",
                                       core::printable(folder)));
  return folder;
}

/// Returns "poinsot_film.mp4", without blanks and equals signs: sacct -c splits its records there, and stops.
std::string jobName(const Submission& submission) {
  std::string name = "poinsot_" + submission.output.path.filename().string();
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7f || c == '=') c = '_';
  return name;
}

/// A task's number within the array goes with the number of the whole: one task has that as $SLURM_JOB_ID, and a
/// requeue by it would be one of all tasks. Failures are counted in a file, since SLURM_RESTART_COUNT also has the
/// requeues of Slurm itself, by preemption or for a lost node.
constexpr const char* kSlurmScript = R"BASH(#!/bin/bash
{what}#
#   bash SCRIPT         submits the tasks that have work left, and the job that joins; nothing if the film is there
#   bash SCRIPT 2,7-9   submits these tasks, and the job that joins
#   squeue --me
#   {status}
#
# A task that fails, or is about to run out of time, goes back into the queue, and on with the segment where it
# stopped, up to {retries} times at one segment. Preemption and lost nodes are not counted. If a task fails for good,
# nothing is joined. Whenever there is no film, mend what was wrong and run this script again.
# What the tasks say is kept in {said}.
set -eo pipefail

options=()  # of yours for sbatch: --account=physics --partition=short

{place}said={said}

# Prints how both jobs begin: with the program's own name, because sbatch --export=NONE drops $POINSOT.
place() {{
  printf '#!/bin/bash\ncd -- %q || exit 4\npoinsot=%q said=%q\n' "$PWD" "$poinsot" "$said"
}}

task() {{
  place
  cat <<'TASK'
render=({shard})
late=
trap 'late=yes; kill -TERM "$!"' USR1  # Slurm says so a minute before the time is over
"${{render[@]}}" &
wait "$!"
code=$?
[[ $late ]] && wait "$!"
# 0: done. 2: the scene is wrong, and would be again. 129, 130, 143: somebody stopped it.
[[ $code =~ ^(0|2|129|130|143)$ && ! $late ]] && exit "$code"
# Each failure adds how far the task is by then: equal lines are failures at one segment.
failures=$said/${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID.failures
far=$("${{render[@]}}" --dry-run 2>/dev/null)
printf '%s\n' "$far" >>"$failures" || exit "$code"
count=$(grep -cFxe "$far" -- "$failures")
((count <= {retries})) || exit "$code"
echo "poinsot: exit code $code: back into the queue, failure $count at this segment" >&2
scontrol requeue "${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID" && sleep 600  # Slurm ends it here
exit "$code"
TASK
}}

join() {{
  place
  cat <<'JOIN'
{join}
JOIN
}}

# Submits the job that it reads; prints its number.
submit() {{
  local job
  job=$(sbatch --parsable --job-name={name} --ntasks=1 --mem-per-cpu={memory}M --time={minutes} \
    --open-mode=append "$@" "${{options[@]}}") && echo "${{job%%;*}}"  # some say on which cluster, too
}}

tasks=$1
if [[ -z $tasks ]]; then
  tasks=$({left}) && exit  # the film is there
  code=$?
  ((code == 1)) || exit "$code"
fi
mkdir -p -- "$said"
log=${{said//%/%%}}  # a % means something in Slurm's names of files
after=()
if [[ $tasks ]]; then
  array=$(task | submit --array="$tasks" --requeue --cpus-per-task={cpus} --signal=B:USR1@60 \
    --output="$log/%A_%a.txt")
  after=(--dependency="afterok:$array" --kill-on-invalid-dep=yes)
  echo "poinsot: tasks $tasks: job $array"
fi
film=$(join | submit "${{after[@]}}" --output="$log/%j_join.txt")
echo "poinsot: joined by job $film"
)BASH";

}  // namespace

std::string slurmScript(const Submission& submission) {
  const Division& division = submission.division;
  return fmt::format(
      kSlurmScript,
      fmt::arg("what",
               whatText(submission, " of a Slurm job array; a job that waits for them joins what they made")),
      fmt::arg("status", statusCommand(submission)), fmt::arg("retries", submission.retries),
      fmt::arg("said", core::shellWord(saidFolder(submission))), fmt::arg("place", placeText(submission)),
      fmt::arg("shard", shardCommand(submission, "$SLURM_ARRAY_TASK_ID")),
      fmt::arg("left", leftCommand(submission)), fmt::arg("join", joinCommand(submission)),
      fmt::arg("name", core::shellWord(jobName(submission))), fmt::arg("cpus", division.cpus),
      fmt::arg("memory", division.memory), fmt::arg("minutes", limit_min(division)));
}

}  // namespace poinsot::cluster
