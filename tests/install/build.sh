#!/usr/bin/env bash
# build.sh SOURCE BUILD ARGUMENT…: configures a project with the arguments and builds it, as its owner would.
set -euo pipefail
source=$1 build=$2
shift 2
mkdir -p "$build"
cmake -G Ninja -S "$source" -B "$build" "$@"
cmake --build "$build" -j 2
