// The five numbers that matter, each with the row it stands in and the command that repeats it.

import { check_id, count, type Report, type Row, type WorstError } from "./data";
import { el } from "./dom";
import { band_text, dash, number, percent } from "./format";
import { per_added, scenarios } from "./subdivision";

interface Figure {
  label: string;
  value: string;
  detail: string;
  target?: string; ///< id of the row
  command?: string;
  state?: string;
}

function checks_figure({ rows, sources }: Report): Figure {
  const pass = count(rows, "pass");
  const fail = count(rows, "fail");
  const twins = rows.filter((row) => row.check.must_fail).length;
  const detail = [fail > 0 ? `${fail} missed` : "none missed"];
  if (twins > 0) detail.push(`among the judged ${twins} must-fail twins`);
  detail.push(`${count(rows, "info")} more for information`);
  const command = `cleave report --level ${sources[0]?.results.level ?? "quick"}`;
  const target = fail > 0 ? "missed" : "verdicts";
  return { label: "Checks passed", value: `${pass} of ${pass + fail}`, detail: detail.join("; "), target, command, state: fail > 0 ? "fail" : "pass" };
}

/// The worst over all folders, as each results.json states it.
function worst_of({ sources, rows }: Report, name: string): { worst: WorstError; row: Row } | null {
  let found: { worst: WorstError; row: Row } | null = null;
  for (const source of sources) {
    const worst = source.results.headline?.[name];
    if (!worst || (found && found.worst.error >= worst.error)) continue;
    const row = rows.find((one) => one.source === source && one.owner.name === worst.case && one.owner.checks[worst.check] === one.check);
    if (row) found = { worst, row };
  }
  return found;
}

function worst_figure(report: Report, label: string, name: string, text: (error: number) => string, none: string): Figure {
  const found = worst_of(report, name);
  if (!found) return { label, value: dash, detail: none };
  const { check, owner } = found.row;
  const detail = [owner.name, check.solver, check.place ?? "", `band ${band_text(check.band, check.unit)}`].filter(Boolean).join(", ");
  return { label, value: text(found.worst.error), detail, target: check_id(found.row), command: found.worst.command };
}

function subdivision_figure(report: Report): Figure {
  const label = "Subdivision per added particle";
  const found = scenarios(report).find((row) => per_added(row) !== null);
  if (!found) return { label, value: dash, detail: "no Table 2 row in bench.json" };
  const paper = found.paper_per_added === null ? "" : ` Paper’s Table 2, 2010 Xeon W3530: ${number(found.paper_per_added, 3)} ms.`;
  const detail = `${found.title}, on ${found.machine}.${paper}`;
  return { label, value: `${number(per_added(found), 3)} ms`, detail, target: "subdivision", command: "cleave bench --filter table2" };
}

function block({ label, value, detail, target, command, state }: Figure): HTMLElement {
  const shown = target ? el("a", { href: `#${target}` }, value) : value;
  return el(
    "div",
    state ? { class: state } : {},
    el("dt", {}, label),
    el("dd", { class: "figure" }, shown),
    el("dd", {}, detail),
    command ? el("dd", {}, el("code", {}, command)) : null,
  );
}

export function headline(report: Report): HTMLElement {
  const degrees = (error: number): string => `${number(error, 2)}°`;
  const figures = [
    checks_figure(report),
    worst_figure(report, "Worst particle stress against the FEM", "worst_particle_stress", percent, "no judged stress of particles against the FEM"),
    worst_figure(report, "Worst energy release rate", "worst_energy_release_rate", percent, "no judged energy release rate"),
    worst_figure(report, "Worst crack angle", "worst_crack_angle", degrees, "no judged crack angle"),
    subdivision_figure(report),
  ];
  return el("dl", { class: "headline", "aria-label": "Headline numbers" }, ...figures.map(block));
}
