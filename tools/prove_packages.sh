#!/usr/bin/env bash
# Proves that tools/packages.txt is complete: makes a bare Debian 12 in FOLDER with only a compiler, CMake and git,
# clones the last commit into it and runs tools/test.sh there (with --configure-only: installs and configures).
# Usage: tools/prove_packages.sh [--configure-only] [FOLDER]        needs root and debootstrap; FOLDER is kept
set -euo pipefail
source "$(dirname "$0")/bare_debian.sh"

job='tools/test.sh'
if [[ ${1:-} == --configure-only ]]; then
  job='source tools/set_up.sh && install_packages && configure'
  shift
fi
root=${1:-${TMPDIR:-/tmp}/talus-bare}
source=$(realpath "$(dirname "$0")/..")

make_bare_debian "$root" g++,make,cmake,git,ca-certificates
trap 'umount "$root/proc"' EXIT
mount -t proc proc "$root/proc"
rm -rf "$root/talus"
git clone --quiet --no-hardlinks "$source" "$root/talus"
echo "Before: $(chroot "$root" dpkg-query --show | wc -l) packages"
time in_bare_debian "$root" "cd /talus; $job"
echo "After: $(chroot "$root" dpkg-query --show | wc -l) packages"
