// Table 2 of the paper beside ours: rows "table2/SCENARIO" of the benchmark file.

import type { Bench, Benchmark, Report } from "./data";
import { el, missing, plain_table, scroll_frame, section } from "./dom";
import { dash, number, words } from "./format";

export interface Scenario {
  title: string;
  machine: string;
  before: number | null;
  after: number | null;
  milliseconds: number | null;
  milliseconds_per_added: number | null;
  paper_milliseconds: number | null;
  paper_per_added: number | null;
  paper_after: number | null;
}

function counter(row: Benchmark, name: string): number | null {
  const value = row[name];
  return typeof value === "number" ? value : null;
}

function machine_of(bench: Bench): string {
  const context = bench.context ?? {};
  const model = context.cpu_model ?? context.host_name;
  return typeof model === "string" && model ? model : "a machine that bench.json does not name";
}

/// The median where repetitions were aggregated, otherwise the first run of that name.
function representative(rows: Benchmark[]): Benchmark {
  return rows.find((row) => row.aggregate_name === "median") ?? rows[0];
}

function scenario(name: string, rows: Benchmark[], bench: Bench): Scenario {
  const row = representative(rows);
  return {
    title: words(name).replace(/^./, (letter) => letter.toUpperCase()),
    machine: machine_of(bench),
    before: counter(row, "particles_before"),
    after: counter(row, "particles_after"),
    milliseconds: counter(row, "milliseconds"),
    milliseconds_per_added: counter(row, "milliseconds_per_added"),
    paper_milliseconds: counter(row, "paper_milliseconds"),
    paper_per_added: counter(row, "paper_milliseconds_per_added"),
    paper_after: counter(row, "paper_particles_after"),
  };
}

export function scenarios(report: Report): Scenario[] {
  const found: Scenario[] = [];
  for (const { bench } of report.sources) {
    const groups = new Map<string, Benchmark[]>();
    for (const row of bench?.benchmarks ?? []) {
      const name = /^table2\/(\w+)/.exec(row.name)?.[1].replace(/_(mean|median|stddev|cv)$/, "");
      if (name) groups.set(name, [...(groups.get(name) ?? []), row]);
    }
    if (bench) groups.forEach((rows, name) => found.push(scenario(name, rows, bench)));
  }
  return found;
}

export function per_added(row: Scenario): number | null {
  return row.milliseconds_per_added;
}

const columns = [
  { title: "Scenario" },
  { title: "Particles before", numeric: true },
  { title: "after", numeric: true },
  { title: "Subdivision (ms)", numeric: true },
  { title: "ms per added particle", numeric: true },
  { title: "Paper: particles after", numeric: true },
  { title: "Paper: subdivision (ms)", numeric: true },
  { title: "Paper: ms per added particle", numeric: true },
];

function cells(row: Scenario): string[] {
  return [
    row.title,
    number(row.before),
    number(row.after),
    number(row.milliseconds, 3),
    number(per_added(row), 3),
    number(row.paper_after),
    number(row.paper_milliseconds),
    number(row.paper_per_added, 3),
  ];
}

function other_benchmarks(report: Report): HTMLElement | null {
  const rows = report.sources.flatMap(({ bench }) => bench?.benchmarks ?? []).filter((row) => !row.name.startsWith("table2/"));
  if (rows.length === 0) return null;
  const lines = rows.map((row) => {
    const time = typeof row.real_time === "number" ? `${number(row.real_time, 3)} ${row.time_unit ?? "ns"}` : dash;
    return [el("code", {}, row.name), time];
  });
  const table = plain_table("Other benchmarks of this run", [{ title: "Benchmark" }, { title: "Time", numeric: true }], lines);
  return el("details", {}, el("summary", {}, `Other benchmarks (${rows.length})`), scroll_frame("Other benchmarks", table));
}

export function subdivision_section(report: Report): HTMLElement {
  const rows = scenarios(report);
  const title = "Subdivision beside the paper’s Table 2";
  if (rows.length === 0) {
    const why = report.sources.some(({ bench }) => bench)
      ? "bench.json has no row of Table 2."
      : "No bench.json in these results: run cleave bench.";
    return section("subdivision", title, missing(why), other_benchmarks(report));
  }
  const machines = [...new Set(rows.map((row) => row.machine))].join("; ");
  const context = `Ours: ${machines}. The paper’s: a 2010 Xeon W3530. Two machines, so this is context, not a race.`;
  const table = plain_table("Time to subdivide, ours and the paper’s", columns, rows.map(cells));
  return section("subdivision", title, el("p", {}, context), scroll_frame("Table 2 beside ours", table), other_benchmarks(report));
}
