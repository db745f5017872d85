#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs a command in a room, a folder with a whole system in it: enter.sh ROOM [WORD ...]; a shell without words.
# POINSOT_DEBS names a folder that keeps what apt downloads. Needs root.
#
# Mounts are in a namespace of the command, and its processes end with their first: nothing stays behind.
set -euo pipefail
room=$(realpath -- "$1")
shift
(($#)) || set -- bash
# The first process of a room is this shell and not the command, because orphans need somebody who waits for them.
exec setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child bash -euc '
  room=$1 debs=$2
  shift 2
  mount --make-rprivate /
  mount -t proc proc "$room/proc"
  mount --rbind /sys "$room/sys"
  mount --rbind /dev "$room/dev"
  mount -t tmpfs -o mode=1777 tmpfs "$room/dev/shm"
  [[ -z $debs ]] || mount --bind "$debs" "$room/var/cache/apt/archives"
  cat /etc/resolv.conf >"$room/etc/resolv.conf"
  printf "127.0.0.1 localhost\n127.0.1.1 %s\n" "$(uname -n)" >"$room/etc/hosts"
  status=0
  env -i HOME=/home/trial PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM=dumb \
    chroot "$room" sh -c "cd /src/poinsot 2>/dev/null || cd; exec \"\$@\"" sh "$@" || status=$?
  exit "$status"' bash "$room" "${POINSOT_DEBS:-}" "$@"
