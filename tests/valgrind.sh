#!/usr/bin/env bash
# Starts and ends both programs below valgrind: nothing may be read that was not written, or was given back; of
# talus-cli nothing may be lost either.
# Usage: tests/valgrind.sh BUILD_FOLDER      apt install valgrind; takes two to five minutes
# What libraries do is named in tests/support/valgrind.supp; Qt's compiled regular expressions are switched off, for
# valgrind does not know what they read.
set -euo pipefail
build=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export QT_QPA_PLATFORM=offscreen QT_ENABLE_REGEXP_JIT=0 XDG_RUNTIME_DIR=$folder
cp ../samples/free_fall/free_fall.talus "$folder"
failed=0

clean() {
  local log=$folder/log
  if valgrind -q --error-exitcode=9 --suppressions=support/valgrind.supp --num-callers=20 --log-file="$log" "$@" \
    >"$folder/out" 2>&1; then
    echo "clean: ${*: -3}"
  else
    echo "not clean: $*" && head -40 "$log"
    failed=1
  fi
}

leaks=(--leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite)
clean "${leaks[@]}" "$build/app/talus-cli" --version
clean "${leaks[@]}" "$build/app/talus-cli" info "$folder/free_fall.talus"
clean "${leaks[@]}" "$build/app/talus-cli" solve "$folder/free_fall.talus" --quiet
clean "${leaks[@]}" "$build/app/talus-cli" info "$folder/free_fall.results"
clean "$build/app/talus" --version
clean "$build/app/talus" --screenshot "$folder/window.png" --size 640x480
exit $failed
