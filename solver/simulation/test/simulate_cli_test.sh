#!/bin/sh
# cleave simulate as a user meets it: exit codes, one line per mistake, nothing half-written; README's own scene, its restart and its table.
#   simulate_cli_test.sh CLEAVE_SIMULATE README FOLDER
set -u
. "$(dirname "$0")/../../input/test/cli_expect.sh"
simulate=$1 readme=$2 work=$3
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1
left='bad/statistics.json'

# README's example: files by the name in their first line, and the commands.
awk '/^```toml/ { block = 1; next } /^```/ { block = 0; file = "" } block == 1 { block = 2; if ($0 ~ /^# [a-z]+\.toml/) file = substr($0, 3) }
     block && file { print > file }' "$readme"
awk '/^```sh/ { block = 1; text = ""; next } /^```/ { if (block && text ~ /wedge\.toml/) printf "%s", text; block = 0 } block { text = text $0 "\n" }' "$readme" >commands.sh
[ -s wedge.toml ] && [ -s marble.toml ] && [ -s commands.sh ] || fail "README has no scene of its own"
mkdir bin && printf '#!/bin/sh\nverb=$1; shift; [ "$verb" = simulate ] && exec "%s" "$@"\nexit 99\n' "$simulate" >cleave && chmod +x cleave
expect "README's scene" 0 "physical particles" sh -e commands.sh
[ -s out/wedge/surface.glb ] && [ -s out/wedge/frames.pvd ] || fail "README's scene left no animation"
grep -q '"fractures": 0' out/wedge/statistics.json && fail "README's scene does not break"
expect "the table" 0 "wedge" "$simulate" --table out/wedge
grep -qE '^wedge +b ' stdout || fail "debris as the scene says is no run b"
expect "all fragments dynamic" 0 "debris among them                0 " "$simulate" wedge.toml --frames 20 --all-dynamic --out dynamic
"$simulate" --table dynamic out/wedge >table && grep -qE '^wedge +a ' table && grep -qE '^wedge +b ' table || fail "the table tells the runs apart"

run() { "$simulate" wedge.toml --frames 30 "$@" >/dev/null 2>&1; }
same() { for name in statistics.json surface.glb frames.pvd frames/00030.vtu; do cmp -s "$1/$name" "$2/$name" || fail "$3: $name differs"; done; }
run --out one --threads 1 && run --out two --threads 2 && run --out again --restart one/checkpoint-00020.cleave || fail "a small run"
checks=$((checks + 2))
same one two "two threads"
same one again "a restart"
run --out other --set 'fracture.scheme="basic"' || fail "a run of the basic scheme"
cmp -s one/statistics.json other/statistics.json && fail "the comparison sees no difference"

sed 's/strength/strenght/' wedge.toml >misspelt.toml
sed 's/marble.toml/granite/' wedge.toml >material.toml
sed 's/wedge.obj/missing.obj/' wedge.toml >surface.toml
sed 's/"0.5 m"/"0.5 kg"/' wedge.toml >unit.toml
printf 'name = "broken' >syntax.toml
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >open.obj
sed 's/wedge.obj/open.obj/' wedge.toml >open.toml
printf 'cleave checkpoint\n\001\000\000\000%064d' 0 >old.cleave
head -c 100000 one/checkpoint-00020.cleave >short.cleave
for case in misspelt:strenght material:granite surface:missing.obj unit:position syntax:syntax.toml open:open.obj; do
  expect "${case%%:*}" 2 "${case#*:}" "$simulate" "${case%%:*}.toml" --out bad
done
expect "no such file" 2 "none.toml" "$simulate" none.toml --out bad
expect "no such scene" 2 "pot_adaptive" "$simulate" vase --out bad
expect "no scene" 2 "SCENE.toml" "$simulate" --out bad
expect "an option" 2 "frames" "$simulate" wedge.toml --frames none --out bad
expect "a --set without a value" 2 "KEY=VALUE" "$simulate" wedge.toml --set frames --out bad
expect "a --set of nothing" 2 "nothing" "$simulate" wedge.toml --set nothing=3 --out bad
expect "no checkpoint" 2 "checkpoint" "$simulate" wedge.toml --restart wedge.toml --out bad
expect "an older checkpoint" 2 "not 1" "$simulate" wedge.toml --restart old.cleave --out bad
expect "a damaged checkpoint" 2 "checksum" "$simulate" wedge.toml --restart short.cleave --out bad
expect "another scene's checkpoint" 2 "of another" "$simulate" wedge.toml --set 'fracture.scheme="basic"' --restart one/checkpoint-00020.cleave --out bad
expect "a table of nothing" 2 "statistics.json" "$simulate" --table bin
expect "a folder that is a file" 3 "stdout" "$simulate" wedge.toml --frames 1 --out stdout
expect "help" 0 "--restart" "$simulate" --help
expect "the shipped scenes" 0 "tai_chi" "$simulate" --list

echo "$checks checks, $failures failed"
[ $failures = 0 ]
