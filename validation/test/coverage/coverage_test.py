#!/usr/bin/env python3
"""coverage.py on a program whose lines are known: before it ran, after it ran, and compiled with names from the build folder, as ccache
gives them, or absolute ones.   coverage_test.py COMPILER"""
import os
import subprocess
import sys
import tempfile

ROOM = """int entered(int x) {
    if (x > 0) return x;
    return -x;
}
namespace {
int inner(int x) { return x; }
}
int never(int x) {
    return inner(x);
}
int main() { return entered(0); }
"""


def coverage(source):
    here = os.path.dirname(os.path.abspath(__file__))
    answer = subprocess.run([os.path.join(here, "coverage.py"), source, os.path.join(source, "build")], capture_output=True, text=True)
    return answer.returncode, answer.stdout + answer.stderr


def expect(said, words):
    if words not in said:
        sys.exit(f"expected '{words}' in:\n{said}")


def check(compiler, name_of):
    with tempfile.TemporaryDirectory() as source:
        for folder in ("solver/rooms", "build"):
            os.makedirs(os.path.join(source, folder))
        with open(os.path.join(source, "solver/rooms/room.cpp"), "w") as file:
            file.write(ROOM)
        build = os.path.join(source, "build")
        words = [compiler, "--coverage", "-O0", "-c", name_of(source, "solver/rooms/room.cpp"), "-o", "room.o"]
        subprocess.run(words, cwd=build, check=True)
        subprocess.run([compiler, "--coverage", "room.o", "-o", "program"], cwd=build, check=True)
        code, said = coverage(source)
        expect(said, "no line ran")
        if code == 0:
            sys.exit("a build that never ran was accepted")
        subprocess.run([os.path.join(build, "program")], check=True)
        code, said = coverage(source)
        expect(said, "solver/rooms                  57.1 %  of 7 lines")  # 1, 2, 3, 11 ran; 6, 8, 9 did not; a bracket is no line
        expect(said, "solver/rooms/room.cpp: 57 % of 7 lines; never called: inner (line 6), never (line 8)")
        if code != 0:
            sys.exit(said)
        return said


def main():
    compiler = sys.argv[1]
    from_build = check(compiler, lambda source, name: "../" + name)
    absolute = check(compiler, os.path.join)
    expect(absolute, from_build)


main()
