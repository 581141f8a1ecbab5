#!/usr/bin/env bash
# Proves that tools/packages.txt is complete: makes a bare Debian 12 in FOLDER with only a compiler, CMake and git,
# clones the last commit into it and runs tools/test.sh there (with --configure-only: installs and configures).
# Usage: tools/prove_packages.sh [--configure-only] [FOLDER]        needs root and debootstrap; FOLDER is kept
set -euo pipefail

job='tools/test.sh'
if [[ ${1:-} == --configure-only ]]; then
  job='source tools/set_up.sh && install_packages && configure'
  shift
fi
root=${1:-${TMPDIR:-/tmp}/talus-bare}
source=$(realpath "$(dirname "$0")/..")

# "URI SUITE COMPONENT" of Debian's own archives, as this machine's apt knows them.
archives=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Component: main' |
  grep --extended-regexp ' bookworm(-updates|-security)? ')
mirror=$(sed -n 's/ bookworm main$//p' <<<"$archives" | head -1)

if [[ ! -x $root/usr/bin/cmake ]]; then
  debootstrap --variant=minbase --include=g++,make,cmake,git,ca-certificates bookworm "$root" "$mirror" \
    >"$root.debootstrap.log"
  sed 's/^/deb /' <<<"$archives" >"$root/etc/apt/sources.list"
fi
cp /etc/resolv.conf "$root/etc/resolv.conf"

trap 'umount "$root/proc"' EXIT
mount -t proc proc "$root/proc"
rm -rf "$root/talus"
git clone --quiet --no-hardlinks "$source" "$root/talus"
echo "Before: $(chroot "$root" dpkg-query --show | wc -l) packages"
time chroot "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin bash -euo pipefail -c "cd /talus; $job"
echo "After: $(chroot "$root" dpkg-query --show | wc -l) packages"
