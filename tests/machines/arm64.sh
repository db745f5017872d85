#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Compares a poinsot for arm64, which qemu-aarch64 starts, with one of this machine: arm64.sh PROGRAM ARM64_PROGRAM.
# Prints the digest of the trajectories of each scene of the gallery by both, makes a film of 30 frames, and prints the
# verdicts of ten pictures of the golden suite. Exit code 1 if a trajectory differs or a picture is different.
# docs/testing.md explains how to build the second program.
set -euo pipefail
(($# == 2)) || { echo "usage: tests/machines/arm64.sh PROGRAM ARM64_PROGRAM" >&2; exit 2; }
program=$(realpath "$1") arm64=(qemu-aarch64 -L / "$(realpath "$2")")
cd "${BASH_SOURCE[0]%/*}/../.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# Prints the digest of a trajectory: 30 rows per second, but 101 rows in scenes that last months.
digest() {
  local times=(--rate 30) name
  name=$(basename "${!#}" .toml)
  [[ $name != @(chandler_*|toutatis) ]] || times=(--at="$(seq -s, 0 1e5 1e7)")
  "$@" "${times[@]}" | sha256sum | cut -c1-16
}

differing=0
for scene in scenes/*.toml; do
  here=$(digest "$program" trajectory "$scene") there=$(digest "${arm64[@]}" trajectory "$scene")
  echo "$here $there $(basename "$scene" .toml)"
  [[ $here == "$there" ]] || differing=$((differing + 1))
done
echo "$differing trajectories differ"

"${arm64[@]}" render scenes/football.toml --reproducible --size 320x180 --frames 0-29 --progress none -o "$out/film.mp4"
status=0
"${arm64[@]}" golden tests/golden/golden.toml -o "$out/golden" --only gallery_{cones_prolate,football,momentum_sphere} \
  gallery_{poinsot_construction,tennis_racket} body_box body_t_handle plot timeline writing || status=$?
((differing == 0 && status == 0))
