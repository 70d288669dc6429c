# What the command line tests share: to be read in (`. cli_expect.sh`) before they go to their folder.
failures=0 checks=0
left=  # pattern of files that a refused call must not leave

fail() { failures=$((failures + 1)); echo "FAILED $*"; }

# expect NAME EXIT_CODE PATTERN COMMAND...: the exit code, and PATTERN in what is printed; for 2 exactly one line on stderr, stdout empty, nothing left.
expect() {
  name=$1 wanted=$2 pattern=$3; shift 3
  checks=$((checks + 1))
  "$@" >stdout 2>stderr
  code=$?
  problem=
  [ $code = "$wanted" ] || problem="exit code $code instead of $wanted"
  if [ "$wanted" = 2 ]; then
    [ "$(wc -l <stderr)" = 1 ] || problem="$problem; $(wc -l <stderr) lines on stderr"
    [ -s stdout ] && problem="$problem; something on stdout"
    for file in $left; do [ -e "$file" ] && problem="$problem; $file was left"; done
  fi
  grep -qF -- "$pattern" stderr stdout || problem="$problem; no '$pattern'"
  [ -z "$problem" ] || { fail "$name: $problem"; sed 's/^/  stderr: /' stderr | head -n 5; }
}
