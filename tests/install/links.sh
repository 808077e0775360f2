#!/usr/bin/env bash
# links.sh PROGRAM: a user of the core alone loads no image library.
set -euo pipefail
libraries=$(ldd "$1")
if grep -iE 'openimageio|libmien_image|libpng|libtiff|openexr' <<<"$libraries"; then
  echo "the core links an image library"
  exit 1
fi
grep -q libtbb <<<"$libraries"  # or this test looks at the wrong thing

distance=$(dirname "$1")/distance_consumer
if ldd "$distance" | grep -iE 'libtbb|libfmt|libmien\.so'; then
  echo "distances alone link more than they need"
  exit 1
fi
