#!/usr/bin/env bash
# lint.sh FOLDER: lintian finds no error in the folder's packages; its warnings are shown. Exit 77 without lintian.
set -euo pipefail
if ! command -v lintian >/dev/null; then
  echo "needs lintian: tools/setup --package"
  exit 77
fi
lintian --allow-root --fail-on error "$1"/*.deb
