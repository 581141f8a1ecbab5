# Sourced by run.sh and test.sh: goes to the source folder, installs what is missing, configures a Release build.

cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/release
jobs=${TALUS_JOBS:-$(nproc)}
# A step's matrices are too small for BLAS threads to pay.
export OPENBLAS_NUM_THREADS=${OPENBLAS_NUM_THREADS:-1}

# The names in packages.txt, without comments.
listed_packages() { sed 's/#.*//' tools/packages.txt | xargs -n1; }

missing_packages() {
  local installed
  installed=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p')
  listed_packages | grep --line-regexp --fixed-strings --invert-match "$installed" || true
}

install_packages() {
  local missing as_root=()
  if ! command -v dpkg-query >/dev/null; then
    echo "tools/set_up.sh: this is not Debian; install what tools/packages.txt names by hand" >&2
    return 2
  fi
  missing=$(missing_packages | xargs)
  [[ -z $missing ]] && return
  if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      echo "Talus needs these Debian packages to build and run:" >&2
      echo "  $missing" >&2
      echo "Only root may install them, and there is no sudo here; as root:" >&2
      echo "  apt-get install --no-install-recommends $missing" >&2
      return 2
    fi
    as_root=(sudo)
  fi
  echo "Installing what Talus needs to build and run: $missing"
  "${as_root[@]}" apt-get -qq update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install --yes --no-install-recommends $missing >/dev/null
}

# Configures build/release once; ninja does so again by itself when a CMake file changes.
configure() {
  [[ -f $build/build.ninja ]] || cmake --preset release
}

# build [TARGET...]
build() {
  cmake --build "$build" --parallel "$jobs" ${1:+--target "$@"}
}
