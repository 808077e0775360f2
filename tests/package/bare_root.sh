#!/usr/bin/env bash
# bare_root.sh DEBS BUILD: the packages in a bare Debian 12 in a folder: installed by apt with what they depend on, used in every
# language, and removed without a trace. Needs root and Debian's archive. BUILD is what they were made from; the bare system is
# kept there as bare.tar for the next time.
set -euo pipefail
debs=$(realpath "$1") build=$(realpath "$2")
source=$(realpath "$(dirname "$0")/../..")
fail() { echo "bare_root: $*" >&2; exit 1; }
[ "$(id -u)" = 0 ] || fail "needs root, to make a system in a folder"
command -v debootstrap >/dev/null || fail "needs debootstrap: tools/setup --package"

root=$(mktemp -d)
end() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap end EXIT
if [ ! -f "$build/bare.tar" ]; then
  debootstrap --variant=minbase bookworm "$root" >"$build/debootstrap.log" || fail "debootstrap failed: $build/debootstrap.log"
  tar -C "$root" --one-file-system -cf "$build/bare.tar.part" . && mv "$build/bare.tar.part" "$build/bare.tar"
else
  tar -C "$root" -xf "$build/bare.tar"
fi
mount -t proc proc "$root/proc"
cp /etc/resolv.conf /etc/hosts "$root/etc/"
mkdir "$root/debs" "$root/tried"
cp "$debs"/*.deb "$root/debs/"
packages=$(find "$debs" -name '*.deb' | wc -l)
(cd "$root/debs" && dpkg-scanpackages . 2>/dev/null) >"$root/debs/Packages.part" && mv "$root/debs/Packages.part" "$root/debs/Packages"
echo "deb [trusted=yes] file:/debs ./" >"$root/etc/apt/sources.list.d/ours.list"

inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
install() {
  inside apt-get -q -y -o Dpkg::Use-Pty=0 install --no-install-recommends "$@" >>"$build/bare_root.log" 2>&1 ||
    { tail -20 "$build/bare_root.log" >&2; fail "cannot install $*"; }
}
: >"$build/bare_root.log"
inside apt-get -q update >>"$build/bare_root.log" 2>&1
toon=/usr/share/mien/faces/toon.face.json

echo "the command alone"
install mien
inside mien render $toon --time 1.25 --size 640 -o /tried/toon.png
"$build/mien" render "$source/faces/toon.face.json" --time 1.25 --size 640 -o "$root/tried/built.png"
cmp "$root/tried/toon.png" "$root/tried/built.png" || fail "the installed command draws another picture than the built one"
inside dpkg-query -W -f '${Package}\n' | grep -E '^lib(openimageio|tiff|openexr)' && fail "the command needs image libraries"
for picture in toon.tif toon.exr toon.jpg; do
  inside mien render $toon --size 64 -o /tried/$picture 2>"$root/tried/said" && fail "$picture is written by whom?"
  grep -q 'install the package mien-formats' "$root/tried/said" || fail "nobody says what $picture needs: $(cat "$root/tried/said")"
done
[ -f "$root/usr/share/man/man1/mien.1.gz" ] || fail "there is no man page"

echo "in C"
install libmien-c-dev gcc libc6-dev pkg-config
inside sh -c 'cd /tried && cc -std=c99 -pedantic -Wall -Wextra -Werror /usr/share/doc/libmien-c-dev/examples/still.c \
  $(pkg-config --cflags --libs mien-image-c) -o still && ./still '$toon' by_c.png'
[ -s "$root/tried/by_c.png" ] || fail "C draws nothing"

echo "in C++"
install libmien-image-dev g++
inside sh -c 'cd /tried && zcat -f /usr/share/doc/libmien-image-dev/examples/still.cpp* >still.cpp && c++ -std=c++20 still.cpp \
  $(pkg-config --cflags --libs mien-image) -o still++ && ./still++ '$toon' by_cpp.png'
[ -s "$root/tried/by_cpp.png" ] || fail "C++ draws nothing"

echo "in Python"
install python3-mien
inside python3 -c "import mien; mien.read_face('$toon').pose(time=1.25).save('/tried/by_python.png', 640)"
[ -s "$root/tried/by_python.png" ] || fail "Python draws nothing"

echo "other formats, and the laboratory"
install mien-formats mien-accuracy
for picture in toon.tif toon.exr toon.jpg; do
  inside mien render $toon --size 64 -o /tried/$picture
done
inside mien-accuracy --count 20 --family random --kernel fast >"$root/tried/table"
grep -q '^random' "$root/tried/table" || fail "the laboratory says nothing"

echo "removed"
mapfile -t ours < <(inside dpkg-query -W -f '${Package}\n' | grep mien)
[ ${#ours[@]} = "$packages" ] || fail "installed are ${ours[*]}, which is not all of /debs"
inside apt-get -q -y -o Dpkg::Use-Pty=0 purge "${ours[@]}" >>"$build/bare_root.log" 2>&1
# Lists of packages, and dpkg's own notes of what was, stay.
if find "$root" -xdev \( -path "$root/debs" -o -path "$root/var/lib/apt" -o -path "$root/var/cache" -o -path "$root/var/log" -o -path "$root/tried" -o -path "$root/proc" \) -prune -o -name '*mien*' -print | grep .; then
  fail "removed packages leave something behind"
fi
echo "bare_root: all $packages packages were installed, used and removed"
