#!/bin/sh
# Looks at a report page in headless Chromium, as a reader would:
#   check_page.sh INDEX.html [--results RESULTS.json] [--axe AXE.min.js] [--out FOLDER]   exit 0: drawn and complete, 1: something is wrong with it
#   check_page.sh --twins INDEX.html [--axe AXE.min.js] --out FOLDER                  damages the page in many ways; each must be caught
# With --axe, axe-core must find no serious violation. CHROMIUM and NODE name the programs where they are not on the path. Exit 2: usage, 3: a program is missing.
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd) || exit 3

find_program() {
  for name in "$@"; do
    [ -n "$name" ] && command -v "$name" && return 0
  done
  echo "check_page: none of these programs is here: $*" >&2
  return 1
}

node=$(find_program "${NODE:-}" node nodejs) || exit 3
CHROMIUM=$(find_program "${CHROMIUM:-}" chromium chromium-browser google-chrome) || exit 3
export CHROMIUM
exec "$node" "$here/check_page.mjs" "$@"
