#!/bin/bash
@what@
#
#   bash SCRIPT         submits tasks that are not finished, and the last job; does nothing if all is complete
#   bash SCRIPT 2,7-9   submits only these tasks, and the last job
#   squeue --me
#   @status@
#
# A task that fails or runs out of time is queued again and continues at the segment where it stopped, up to @retries@
# times per segment. Preemption and lost nodes do not count. If a task fails for good, the last job does not run. If
# something is missing at the end, fix the cause and run this script again.
# The output of the tasks is in @said@.
set -eo pipefail

options=()  # of yours for sbatch: --account=physics --partition=short
at_once=    # the most tasks to run at a time; if empty, as many as Slurm allows

# Lines that run first here and in each job, such as module load.
setup() {
@setup@
}

cd -- @folder@ || exit 4
setup
poinsot=(@program@)
[[ $POINSOT ]] && poinsot=("$POINSOT")
said=@said@

# Prints the beginning of both jobs, with the program's path, because sbatch --export=NONE drops $POINSOT.
place() {
  printf '#!/bin/bash\ncd -- %q || exit 4\n' "$PWD"
  declare -f setup
  printf 'setup || exit\npoinsot=(%s) said=%q\n' "${poinsot[*]@Q}" "$said"
}

task() {
  place
  cat <<'TASK'
render=(@shard@)
late=
trap 'late=yes; kill -TERM "$!"' USR1  # Slurm says so a minute before the time is over
"${render[@]}" &
wait "$!"
code=$?
[[ $late ]] && wait "$!"
# 0: done. 2: the scene is wrong, so a retry is useless. 129, 130, 143: stopped by a signal.
[[ $code =~ ^(0|2|129|130|143)$ && ! $late ]] && exit "$code"
# Each failure appends the progress of the task: equal lines are failures at the same segment.
failures=$said/${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID.failures
far=$("${render[@]}" --dry-run 2>/dev/null)
printf '%s\n' "$far" >>"$failures" || exit "$code"
count=$(grep -cFxe "$far" -- "$failures")
((count <= @retries@)) || exit "$code"
echo "poinsot: exit code $code: back into the queue, failure $count at this segment" >&2
scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID" && sleep 600  # Slurm ends it here
exit "$code"
TASK
}

join() {
  place
  cat <<'JOIN'
@join@
JOIN
}

# Submits the job script on standard input; prints the job's number.
submit() {
  local job
  job=$(sbatch --parsable --job-name=@name@ --ntasks=1 --open-mode=append "$@" "${options[@]}") && echo "${job%%;*}"  # some say on which cluster, too
}

tasks=$1
if [[ -z $tasks ]]; then
  tasks=$(@left@) && exit  # the film is there
  code=$?
  ((code == 1)) || exit "$code"
fi
mkdir -p -- "$said"
log=${said//%/%%}  # a % means something in Slurm's names of files
after=()
if [[ $tasks ]]; then
  array=$(task | submit --array="$tasks${at_once:+%$at_once}" --requeue --cpus-per-task=@cpus@ --signal=B:USR1@60 \
    --mem-per-cpu=@memory@M --time=@minutes@ --output="$log/%A_%a.txt")
  after=(--dependency="afterok:$array" --kill-on-invalid-dep=yes)
  echo "poinsot: tasks $tasks: job $array"
fi
film=$(join | submit "${after[@]}" --mem-per-cpu=256M --time=@join_minutes@ --output="$log/%j_join.txt")
echo "poinsot: @joined@ by job $film"
