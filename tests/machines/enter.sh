#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs a command, by default a shell, in a room, which is a folder with a complete system: enter.sh ROOM [WORD ...].
# POINSOT_DEBS names a folder that caches the downloads of apt. Needs root.
#
# The command has its own namespace of mounts, and all its processes end with the first one, so that nothing stays behind.
set -euo pipefail
room=$(realpath -- "$1")
shift
(($#)) || set -- bash
# The first process of a room is this shell instead of the command, because it must wait for orphans.
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
