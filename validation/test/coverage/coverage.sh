#!/bin/sh
# Runs the fast tests of solver/ and validation/ in a build by preset coverage and prints which lines ran.
#   coverage.sh SOURCE BUILD JOBS
set -u
source=$1 build=$2 jobs=$3
here=$(dirname "$0")
find "$build" -name '*.gcda' -delete
xargs -P "$jobs" -I{} sh -c '"$1" --gtest_brief=1 >"$1.log" 2>&1 || { echo "FAILED: $1"; tail -n 20 "$1.log"; exit 1; }' sh {} <"$build/checked_tests.txt" || exit 1
"$here/coverage.py" "$source" "$build"
