#!/bin/bash
@what@
#
#   bash SCRIPT                             on this machine
#   bash SCRIPT --sshloginfile NODES        on the machines that a file names
#   bash SCRIPT --jobs 8                    eight tasks at a time on each; all options of parallel work
#   @status@
#
# A task that fails is tried again up to @retries@ times, and goes on with the segment where it stopped. If one fails for
# good, no more are begun and nothing is joined; the same command goes on from there, and makes nothing if the film is
# there. What became of each task is told in @said@/joblog.
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
