#!/usr/bin/env bash
# Formats the C++ files given, or all tracked ones; with --check only names those that are not formatted.
set -euo pipefail
cd "$(dirname "$0")/.."

how=(-i)
if [[ ${1:-} == --check ]]; then
  how=(--dry-run --Werror)
  shift
fi
[[ $# -gt 0 ]] || mapfile -t files < <(git ls-files '*.cpp' '*.hpp')
clang-format "${how[@]}" "${@:-${files[@]}}"
