#!/usr/bin/env bash
# Sets the machine up, builds both programs, and makes build/release/packages: talus_VERSION_amd64.deb for Debian 12,
# talus-VERSION-x86_64.tar.gz, which runs from any folder there, and talus-VERSION-x86_64-with-libraries.tar.gz, which
# runs on other systems, too.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"

install_packages
configure
build programs
cd "$build"
rm -rf packages depends.txt
cpack -G DEB
# The archive brings no libraries: what to install for it is what the package depends on.
dpkg-deb --field packages/talus_*.deb Depends >depends.txt
cpack -G TGZ
archive=$(basename packages/talus-*-x86_64.tar.gz .tar.gz)
if ! command -v patchelf >/dev/null; then
  echo "The archive with libraries is left out: it takes patchelf (apt-get install patchelf)" >&2
  ls -sh packages/talus*
  exit
fi
tar --extract --file "packages/$archive.tar.gz" --directory packages
mv "packages/$archive" "packages/$archive-with-libraries"
rm "packages/$archive-with-libraries/share/doc/talus/depends.txt"
../../tools/bundle_libraries.sh "packages/$archive-with-libraries"
tar --create --gzip --owner=0 --group=0 --file "packages/$archive-with-libraries.tar.gz" --directory packages \
  "$archive-with-libraries"
rm -rf "packages/$archive-with-libraries"
ls -sh packages/talus*
