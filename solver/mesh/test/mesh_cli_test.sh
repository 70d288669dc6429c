#!/bin/sh
# cleave mesh as a user meets it: exit codes, one line per mistake, nothing half-written, the same bytes twice.
#   mesh_cli_test.sh CLEAVE_MESH FOLDER
set -u
. "$(dirname "$0")/../../input/test/cli_expect.sh"
mesh=$1 work=$2
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
left='out.*'

cat >tet.obj <<'END'
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
END
sed '$d' tet.obj >open.obj
cat >scene.toml <<'END'
[[body]]
surface = { file = "tet.obj", particles = 300 }
material = "glass"
[[body]]
surface = { file = "tet.obj", particles = 300 }
material = "porcelain"
END
sed '0,/300/s//400/' scene.toml >two.toml
sed 's/particles = 300/particles = 0/' scene.toml >none.toml

expect 'no arguments' 2 'cleave mesh SCENE|RECIPE|FILE --out' "$mesh"
expect 'help' 0 '--mesher' "$mesh" --help
expect 'no such source' 2 'a recipe (pot, window, pet, tai_chi)' "$mesh" teapot --out out.msh
expect 'unknown ending of --out' 2 '.msh, .mesh or .vtu' "$mesh" tet.obj --out out.step
expect 'unknown mesher' 2 'netgen' "$mesh" tet.obj --out out.msh --mesher tetgen
expect 'count of nought' 2 '--count' "$mesh" tet.obj --out out.msh --count 0
expect 'open surface' 2 'open.obj: edge from vertex 2 to 3: expected a closed surface' "$mesh" open.obj --out out.msh
expect 'count out of reach' 2 'more than 2 % off' "$mesh" tet.obj --out out.msh --mesher gmsh --count 5000
expect 'bodies of two kinds' 2 'bodies made alike' "$mesh" two.toml --out out.msh
expect 'bad scene' 2 'particles: expected 1 to' "$mesh" none.toml --out out.msh
expect 'folder without rights' 3 'cannot be written' "$mesh" tet.obj --mesher gmsh --count 1 --out /proc/out.msh
expect 'surface' 0 'tets ' "$mesh" tet.obj --out one.msh --count 300
expect 'scene' 0 'asked for: 300' "$mesh" scene.toml --out two.msh
cmp one.msh two.msh || fail 'two runs: other bytes'
expect 'as JSON' 0 '"schema": "cleave.mesh/1"' "$mesh" one.msh --json --out three.vtu
expect 'back from .vtu' 0 'region 1' "$mesh" three.vtu --out four.mesh
expect 'back from .mesh' 0 'volume              0.166666667 m^3' "$mesh" four.mesh --out five.msh
expect 'tets have their count' 2 'these are tets already' "$mesh" one.msh --out out.msh --count 100
ls ./*.part* >/dev/null 2>&1 && fail 'a part of a file was left'

echo "$checks checks, $failures failures"
[ $failures = 0 ]
