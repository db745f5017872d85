# SPDX-License-Identifier: Apache-2.0
# Configures a preset of CMake in a folder below the build folder, and builds a target there.
preset_build() { # $1: preset, $2: folder, $3: target; then options of CMake
  local preset=$1 folder=$build/$2 target=$3 log=$build/$2/compile.log
  shift 3
  expect_tools
  mkdir -p "$folder" || give_up "$folder cannot be written"
  say "building ${folder#"$root"/} (log: ${log#"$root"/})"
  (cd "$root" && cmake --preset "$preset" -B "$folder" -Wno-dev "${cached[@]}" "$@" && cmake --build "$folder" --target "$target") >"$log" 2>&1 ||
    { tail -n 60 "$log" >&2 || true; give_up "the build failed" "$log"; }
}
