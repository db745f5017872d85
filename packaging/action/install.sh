#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Unpacks the archive ARCHIVE, a file or an address, and puts poinsot on the path of the later steps. Needs no root.
set -euo pipefail
fail() { echo "::error::poinsot: $*"; exit 2; }

folder=${RUNNER_TEMP:-$(mktemp -d)}/poinsot
file=$ARCHIVE
mkdir -p "$folder"
if [[ $ARCHIVE == *://* ]]; then
  [[ $SHA256 ]] || fail "sha256: give the digest of $ARCHIVE, because it is downloaded"
  command -v curl >/dev/null || fail "curl is missing, which downloads the archive: install it in an earlier step"
  file=$folder/archive.tar.xz
  curl --fail --silent --show-error --location --retry 3 --output "$file" "$ARCHIVE" || fail "$ARCHIVE cannot be downloaded"
fi
[[ -f $file ]] || fail "archive: $ARCHIVE: no such file"
[[ ! $SHA256 ]] || echo "$SHA256  $file" | sha256sum --check --quiet || fail "$ARCHIVE has another SHA-256 digest than the input sha256"
tar --extract --xz --file="$file" --directory="$folder" --strip-components=1 || fail "$ARCHIVE cannot be unpacked"
"$folder/bin/poinsot" --version
echo "$folder/bin" >>"$GITHUB_PATH"
