#!/usr/bin/env bash
# c_words.sh PREFIX SOURCE COMPILER: the C programs of docs/c.md and of the header are compiled as they stand there, with
# pkg-config's flags, and draw.
set -euo pipefail
prefix=$1 source=$2 compiler=$3
libdir=$(dirname "$(find "$prefix" -name mien-c.pc)")
export PKG_CONFIG_PATH=$libdir LD_LIBRARY_PATH=${libdir%/pkgconfig}
if [ "$(cd "$prefix/include" && find . -type f | sort | tr '\n' ' ')" != "./mien_c.h ./mien_image_c.h " ]; then
  echo "the C packages install other headers than their own"
  exit 1
fi

folder=$prefix/words
rm -rf "$folder" && mkdir -p "$folder"
ln -s "$source/faces" "$folder/faces"
cd "$folder"
awk '/^```c$/ { inside = !programs++; next } /^```$/ { inside = 0 } inside' "$source/docs/c.md" >page.c
sed -n '/^ \*   #include <mien_c.h>$/,/^ \*   }$/ s/^ \* \{0,3\}//p' "$prefix/include/mien_c.h" >header.c
for program in page header; do
  grep -q '^int main(void) {' $program.c
  package=mien-c
  if [ $program = page ]; then package=mien-image-c; fi
  read -ra flags <<<"$(pkg-config --cflags --libs $package)"
  "$compiler" -std=c99 -pedantic -Wall -Wextra -Werror $program.c "${flags[@]}" -o $program
done
./page
[ "$(head -c 4 toon.png | tail -c 3)" = PNG ]
[ "$(./header | wc -c)" = $((640 * 360 * 4)) ]
# What fails says why.
rm faces && if ./header 2>said >/dev/null; then exit 1; fi
grep -q '^faces/toon.face.json: .' said
