#!/usr/bin/env bash
# headers.sh PREFIX: the installed headers include themselves, GLM and the standard library, nothing else: no JSON,
# TBB, Eigen, Highway, fmt or OpenImageIO in what a user's compiler sees, and nothing private.
set -euo pipefail
cd "$1/include/mien"
test -f mien.h && test -f version.h && test -f api.h
if find . -mindepth 1 -type d | grep .; then
  echo "users' include paths show the house"
  exit 1
fi
if find . -name '*_private.h' -o -name '*-inl.h' | grep .; then
  echo "private headers are installed"
  exit 1
fi
if grep -rnE '^ *# *include *(<[^>]*[/.][^>]*>|")' . | grep -vE '<(mien|glm)/[^>]*>'; then
  echo "a public header includes what users need not have"
  exit 1
fi
if grep -rnE '\b(nlohmann|Eigen|tbb|hwy|fmt|OIIO)::' . | grep -vE ':[0-9]+: *//'; then
  echo "a public header names what users need not have"
  exit 1
fi
