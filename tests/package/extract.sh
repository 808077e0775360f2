#!/usr/bin/env bash
# extract.sh BUILD SOURCE FOLDER COMPILER: packages out of the build at hand, in short: those that a static build makes. They are
# unpacked side by side by dpkg-deb -x instead of installed, for that needs no root, no archive and no minutes; the whole is
# tools/package --try. Exit 77 where a tool of Debian's is missing.
set -euo pipefail
build=$1 source=$2 folder=$3 compiler=$4
fail() { echo "extract: $*" >&2; exit 1; }
for tool in dpkg-deb dpkg-shlibdeps file; do
  command -v $tool >/dev/null || { echo "needs $tool: tools/setup --package"; exit 77; }
done
umask 022
rm -rf "$folder" && mkdir -p "$folder"
SOURCE_DATE_EPOCH=1767225600 cpack --config "$build/CPackConfig.cmake" -B "$folder/debs" >"$folder/cpack.log" 2>&1 ||
  { cat "$folder/cpack.log"; exit 1; }
rm -rf "$folder/debs/_CPack_Packages"
cd "$folder/debs"
field() { dpkg-deb -f "$1"_*.deb "$2"; }

# What each depends on: the command on no image library, the modules on theirs.
for package in mien libmien-c0 python3-mien; do
  depends=$(field $package Depends)
  grep -qiE 'openimageio|tiff' <<<"$depends" && fail "$package depends on image libraries: $depends"
  grep -q mien-formats <<<"$(field $package Suggests)" || fail "$package does not suggest mien-formats"
done
grep -q libopenimageio <<<"$(field mien-formats Depends)" || fail "mien-formats depends on $(field mien-formats Depends)"
grep -q libc6 <<<"$(field mien Depends)" || fail "mien depends on $(field mien Depends)"
[ "$(field python3-mien Architecture)" = all ] || fail "python3-mien is not for all architectures"

# What Python compiles for itself is removed with its package.
dpkg-deb -e python3-mien_*.deb python
[ -x python/postinst ] && [ -x python/prerm ] || fail "python3-mien leaves compiled files behind"
rm -r python

# No file is in two packages.
for deb in *.deb; do dpkg-deb -c "$deb" | awk '$1 !~ /^d/ {print $6}'; done | sort | uniq -d >twice
[ ! -s twice ] || fail "in two packages: $(tr '\n' ' ' <twice)"

# Without mien-formats a PNG is drawn, and a TIFF is refused in a sentence.
for package in mien libmien-c0 libmien-c-dev python3-mien; do dpkg-deb -x ${package}_*.deb ../root; done
cd ..
face=root/usr/share/mien/faces/toon.face.json
root/usr/bin/mien render $face --size 64 -o toon.png
root/usr/bin/mien render toon --size 64 -o named.png && cmp toon.png named.png
root/usr/bin/mien render $face --size 64 -o toon.tif 2>said && fail "who writes the TIFF?"
grep -q 'cannot load what writes TIFF.*mien-tiff-' said || fail "a missing module is told so: $(cat said)"
dpkg-deb -x debs/mien-formats_*.deb root
root/usr/bin/mien render $face --size 64 -o toon.tif
[ "$(head -c 4 toon.png | tail -c 3)" = PNG ]
for file in share/man/man1/mien.1.gz share/zsh/vendor-completions/_mien share/doc/mien/changelog.Debian.gz share/doc/mien/copyright; do
  [ -s root/usr/$file ] || fail "there is no /usr/$file"
done
for text in "Apache License" "Paul Mandel" "Bitstream"; do
  grep -q "$text" root/usr/share/doc/mien/copyright || fail "the copyright does not name $text"
done

# In C, by pkg-config.
pc=$(dirname "$(find root -name mien-image-c.pc)")
read -ra flags <<<"$(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs mien-image-c)"
"$compiler" -std=c99 -pedantic -Wall -Wextra -Werror root/usr/share/doc/libmien-c-dev/examples/still.c "${flags[@]}" -o still
LD_LIBRARY_PATH=${pc%/pkgconfig} ./still $face by_c.png
[ -s by_c.png ]

# Every option of the laboratory is in its man page.
if [ -x "$build/tools/accuracy/mien-accuracy" ]; then
  for option in $("$build/tools/accuracy/mien-accuracy" --help | grep -oE -- '--[a-z-]+'); do
    grep -qF -- "${option//-/\\-}" "$source/tools/accuracy/mien-accuracy.1" || fail "the man page does not know $option"
  done
fi
"$source/tests/package/lint.sh" debs || { code=$?; [ $code = 77 ] || exit $code; }
