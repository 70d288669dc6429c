#!/bin/sh
# A real scene, the falling pot of Fig. 7: 1, 2 and 4 threads give the same bytes, and so does a restart from every checkpoint.
#   scene_bytes.sh CLEAVE_SIMULATE FOLDER
set -u
simulate=$1 work=$2
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
failures=0

run() {
  "$simulate" pot_adaptive --frames 40 --set checkpoint_every=5 --set 'output={ vtu_every = 5 }' "$@" >/dev/null 2>&1 ||
    { echo "FAILED: exit code $? of $*"; exit 1; }
}
# same FIRST OTHER WHAT: every file of OTHER but its timings is in FIRST, byte by byte.
same() {
  (cd "$2" && find . -type f ! -name timings.json) | while read -r file; do
    cmp -s "$1/$file" "$2/$file" || echo "$file"
  done >differs
  [ -s differs ] || return 0
  failures=$((failures + 1)); echo "FAILED $3: $(tr '\n' ' ' <differs)"
}

for threads in 1 2 4; do run --threads $threads --out by$threads; done
grep -q '"fractures": 0' by1/statistics.json && { failures=1; echo "FAILED: the pot does not break"; }
same by1 by2 "2 threads"
same by1 by4 "4 threads"
for frame in 05 10 15 20 25 30 35 40; do
  run --restart by1/checkpoint-000$frame.cleave --out from$frame
  same by1 from$frame "a restart at frame $frame"
done
run --set 'fracture.slowest_impact="1.5 m/s"' --out twin   # the comparison can fail
cmp -s by1/statistics.json twin/statistics.json && { failures=1; echo "FAILED: another scene has the same bytes"; }
"$simulate" --table by1 | grep -qE '^pot_adaptive .* / 6163 .* / 15717 .* / 1081 ' || { failures=1; echo "FAILED: the paper's columns are not in the table"; }
rm -rf by2 by4 from* twin
[ $failures = 0 ] && echo "the same bytes"
