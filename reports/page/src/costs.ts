// What each solve cost: the records of timings.json.

import type { Report } from "./data";
import { el, missing, plain_table, scroll_frame, section } from "./dom";
import { dash, number, words } from "./format";

interface Solve {
  case?: string;
  solver?: string;
  method?: string;
  cells?: number;
  dofs?: number;
  iterations?: number;
  relative_residual?: number | null;
  seconds?: number | null;
  bytes?: number | null;
}

/// Zero stands for what a method does not have.
function counted(value: number | null | undefined, digits = 4): string {
  return value ? number(value, digits) : dash;
}

function cells_of(solve: Solve): (string | Node)[] {
  return [
    (solve.case ?? "").replace(/_/g, "_\u200b"),
    el("code", {}, (solve.solver ?? "").replace(".", ".\u200b")),
    words(solve.method ?? ""),
    counted(solve.cells),
    counted(solve.dofs),
    counted(solve.iterations),
    counted(solve.relative_residual, 2),
    counted(solve.seconds, 3),
    solve.bytes ? number(solve.bytes / 1e6, 3) : dash,
  ];
}

const columns = [
  { title: "Case" },
  { title: "Solver" },
  { title: "Method" },
  { title: "Tets", numeric: true },
  { title: "Unknowns", numeric: true },
  { title: "Iterations", numeric: true },
  { title: "Residual", numeric: true },
  { title: "Time (s)", numeric: true },
  { title: "Memory (MB)", numeric: true },
];

/// Of each case and solver the solve with the most unknowns.
function largest(solves: Solve[]): Solve[] {
  const found = new Map<string, Solve>();
  for (const solve of solves) {
    const key = `${solve.case} ${solve.solver}`;
    const before = found.get(key);
    if (!before || (solve.dofs ?? 0) > (before.dofs ?? 0)) found.set(key, solve);
  }
  return [...found.values()];
}

export function costs_section(report: Report): HTMLElement {
  const title = "What each solve cost";
  const solves = report.sources.flatMap((source) => (source.timings?.solves ?? []) as Solve[]);
  if (solves.length === 0) return section("costs", title, missing("timings.json holds no solve."));
  const context =
    "Wall time of reading, assembly and solve, of one run on the machine named above; memory of matrix and factor or preconditioner.";
  const frame = (caption: string, rows: Solve[]): HTMLElement =>
    scroll_frame(caption, plain_table(caption, columns, rows.map(cells_of)));
  const all = el("details", {}, el("summary", {}, `All solves (${number(solves.length)})`), frame("Every solve", solves));
  return section("costs", title, el("p", {}, context), frame("The largest solve of each case and solver", largest(solves)), all);
}
