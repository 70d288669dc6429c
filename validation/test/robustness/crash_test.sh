#!/bin/sh
# kill -9 at random moments (seeded) of a scene and of a study; what was left must lead to the bytes of an uninterrupted run.
#   crash_test.sh CLEAVE_SIMULATE CLEAVE_VALIDATE KILLS
set -u
simulate=$1 validate=$2 kills=$3
work=$(mktemp -d) && cd "$work" || exit 1
trap 'rm -rf "$work"' EXIT
killed=0 finished=0 restarted=0 repeated=0 failures=0

fail() { failures=$((failures + 1)); echo "FAILED: $*"; }

# The sums of all files but those that hold times; a write that the kill cut short (.part) is no result.
sums() { (cd "$1" && find . -type f ! -name timings.json ! -name provenance.json ! -name '*.part*' | sort | xargs cksum); }

# run_and_kill SECONDS COMMAND...: starts it, kills it then, unless it has finished.
run_and_kill() {
  seconds=$1; shift
  "$@" >log 2>&1 &
  child=$!
  sleep "$seconds"
  if kill -9 "$child" 2>/dev/null; then killed=$((killed + 1)); else finished=$((finished + 1)); fi
  wait "$child" 2>/dev/null
}

# moment I SECONDS: a time up to SECONDS, the same in every run of this test.
moment() { awk -v seed="$1" -v most="$2" 'BEGIN { srand(seed); rand(); printf "%.3f", rand() * most }'; }

now() { date +%s.%N; }

cat >cube.msh <<'EOF'
$MeshFormat
2.2 0 8
$EndMeshFormat
EOF
# 3 x 3 x 3 cubes of six tets each (Kuhn), 8 cm wide.
awk 'BEGIN {
  n = 3; m = n + 1; h = 0.08 / n
  print "$Nodes"; print m * m * m
  for (z = 0; z < m; ++z) for (y = 0; y < m; ++y) for (x = 0; x < m; ++x) print 1 + (z * m + y) * m + x, x * h, y * h, z * h
  print "$EndNodes"; print "$Elements"; print 6 * n * n * n
  split("1 2 3 1 3 2 2 1 3 2 3 1 3 1 2 3 2 1", o, " "); s[1] = 1; s[2] = m; s[3] = m * m
  split("1 -1 -1 1 1 -1", sign, " ")
  for (z = 0; z < n; ++z) for (y = 0; y < n; ++y) for (x = 0; x < n; ++x) for (k = 0; k < 6; ++k) {
    a = 1 + (z * m + y) * m + x; b = a + s[o[3 * k + 1]]; c = b + s[o[3 * k + 2]]; d = c + s[o[3 * k + 3]]
    if (sign[k + 1] > 0) print ++i, 4, 2, 1, 1, a, b, c, d; else print ++i, 4, 2, 1, 1, a, c, b, d
  }
  print "$EndElements"
}' >>cube.msh
cat >scene.toml <<'EOF'
name = "crash"
frames = 60
checkpoint_every = 5
travel = "2 mm"
[ground]
[[body]]
mesh = "cube.msh"
material = "soda-lime glass"
strength = "5 MPa"
groups = 6
position = ["0 m", "0 m", "0.08 m"]
rotation = [{ axis = [1, 0, 0], angle = "40 deg" }, { axis = [0, 1, 0], angle = "30 deg" }]
velocity = ["0.3 m/s", "0 m/s", "-3 m/s"]
[analysis]
grouping = "k_means"
[fracture]
debris_below = "1 g"
EOF

start=$(now)
"$simulate" scene.toml --out whole >log 2>&1 || { cat log; fail "the uninterrupted scene"; }
length=$(awk -v a="$start" -v b="$(now)" 'BEGIN { print b - a }')
sums whole >whole.sums
i=0
while [ $i -lt "$kills" ]; do
  i=$((i + 1))
  rm -rf out
  run_and_kill "$(moment $i "$length")" "$simulate" scene.toml --out out
  last=$(ls out/checkpoint-*.cleave 2>/dev/null | tail -n 1)
  [ -n "$last" ] && restarted=$((restarted + 1))
  "$simulate" scene.toml --out out ${last:+--restart "$last"} >log 2>&1 || { cat log; fail "scene, kill $i: the restart"; }
  sums out >out.sums
  cmp -s whole.sums out.sums || fail "scene, kill $i: other bytes than the uninterrupted run ($(diff whole.sums out.sums | grep -c '^[<>]') files)"
done

# A study of five cases, finished ones reused.
for n in 1 2 3 4 5; do
  cat >case_$n.toml <<EOF
name = "case_$n"
tier = "verification"
about = "a patch"
[geometry]
shape = "block"
extent = ["1 m", "1 m", "0.${n} m"]
[material]
engineering = { E = "70 GPa", nu = 0.25 }
[load]
displacement = [{ on = "all", solution = "linear_displacement" }]
[ladder]
quick = [0.3]
[[check]]
quantity = "stress"
at = [["0.5 m", "0.5 m", "0.05 m"]]
solver = ["fem.p2"]
reference = { solution = "linear_displacement" }
band = { relative = 1e-9 }
basis = "exact"
EOF
done
start=$(now)
"$validate" case_*.toml --reuse --jobs 2 --out study >log 2>&1 || { cat log; fail "the uninterrupted study"; }
length=$(awk -v a="$start" -v b="$(now)" 'BEGIN { print b - a }')
i=0
while [ $i -lt "$kills" ]; do
  i=$((i + 1))
  rm -rf out
  run_and_kill "$(moment $((1000 + i)) "$length")" "$validate" case_*.toml --reuse --jobs 2 --out out
  done_before=$(ls out/cases/*.json 2>/dev/null | wc -l)
  "$validate" case_*.toml --reuse --jobs 2 --out out >log 2>&1 || { cat log; fail "study, kill $i: the second run"; }
  again=$(grep -c ' size 0.3' log)
  [ "$again" -le $((5 - done_before)) ] || repeated=$((repeated + again - 5 + done_before))
  cmp -s study/results.json out/results.json || { diff study/results.json out/results.json | head -n 6; fail "study, kill $i: another results.json"; }
done
[ $repeated = 0 ] || fail "$repeated finished cases were run again"

echo "counts: $((2 * kills)) runs, $killed killed (the others had finished), $restarted restarts from a checkpoint, $repeated finished cases repeated, $failures failures"
[ $failures = 0 ] && [ $killed -gt 0 ] && { [ $restarted -gt 0 ] || [ "$kills" -lt 20 ]; }  # few kills may all come before a checkpoint
