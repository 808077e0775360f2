#!/usr/bin/env bash
# symbols.sh PREFIX: a shared mien exports its public functions and nothing of what it stands on or hides.
set -euo pipefail
core=$(find "$1" -name 'libmien.so')
exported=$(nm -D --defined-only -C "$core" | awk '$2 == "T"' | cut -d' ' -f3-)
grep -q '^mien::render(' <<<"$exported"
grep -q '^mien::read_face(' <<<"$exported"
if grep -vE '^mien::[a-zA-Z_0-9:~=]+(\(|\[)' <<<"$exported"; then
  echo "these are not mien's to export"
  exit 1
fi
readelf -d "$core" | grep -E 'SONAME.*libmien\.so\.[0-9]+\.[0-9]+\]'
if readelf -d "$core" | grep -iE 'NEEDED.*(openimageio|png|tiff)'; then
  echo "the core needs an image library"
  exit 1
fi
