#!/bin/sh
# The same bytes for 1, 2, 3 and 8 threads and for repeated runs: a shipped scene.
#   threads_test.sh CLEAVE_SIMULATE
set -u
simulate=$1
work=$(mktemp -d) && cd "$work" || exit 1
trap 'rm -rf "$work"' EXIT
runs=0 files=0 failures=0

fail() { failures=$((failures + 1)); echo "FAILED: $*"; }

# Everything but times and what describes the machine.
outputs() { (cd "$1" && find . -type f ! -name timings.json ! -name provenance.json ! -path './meshes/*' | sort); }

# same FIRST OTHER WHAT: the same files, byte by byte.
same() {
  outputs "$1" >first.list; outputs "$2" >other.list
  cmp -s first.list other.list || { fail "$3: other files"; return; }
  while read -r file; do
    files=$((files + 1))
    cmp -s "$1/$file" "$2/$file" || fail "$3: $file"
  done <first.list
}

# for_all_threads NAME COMMAND...: runs it with --threads and --out, twice each, against the first.
for_all_threads() {
  name=$1; shift
  for threads in 1 2 3 8; do
    for round in a b; do
      runs=$((runs + 1))
      "$@" --threads $threads --out "$name-$threads$round" >log 2>&1 || { cat log; fail "$name, $threads threads: exit code $?"; }
      same "$name-1a" "$name-$threads$round" "$name, $threads threads, run $round"
    done
  done
  [ -n "$(outputs "$name-1a")" ] || fail "$name: nothing written"
}

# The window breaks within the first frames.
for_all_threads scene "$simulate" glass_small_ball --frames 4 --set checkpoint_every=2
grep -q '"fractures": 0' scene-1a/statistics.json && fail "the window does not break"

# Twins: another scene does not have the same bytes.
"$simulate" glass_small_ball --frames 4 --set checkpoint_every=2 --set 'fracture.slowest_impact="1.5 m/s"' --threads 2 --out twin >log 2>&1
cmp -s scene-1a/checkpoint-00004.cleave twin/checkpoint-00004.cleave && fail "another scene has the same bytes"

echo "counts: $runs runs, $files files compared, $failures differ"
[ $failures = 0 ]
