#!/usr/bin/env bash
# python.sh FACE PICTURE: the installed Python package draws. Exit 77 where the system's Python has no NumPy.
set -euo pipefail
python=/usr/bin/python3
if ! "$python" -c 'import numpy'; then
  echo "needs python3-numpy: tools/setup --dev"
  exit 77
fi
"$python" - "$1" "$2" <<'END'
import sys

import mien

posed = mien.read_face(sys.argv[1]).pose(time=1.25)
assert posed.render((64, 36)).std() > 0
posed.save(sys.argv[2], 64)
END
[ -s "$2" ]
