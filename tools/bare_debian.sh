# Sourced by prove_packages.sh and prove_installation.sh, which try things where nothing else is installed; needs root and
# debootstrap, and takes packages from where the machine's own apt does.

# make_bare_debian ROOT [PACKAGES]  A Debian 12 in the folder ROOT with these packages (a,b,c) beside the least; one that
# is there already is taken.
make_bare_debian() {
  local root=$1 packages=${2:-} archives mirror
  # "URI SUITE COMPONENT" of Debian's own archives.
  archives=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Component: main' |
    grep --extended-regexp ' bookworm(-updates|-security)? ')
  mirror=$(sed -n 's/ bookworm main$//p' <<<"$archives" | head -1)
  if [[ ! -s $root/etc/apt/sources.list || ! -x $root/usr/bin/apt-get ]]; then
    debootstrap --variant=minbase ${packages:+--include="$packages"} bookworm "$root" "$mirror" >"$root.debootstrap.log"
  fi
  sed 's/^/deb /' <<<"$archives" >"$root/etc/apt/sources.list"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
}

# in_bare_debian ROOT COMMANDS  Runs them there by bash, which ends at the first that fails.
in_bare_debian() {
  chroot "$1" env -i HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    bash -euo pipefail -c "$2"
}
