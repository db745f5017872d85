#!/bin/bash
@what@
#
#   bash SCRIPT         submits the tasks that have work left, and the job that joins; nothing if the film is there
#   bash SCRIPT 2,7-9   submits these tasks, and the job that joins
#   squeue --me
#   @status@
#
# A task that fails, or is about to run out of time, goes back into the queue, and on with the segment where it
# stopped, up to @retries@ times at one segment. Preemption and lost nodes are not counted. If a task fails for good,
# nothing is joined. Whenever there is no film, mend what was wrong and run this script again.
# What the tasks say is kept in @said@.
set -eo pipefail

options=()  # of yours for sbatch: --account=physics --partition=short

@place@
said=@said@

# Prints how both jobs begin: with the program's own name, because sbatch --export=NONE drops $POINSOT.
place() {
  printf '#!/bin/bash\ncd -- %q || exit 4\npoinsot=%q said=%q\n' "$PWD" "$poinsot" "$said"
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
# 0: done. 2: the scene is wrong, and would be again. 129, 130, 143: somebody stopped it.
[[ $code =~ ^(0|2|129|130|143)$ && ! $late ]] && exit "$code"
# Each failure adds how far the task is by then: equal lines are failures at one segment.
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

# Submits the job that it reads; prints its number.
submit() {
  local job
  job=$(sbatch --parsable --job-name=@name@ --ntasks=1 --mem-per-cpu=@memory@M --time=@minutes@ \
    --open-mode=append "$@" "${options[@]}") && echo "${job%%;*}"  # some say on which cluster, too
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
  array=$(task | submit --array="$tasks" --requeue --cpus-per-task=@cpus@ --signal=B:USR1@60 \
    --output="$log/%A_%a.txt")
  after=(--dependency="afterok:$array" --kill-on-invalid-dep=yes)
  echo "poinsot: tasks $tasks: job $array"
fi
film=$(join | submit "${after[@]}" --output="$log/%j_join.txt")
echo "poinsot: joined by job $film"
