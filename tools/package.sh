#!/usr/bin/env bash
# Sets the machine up, builds both programs, and makes build/release/packages: talus_VERSION_amd64.deb for Debian 12, and
# talus-VERSION-x86_64.tar.gz, which runs from any folder.
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
ls -sh packages/talus*
