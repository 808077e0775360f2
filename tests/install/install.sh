#!/usr/bin/env bash
# install.sh BUILD PREFIX COMPONENT…: installs the components, and what programs need of them, into an empty prefix.
set -euo pipefail
build=$1 prefix=$2
shift 2
rm -rf "$prefix"
for component in "$@"; do
  for part in "$component" "$component-runtime"; do cmake --install "$build" --prefix "$prefix" --component "$part"; done
done
