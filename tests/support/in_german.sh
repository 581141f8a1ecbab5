#!/bin/bash
# Runs a command where numbers have a comma, in a German locale that is made for it. Exit code 77, which ctest takes for
# skipped, where Debian's package locales is missing.
# Usage: in_german.sh COMMAND [ARGUMENT…]
set -eu
[ -e /usr/share/i18n/locales/de_DE ] || { echo "the package locales is missing"; exit 77; }
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
localedef --inputfile de_DE --charmap UTF-8 "$folder/de_DE.UTF-8"
in_german() { env LOCPATH="$folder" LC_ALL=de_DE.UTF-8 "$@"; }
[ "$(in_german bash -c 'printf %.1f 0,5')" = 0,5 ] || { echo "the German locale has no comma"; exit 1; }
in_german "$@"
