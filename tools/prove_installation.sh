#!/usr/bin/env bash
# Proves what tools/package.sh made: in a bare Debian 12 in FOLDER the archive with libraries works, with nothing else
# installed; the package is installed, works, and leaves nothing when it is removed; then the archive works in a folder of
# its own, with the packages that it asks for.
# Usage: tools/prove_installation.sh [FOLDER]        needs root and debootstrap; FOLDER is kept
set -euo pipefail
source "$(dirname "$0")/bare_debian.sh"

root=${1:-${TMPDIR:-/tmp}/talus-bare-installation}
packages=$(realpath "$(dirname "$0")/../build/release/packages")

make_bare_debian "$root"
trap 'umount "$root/proc"' EXIT
mount -t proc proc "$root/proc"
rm -rf "$root/tried" "$root/opt/talus" "$root/opt/whole"
mkdir -p "$root/tried" "$root/opt/talus" "$root/opt/whole"
cp "$packages"/talus_*.deb "$root/tried"
tar --extract --file "$packages"/talus-*-x86_64.tar.gz --strip-components 1 --directory "$root/opt/talus"
tar --extract --file "$packages"/talus-*-with-libraries.tar.gz --strip-components 1 --directory "$root/opt/whole"

# Versions, a cut, a run, a picture, a film, a grid of heights, the window.
work='
  cd /tried; rm -rf fall.* start.png
  talus-cli --version | head -1; talus --version | head -1
  talus-cli mesh $samples/step_slope/step_slope.talus | grep ^total
  talus-cli solve $samples/free_fall/free_fall.talus --out fall.results | head -1
  talus-cli render fall.results --out fall.png
  talus-cli animate fall.results --out fall.mp4 --size 320x240
  echo "{ \"talus\": 1, \"name\": \"grid\", \"materials\": {\"m\": {\"density\": 2600, \"young\": 1e10, \"poisson\": 0.2}},
    \"solids\": [{\"name\": \"ground\", \"material\": \"m\", \"terrain\": {\"file\": \"grid.asc\", \"base\": -5}}]}" > grid.talus
  printf "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n1 2\n" > grid.asc
  talus-cli inspect grid.talus | grep ground
  mkdir -p -m 700 run; QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR=/tried/run talus --screenshot start.png
  ls fall.png fall.mp4 start.png'

echo "Archive with libraries"
in_bare_debian "$root" "PATH=/opt/whole/bin:\$PATH samples=/opt/whole/share/talus/samples; $work"

echo "Package"
in_bare_debian "$root" 'apt-get -qq update; apt-get -qq install --yes --no-install-recommends /tried/talus_*.deb >/tried/log 2>&1'
in_bare_debian "$root" "samples=/usr/share/talus/samples; $work"
in_bare_debian "$root" 'apt-get -qq purge --yes talus >/tried/log 2>&1; apt-get -qq autoremove --purge --yes >>/tried/log 2>&1
  left=$(find /usr /etc /var -name "*talus*" -not -path "/var/cache/apt/*"); [[ -z $left ]] || { echo "left behind: $left"; exit 1; }
  echo "removed; packages: $(dpkg-query --show | wc -l)"'

echo "Archive"
in_bare_debian "$root" 'apt-get -qq satisfy --yes --no-install-recommends "$(cat /opt/talus/share/doc/talus/depends.txt)" >/tried/log 2>&1'
in_bare_debian "$root" "PATH=/opt/talus/bin:\$PATH samples=/opt/talus/share/talus/samples; $work"
