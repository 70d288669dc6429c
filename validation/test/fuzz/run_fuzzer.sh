#!/bin/sh
# One fuzzer for CLEAVE_FUZZ_SECONDS (60) from its seeds, the kept regression inputs and the corpus of earlier runs, within 2 GB and 10 s an
# input. Ends with its counts, on one line; the input that broke a promise lies in WORK/finds.
#   run_fuzzer.sh PROGRAM REGRESSIONS WORK
set -u
program=$1 regressions=$2 work=$3
name=${program##*/fuzz_}
seconds=${CLEAVE_FUZZ_SECONDS:-60}
rm -rf "$work/seeds" "$work/finds"
mkdir -p "$work/corpus" "$work/seeds" "$work/finds" || exit 3
CLEAVE_FUZZ_SEEDS=$work/seeds "$program" || exit 3
[ -d "$regressions" ] || regressions=
# Files are written and read again for each input: in memory, where the system has such a folder.
[ -n "${TMPDIR:-}" ] || [ ! -w /dev/shm ] || TMPDIR=/dev/shm
export TMPDIR
"$program" "$work/corpus" "$work/seeds" ${regressions:+"$regressions"} -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -seed=1 \
  -print_final_stats=1 -artifact_prefix="$work/finds/" >"$work/log" 2>&1
code=$?
tried=$(sed -n 's/^stat::number_of_executed_units: *//p' "$work/log" | tail -n 1)
split=$(sed -n 's/^cleave: //p' "$work/log" | tail -n 1)
covered=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$work/log" | tail -n 1)
survivors=$(find "$work/finds" -type f ! -name 'slow-unit-*' | wc -l)
[ $code = 0 ] || [ "$survivors" -gt 0 ] || survivors=1
printf 'counts: fuzz %-12s %9s inputs tried in %s s (%s), %s branches seen, %s survivors\n' \
  "$name" "${tried:-?}" "$seconds" "${split:-not counted}" "${covered:-?}" "$survivors"
[ $code = 0 ] && [ "${tried:-0}" -gt 0 ] && exit 0
grep -m 1 -A 25 -e 'ERROR: ' -e 'terminate called' -e 'runtime error' "$work/log"
find "$work/finds" -type f
exit 1
