#!/usr/bin/env bash
# abi.sh ABIDIFF BUILD BUILD: the shared libraries of two builds have the same binary interface; and abidiff sees one that has
# another: mien::distance alone against the core.
set -euo pipefail
abidiff=$1
core() { find "$1" -name 'libmien.so' | head -1; }
ours=$(dirname "$0")/abi_suppressions.ini
"$abidiff" --suppr "$ours" "$(core "$2")" "$(core "$3")"
if "$abidiff" --suppr "$ours" "$(core "$2")" "$(find "$2" -name 'libmien-distance.so' | head -1)" >/dev/null; then
  echo "abidiff sees no difference between two interfaces"
  exit 1
fi
