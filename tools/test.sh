#!/usr/bin/env bash
# Sets the machine up, builds Talus with its tests and runs them.
# Usage: tools/test.sh [--long] [ctest arguments]        --long: the tests labelled long too, which take minutes each
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/set_up.sh"

which=(--label-exclude '^long$')
if [[ ${1:-} == --long ]]; then
  which=()
  shift
fi

install_packages
configure
build
ctest --test-dir "$build" --output-on-failure --parallel "$jobs" "${which[@]}" "$@"
