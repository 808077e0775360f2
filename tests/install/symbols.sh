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

# Every name that a library exports stands in a public header: nothing is frozen that nobody can call.
headers=$1/include/mien
for library in "$1"/lib*/libmien*.so "$1"/lib*/*/libmien*.so; do
  [ -f "$library" ] || continue
  nm -D --defined-only -C "$library" | awk '$2 == "T"' | cut -d' ' -f3- | sed -E 's/\[.*//; s/\(.*//; s/^mien:://; s/<.*//' |
    sort -u | while IFS= read -r name; do
    last=${name##*::}
    first=${name%%::*}
    if [[ $last == operator* ]]; then last=operator; fi
    if ! grep -rqwF -- "${last#\~}" "$headers" || ! grep -rqwF -- "$first" "$headers"; then
      echo "$(basename "$library") exports mien::$name, which no public header has"
      exit 1
    fi
  done
done
readelf -d "$core" | grep -E 'SONAME.*libmien\.so\.[0-9]+\.[0-9]+\]'
if readelf -d "$core" | grep -iE 'NEEDED.*(openimageio|png|tiff)'; then
  echo "the core needs an image library"
  exit 1
fi
