#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Compares pictures in a CI job: a suite (SUITE), tests of pytest (PYTEST) or two folders (REFERENCE and NEW). Writes the
# reports and a patch into OUTPUT, the counts to $GITHUB_OUTPUT, and a table to $GITHUB_STEP_SUMMARY. Exits as poinsot.
set -euo pipefail
fail() { echo "::error::poinsot: $*"; exit 2; }

given=$(printf '%s\n' "${SUITE:-}" "${PYTEST:-}" "${REFERENCE:-}" | grep -c . || true)
((given == 1)) || fail "give exactly one of the inputs suite, pytest and reference"
[[ ! ${REFERENCE:-} || ${NEW:-} ]] || fail "new: give the folder of the new pictures beside reference"
output=${OUTPUT:-out/golden}
report=$output/report.html
outcome=$output/outcome.json
mkdir -p "$output"
rm -f "$report" "$outcome" "$output/approved.patch"
read -ra options <<<"${OPTIONS:-}"
reports=(--report "$report" --junit "$output/junit.xml" --markdown "${GITHUB_STEP_SUMMARY:-$output/summary.md}")
code=0
if [[ ${SUITE:-} ]]; then
  poinsot golden "$SUITE" -o "$output" "${reports[@]}" "${options[@]}" --json >"$outcome" || code=$?
elif [[ ${REFERENCE:-} ]]; then
  poinsot diff "$REFERENCE" "$NEW" "${reports[@]}" "${options[@]}" --json >"$outcome" || code=$?
else
  read -ra words <<<"$PYTEST"
  python3 -m pytest --golden-output="$output" --golden-markdown="${GITHUB_STEP_SUMMARY:-$output/summary.md}" \
    --golden-json="$outcome" --junitxml="$output/junit.xml" "${words[@]}" "${options[@]}" || code=$?
fi

# Makes the patch that approves all new pictures, in a second work tree, so that this one keeps its references.
patch=
if ((code == 1)) && [[ -f $report ]] && root=$(git rev-parse --show-toplevel 2>/dev/null); then
  tree=$(mktemp -d)
  if git worktree add --quiet --detach "$tree/tree" HEAD 2>/dev/null; then
    # CI is unset, because nothing is approved here: a person applies the patch after looking at the pictures.
    if (cd "$tree/tree" && env -u CI poinsot golden approve "$OLDPWD/$report" '*' --quiet && git add --all); then
      patch=$output/approved.patch
      git -C "$tree/tree" diff --cached --binary >"$patch"
    fi
    git worktree remove --force "$tree/tree"
  fi
  rm -rf "$tree"
fi

# Prints a line VERDICT=NUMBER for each verdict, from the object "counts" of the JSON.
counts() { sed -n '/^ "counts": {/,/^ }/s/^  "\([a-z]*\)": \([0-9]*\),\{0,1\}$/\1=\2/p' "$outcome" 2>/dev/null || true; }
{
  counts
  failed=$(counts | awk -F= '$1 != "identical" && $1 != "near" {sum += $2} END {print sum + 0}')
  echo "failed=$failed"
  [[ ! -f $report ]] || echo "report=$report"
  echo "patch=$patch"
} >>"${GITHUB_OUTPUT:-/dev/stdout}"
where=
[[ ! -f $report ]] || where="; the page $report in the artifact shows the pictures"
((code == 0)) || echo "::error::poinsot: exit code $code$where"
exit "$code"
