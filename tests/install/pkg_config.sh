#!/usr/bin/env bash
# pkg_config.sh PREFIX CONSUMER FACE COMPILER: builds and runs the consumer with pkg-config's flags.
set -euo pipefail
prefix=$1 consumer=$2 face=$3 compiler=$4
libdir=$(dirname "$(find "$prefix" -name mien.pc)")
export PKG_CONFIG_PATH=$libdir LD_LIBRARY_PATH=${libdir%/pkgconfig}
program=$prefix/consumer
read -ra flags <<<"$(pkg-config --cflags --libs mien)"
"$compiler" -std=c++20 "$consumer/consumer.cpp" "${flags[@]}" -o "$program"
"$program" "$face"

read -r version _ <<<"$(pkg-config --modversion mien)"
"$program" "$face" | grep -F "mien $version:"
read -ra flags <<<"$(pkg-config --cflags --libs mien-distance)"
"$compiler" -std=c++20 "$consumer/distance_consumer.cpp" "${flags[@]}" -o "$program-distance"
"$program-distance"
if [ -f "$libdir/mien-image.pc" ]; then
  read -ra flags <<<"$(pkg-config --cflags --libs mien-image)"
  "$compiler" -std=c++20 "$consumer/image_consumer.cpp" "${flags[@]}" -o "$program-image"
  "$program-image" "$face" "$prefix/face.png"
fi
