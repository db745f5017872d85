#!/bin/bash
@what@
#
#   bash SCRIPT                             on this machine
#   bash SCRIPT --sshloginfile NODES        on the machines listed in a file
#   bash SCRIPT --jobs 8                    eight tasks at a time on each machine; all options of parallel work
#   @status@
#
# A task that fails is tried again up to @retries@ times, and continues at the segment where it stopped. If a task fails
# for good, no further task starts and nothing is joined. To continue, run the same command again; it makes only what is
# missing. The result of each task is in @said@/joblog.
set -eo pipefail

task() {
@indented@
  @shard@
}
export -f task
export POINSOT

@place@
said=@said@
mkdir -p -- "$said"
parallel --env task --env POINSOT --jobs @percent@% --retries @tries@ --halt soon,fail=1 --tag --line-buffer \
  --joblog "$said/joblog" "$@" task {} ::: {1..@shards@}
@join@
