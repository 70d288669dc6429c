#!/bin/sh
# The program as a user meets it: exit codes, one line per mistake, nothing half-written, the same bytes twice.
#   cli_test.sh CLEAVE_VALIDATE CLEAVE_MATERIAL SCHEMA README FOLDER
set -u
. "$(dirname "$0")/../../solver/input/test/cli_expect.sh"
validate=$1 material=$2 schema=$3 readme=$4 work=$5
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
left='bad'

cat >good.toml <<'EOF'
name = "good"
tier = "verification"
about = "small patch"
[geometry]
shape = "block"
extent = ["1 m", "1 m", "1 m"]
[material]
engineering = { E = "70 GPa", nu = 0.25 }
[load]
displacement = [{ on = "all", solution = "linear_displacement" }]
[ladder]
quick = [0.6]
[[check]]
quantity = "stress"
component = "xx"
at = [["0.5 m", "0.5 m", "0.5 m"]]
solver = ["fem.p1"]
reference = { solution = "linear_displacement" }
band = { relative = 1e-9 }
basis = "exact"
EOF
sed 's/reference = .*/reference = { value = "1 Pa", source = "a wrong number" }/; s/^name.*/name = "wrong"/' good.toml >wrong.toml
sed 's/shape = "block"/shpae = "block"/' good.toml >misspelt.toml
sed 's/"1 m", "1 m", "1 m"/"1 m", "1 m", "1 K"/' good.toml >unit.toml
sed 's/"block"/"torus"/' good.toml >shape.toml
sed 's/engineering.*/stiffness = { unit = "GPa", voigt = [[1,2,0,0,0,0],[2,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]] }/' good.toml >indefinite.toml
sed 's/^shape.*/mesh = "inverted.msh"/; /^extent/d' good.toml >inverted.toml
printf '[geometry\n' >syntax.toml
cat >inverted.msh <<'EOF'
$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
5
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
5 1 1 1
$EndNodes
$Elements
2
1 4 2 1 1 1 2 3 4
2 4 2 1 1 2 3 4 5
$EndElements
EOF
# the second tet as written is positive; swapped it is inverted
sed -i 's/^2 4 2 1 1 2 3 4 5/2 4 2 1 1 3 2 4 5/' inverted.msh
sed 's/^\[geometry\]//; /^shape/d; /^extent/d' good.toml >nogeometry.toml
printf 'stiffness = { unit = "GPa", voigt = [[1,2,0,0,0,0],[2,1,0,0,0,0],[0,0,1,0,0,0],[0,0,0,1,0,0],[0,0,0,0,1,0],[0,0,0,0,0,1]] }\n' >indefinite_material.toml
cat >M.toml <<'EOF'
name = "M"
engineering = { E1 = "181 GPa", E2 = "10.3 GPa", E3 = "10.3 GPa", G23 = "3.503401360544218 GPa", G13 = "7.17 GPa", G12 = "7.17 GPa", nu12 = 0.28, nu13 = 0.28, nu23 = 0.47 }
EOF

expect "a right case" 0 "1 passed, 0 failed" "$validate" good.toml --out good
expect "a wrong reference value" 1 "0 passed, 1 failed" "$validate" wrong.toml --out wrong
expect "a misspelt key" 2 "shpae" "$validate" misspelt.toml --out bad
expect "a wrong unit" 2 "unit.toml:6: geometry.extent" "$validate" unit.toml --out bad
expect "an unknown shape" 2 "torus" "$validate" shape.toml --out bad
expect "a stiffness that is not positive definite" 2 "indefinite.toml" "$validate" indefinite.toml --out bad
expect "an inverted tet" 2 "inverted.msh" "$validate" inverted.toml --out bad
expect "broken TOML" 2 "syntax.toml:1" "$validate" syntax.toml --out bad
expect "a missing table" 2 "geometry" "$validate" nogeometry.toml --out bad
expect "a missing file" 2 "none.toml" "$validate" none.toml --out bad
expect "an unknown case" 2 "no_such_case" "$validate" no_such_case --out bad
expect "an unknown option" 2 "--frobnicate" "$validate" --frobnicate
expect "a broken shard" 2 "--shard" "$validate" good.toml --shard 3/2 --out bad
expect "a good file and a bad one" 2 "misspelt.toml" "$validate" good.toml misspelt.toml --out bad
expect "an unwritable folder" 3 "/proc" "$validate" good.toml --out /proc/cleave
expect "the list" 0 "hole_orthotropic" "$validate" --list
expect "a material by file" 0 "16.737" "$material" M.toml
expect "a material by file, as JSON" 0 "16.737" "$material" M.toml --json
expect "a material that is not positive definite" 2 "indefinite_material.toml" "$material" indefinite_material.toml --json
expect "an unknown material" 2 "unobtainium" "$material" unobtainium

# The README's examples work as they stand there: cases of every kind and materials. (Its scene has a test of its own.)
awk '/^```toml/ { file = "readme_" ++n ".toml"; next } /^```csv/ { file = "tensors.csv"; next } /^```/ { file = "" } file { print > file }' "$readme"
kinds=0
for example in readme_*.toml; do
  if grep -q '^tier' "$example"; then
    kinds=$((kinds + 1))
    expect "the README's case $example" 0 " 0 failed" "$validate" "$example" --out readme
  elif ! grep -q '^\[\[body\]\]' "$example"; then
    expect "the README's material $example" 0 "Young's modulus" "$material" "$example"
  fi
done
[ $kinds -ge 4 ] || fail "cases of the README are missing"

[ -e bad ] && fail "bad input left something behind: $(ls bad)"

expect "a second run" 0 "rows unchanged" "$validate" good.toml --out again --compare good/results.json
cmp -s good/results.json again/results.json || fail "two runs differ"

# Any number of threads gives the same bytes: particles, finite elements and a study.
threaded='patch_triclinic equilibrium_laminate contact_half_space fem_manufactured'
for threads in 1 2 3 8; do
  # shellcheck disable=SC2086
  expect "cases by $threads threads" 0 " 0 failed" "$validate" $threaded --threads $threads --out "by$threads"
  cmp -s by1/results.json "by$threads/results.json" || fail "1 and $threads threads give different numbers"
done
expect "no threads" 2 "--threads" "$validate" good.toml --threads 0 --out bad

# The results follow their schema; a broken one does not.
check_schema() {
  python3 - "$schema" "$1" <<'EOF'
import json, sys
import jsonschema
try:
    jsonschema.validate(json.load(open(sys.argv[2])), json.load(open(sys.argv[1])))
except jsonschema.ValidationError as error:
    sys.exit("schema: " + error.message)
EOF
}
check_schema good/results.json || fail "results.json against its schema"
sed 's/"verdict": "pass"/"verdict": "perhaps"/' good/results.json >broken.json
check_schema broken.json 2>/dev/null && fail "the schema accepts a broken file"

echo "$((checks + 3 - failures)) passed, $failures failed"
[ $failures = 0 ]
