#!/bin/sh
# Installs what is built and uses it as a stranger would: bin/cleave without the source tree, and a program that finds the package.
#   package_test.sh BUILD SOURCE FOLDER
set -u
build=$1 source=$2 work=$3
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
fail() { echo "FAILED: $*"; exit 1; }

cmake --install "$build" --prefix "$work/prefix" >install.log 2>&1 || { tail -n 5 install.log; fail "cmake --install"; }
cleave=$work/prefix/bin/cleave
"$cleave" material silicon | grep -q cubic || fail "bin/cleave material"
"$cleave" validate patch_triclinic --out validated >validated.log 2>&1 || { tail -n 5 validated.log; fail "bin/cleave validate"; }
"$cleave" report --from validated --out reported >reported.log 2>&1 || { tail -n 5 reported.log; fail "bin/cleave report --from"; }
[ -s reported/index.html ] || fail "no index.html"
"$cleave" test >test.log 2>&1; [ $? = 2 ] || fail "bin/cleave test: there are no tests outside the source tree"

cmake -G Ninja -S "$source/solver/test/outside" -B outside -D CMAKE_PREFIX_PATH="$work/prefix" -D CMAKE_BUILD_TYPE=Release >configure.log 2>&1 ||
  { tail -n 15 configure.log; fail "find_package(cleave)"; }
cmake --build outside >build.log 2>&1 || { tail -n 15 build.log; fail "the outside program does not build"; }
grep -rlq "$source" prefix/lib/cmake prefix/bin/cleave && fail "the package names the source tree"

# Silicon stretched by 0.1 % along [100]: C11, C12, C12 times the strain, exact for the corrected operator.
mesh=$(ls validated/meshes/*.msh | head -n 1)
answer=$(./outside/strain_a_mesh "$mesh") || fail "the outside program"
echo "$answer"
echo "$answer" | awk '{ for (i = 1; i <= NF; ++i) if ($i == "stress") { a = $(i+1); b = $(i+2); c = $(i+3) } }
  END { exit !(a > 165.69 && a < 165.71 && b > 63.89 && b < 63.91 && c > 63.89 && c < 63.91) }' || fail "not C11, C12, C12 times the strain"
# The twin: a stretch of 0.1 % in steel would be another answer; the same bounds refuse it.
echo "x stress 269.2 115.4 115.4" | awk '{ exit !($3 > 165.69 && $3 < 165.71) }' && fail "the bounds accept steel"
echo "package in order"
