#!/usr/bin/env bash
# install.sh BUILD PREFIX COMPONENT…: installs the components into an empty prefix.
set -euo pipefail
build=$1 prefix=$2
shift 2
rm -rf "$prefix"
for component in "$@"; do cmake --install "$build" --prefix "$prefix" --component "$component"; done
