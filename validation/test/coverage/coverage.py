#!/usr/bin/env python3
"""Line coverage of solver/ and validation/ by folder, and the rooms no test enters: functions of the files below 80 %.
   coverage.py SOURCE BUILD      after the tests of a build by preset `coverage` have run"""
import collections
import concurrent.futures
import json
import os
import re
import subprocess
import sys

LEAST = 80  # percent of a file's lines


def gcov(note, source, build):
    """gcov's records of one object file, own sources only, named from `source`. A name in a note is absolute, or from the build folder
    where ccache has made it so."""
    answer = subprocess.run(["gcov", "--json-format", "--stdout", note], capture_output=True, text=True, cwd=os.path.dirname(note))
    if answer.returncode != 0:
        sys.exit(f"coverage: {answer.stderr.strip()}")
    records = []
    for line in answer.stdout.splitlines():
        for record in json.loads(line)["files"]:
            record["file"] = os.path.relpath(os.path.normpath(os.path.join(build, record["file"])), source)
            records += [record] if counted(record["file"]) and record["lines"] else []
    return records


def counted(name):
    return name.startswith(("solver/", "validation/")) and "/test/" not in name


def read(source, build):
    """{file: {line: calls}}, {file: {function: (first line, calls)}} over all object files; one that never ran counts too."""
    lines, functions = collections.defaultdict(dict), collections.defaultdict(dict)
    notes = [os.path.join(folder, name) for folder, _, names in os.walk(build) for name in names if name.endswith(".gcno")]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for records in pool.map(lambda note: gcov(note, source, build), sorted(notes)):
            for record in records:
                of_file = lines[record["file"]]
                for line in record["lines"]:
                    of_file[line["line_number"]] = max(of_file.get(line["line_number"], 0), line["count"])
                for function in record["functions"]:
                    place = (function["start_line"], function["end_line"])
                    name = short(function["demangled_name"])
                    functions[record["file"]][place] = (name, max(functions[record["file"]].get(place, ("", 0))[1], function["execution_count"]))
    return lines, functions


def short(demangled):
    """a::(anonymous namespace)::f[abi:cxx11](int) is f, and a lambda has the name of the function around it."""
    name = re.sub(r"\[abi:\w+\]", "", demangled.replace("(anonymous namespace)::", ""))
    return name.split("{lambda")[0].rstrip(":").split("(")[0].split("::")[-1]


def share(of_lines):
    return 100 * sum(count > 0 for count in of_lines.values()) / len(of_lines)


def table(lines):
    folders = collections.defaultdict(dict)
    for name, of_file in lines.items():
        for group in (name.split("/")[0], "/".join(name.split("/")[:2]) if name.count("/") > 1 else name.split("/")[0] + "/ itself"):
            folders[group].update({(name, line): count for line, count in of_file.items()})
    for folder in sorted(folders):
        of_folder = folders[folder]
        print(f"{folder:28} {share(of_folder):5.1f} %  of {len(of_folder)} lines")


def rooms(lines, functions):
    """Files below LEAST, worst first, with the functions that nothing called."""
    low = sorted((share(of_file), name) for name, of_file in lines.items() if share(of_file) < LEAST)
    for percent, name in low:
        unused = sorted({f"{called} (line {place[0]})" for place, (called, count) in functions[name].items() if count == 0})
        print(f"  {name}: {percent:.0f} % of {len(lines[name])} lines{'; never called: ' if unused else ''}{', '.join(unused)}")
    return len(low)


def main():
    source, build = map(os.path.abspath, sys.argv[1:3])
    lines, functions = read(source, build)
    if not any(count for of_file in lines.values() for count in of_file.values()):
        sys.exit("coverage: no line ran; is this a build by preset coverage, and have its tests run?")
    table(lines)
    print(f"files below {LEAST} %:")
    low = rooms(lines, functions)
    of_all = {(name, line): count for name, of_file in lines.items() for line, count in of_file.items()}
    print(f"coverage: {share(of_all):.1f} % of {len(of_all)} lines of solver/ and validation/, {low} of {len(lines)} files below {LEAST} %")


main()
