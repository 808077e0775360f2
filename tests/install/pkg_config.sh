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

# Macros that leave GLM's types as they are change nothing. The others are refused with a sentence.
neutral="-DGLM_FORCE_SWIZZLE -DGLM_FORCE_EXPLICIT_CTOR -DGLM_FORCE_CTOR_INIT -DGLM_FORCE_INTRINSICS -DGLM_FORCE_INLINE \
  -DGLM_FORCE_UNRESTRICTED_GENTYPE -DGLM_FORCE_DEPTH_ZERO_TO_ONE -DGLM_FORCE_LEFT_HANDED -DGLM_ENABLE_EXPERIMENTAL"
# shellcheck disable=SC2086
"$compiler" -std=c++20 $neutral "$consumer/consumer.cpp" "${flags[@]}" -o "$program-glm"
[ "$("$program-glm" "$face")" = "$("$program" "$face")" ]
for macros in "-DGLM_FORCE_INTRINSICS -DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES" -DGLM_FORCE_SIZE_T_LENGTH; do
  # shellcheck disable=SC2086
  if "$compiler" -std=c++20 -fsyntax-only $macros "$consumer/consumer.cpp" "${flags[@]}" 2>"$program-glm.log"; then
    echo "$macros changes GLM's types, and nobody says so"
    exit 1
  fi
  grep -q "mien needs GLM's default types" "$program-glm.log"
done

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
