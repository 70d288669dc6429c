#!/bin/sh
# The tests of solver/ and validation/ under the sanitizers, then a scene under valgrind's memcheck; before, each tool has to report seeded faults.
#   sanitizers.sh BUILDS JOBS [PATTERN]    BUILDS holds asan, tsan and release, built (checked_tests; of release cleave-simulate, sanitizer_twin);
#                                          PATTERN (a basic regular expression) chooses among the test programs
# Exit code 1 for any finding, any failed test, or a fault that went unreported.
set -u
here=$(cd "$(dirname "$0")" && pwd)
scene=pot_adaptive frames=14  # the pot lands and breaks in frame 11

ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1
UBSAN_OPTIONS=print_stacktrace=1
TSAN_OPTIONS=suppressions=$here/thread.supp:second_deadlock_stack=1:halt_on_error=0:exitcode=66
LSAN_OPTIONS=suppressions=$here/leak.supp:print_suppressions=0
findings='ERROR: AddressSanitizer|ERROR: LeakSanitizer|runtime error: |WARNING: ThreadSanitizer|ThreadSanitizer: CHECK failed'

# count PATTERN FILE...: the lines that match, in all files together.
count() { pattern=$1; shift; cat "$@" /dev/null 2>/dev/null | grep -cE "$pattern"; }

# one PROGRAM FOLDER: runs a test program, prints "tests errors exit-code name" (and nothing else). Reports of processes that it starts count as well.
one() {
  name=$(basename "$1") folder=$2
  log=$folder/$name
  for tool in ASAN UBSAN TSAN LSAN; do eval "export ${tool}_OPTIONS=\"\$${tool}_OPTIONS:log_path=\$log.report\""; done
  timeout 3000 "$1" --gtest_brief=1 >"$log.out" 2>&1
  code=$?
  tests=$(sed -n 's/^\[==========\] \([0-9]*\) tests\{0,1\} from.*/\1/p' "$log.out" | tail -n 1)
  errors=$(count "$findings" "$log.out" "$log".report.*)
  echo "${tests:-0} $errors $code $name"
}
if [ "$1" = --one ]; then one "$2" "$3"; exit 0; fi

builds=$1 jobs=$2 pattern=${3:-.}
work=$builds/sanitizers failures=0 summary=
rm -rf "$work" && mkdir -p "$work" || exit 3
fail() { failures=$((failures + 1)); echo "FAILED: $*"; }

# twin WORDS FAULT COMMAND...: the fault must be reported in these words, and the exit code not be 0.
twin() {
  words=$1 fault=$2; shift 2
  if "$@" "$fault" >"$work/twin" 2>&1; then fail "$fault: not reported"; return; fi
  grep -qF "$words" "$work/twin" || { fail "$fault: not reported as '$words'"; tail -n 5 "$work/twin"; }
}

# run_tests PRESET TITLE: all test programs of this build.
run_tests() {
  folder=$work/$1
  mkdir -p "$folder"
  export ASAN_OPTIONS UBSAN_OPTIONS TSAN_OPTIONS LSAN_OPTIONS
  grep -- "$pattern" "$builds/$1/checked_tests.txt" | xargs -P "$jobs" -I{} "$here/sanitizers.sh" --one {} "$folder" | tee "$folder/table" |
    awk -v title="$2" '{ printf "%s: %s: %d tests, %d errors%s\n", title, $4, $1, $2, $3 ? ", exit code " $3 : "" }'
  awk '$2 > 0 || $3 != 0 || $1 == 0 { exit 1 }' "$folder/table" || {
    fail "$2: see $folder"
    grep -hE "$findings|^\[  FAILED  \]" "$folder"/*.out "$folder"/*.report.* 2>/dev/null | sort | uniq -c | sort -rn | head -n 20
  }
  summary="$summary$2: $(awk '{ tests += $1; errors += $2 } END { printf "%d tests in %d programs, %d errors", tests, NR, errors }' "$folder/table"); "
}

run_valgrind() {
  simulate=$builds/release/solver/simulation/cleave-simulate
  set -- "$scene" --frames $frames --threads 2
  # Once without valgrind, which leaves the mesh that NETGEN made.
  "$simulate" "$@" --out "$work/native" >"$work/native.log" 2>&1 || { cat "$work/native.log"; fail "the scene"; }
  valgrind --quiet --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite --error-exitcode=9 --fair-sched=yes \
    --suppressions="$here/valgrind.supp" --log-file="$work/valgrind.log" "$simulate" "$@" --out "$work/checked" >"$work/checked.log" 2>&1 ||
    { head -n 40 "$work/valgrind.log"; tail -n 5 "$work/checked.log"; fail "valgrind: see $work/valgrind.log"; }
  grep -q '"fractures": [1-9]' "$work/checked/statistics.json" || fail "nothing broke in the scene"
  cmp -s "$work/native/statistics.json" "$work/checked/statistics.json" || fail "valgrind gives another result"
  errors=$(grep -cE '^==[0-9]+== [A-Z0-9]' "$work/valgrind.log")
  summary="${summary}valgrind: $scene, $frames frames, $errors errors"
}

twins=0
for row in asan:heap_overflow:heap-buffer-overflow 'asan:signed_overflow:signed integer overflow' 'asan:float_overflow:outside the range' \
  'asan:leak:detected memory leaks' 'tsan:data_race:data race' 'tsan:loop_race:data race'; do
  fault=${row#*:}
  twin "${fault#*:}" "${fault%%:*}" "$builds/${row%%:*}/sanitizer_twin"
  twins=$((twins + 1))
done
for row in 'heap_overflow:Invalid read' 'uninitialised:depends on uninitialised'; do
  twin "${row#*:}" "${row%%:*}" valgrind --error-exitcode=9 "$builds/release/sanitizer_twin"
  twins=$((twins + 1))
done
for command in "$builds/asan/sanitizer_twin" "$builds/tsan/sanitizer_twin"; do
  "$command" none >"$work/twin" 2>&1 || { cat "$work/twin"; fail "$command reports a fault where none is"; }
done
[ $failures = 0 ] || exit 1
echo "$twins seeded faults, all reported"

run_tests asan "address, undefined"
run_tests tsan thread
run_valgrind
echo "$summary"
[ $failures = 0 ]
