// The five numbers that matter, each with the row it stands in and the command that repeats it.

import { check_id, count, type Headline, type Report, type Row, type WorstError } from "./data";
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
  beside?: Node; ///< small print
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
function worst_of<Worst extends WorstError>({ sources, rows }: Report, of: (stated: Headline) => Worst | null | undefined): { worst: Worst; row: Row } | null {
  let found: { worst: Worst; row: Row } | null = null;
  for (const source of sources) {
    const worst = source.results.headline ? of(source.results.headline) : null;
    if (!worst || (found && found.worst.error >= worst.error)) continue;
    const row = rows.find((one) => one.source === source && one.owner.name === worst.case && one.owner.checks[worst.check] === one.check);
    if (row) found = { worst, row };
  }
  return found;
}

function worst_figure(report: Report, label: string, name: string, text: (error: number) => string, none: string): Figure {
  const found = worst_of(report, (stated) => stated[name]);
  if (!found) return { label, value: dash, detail: none };
  const { check, owner } = found.row;
  const detail = [owner.name, check.solver, check.place ?? "", `band ${band_text(check.band, check.unit)}`].filter(Boolean).join(", ");
  return { label, value: text(found.worst.error), detail, target: check_id(found.row), command: found.worst.command };
}

/// A band judges few of the differences between particles and finite elements: the largest of the others, and why nothing judges it.
function recorded(report: Report): Node | undefined {
  const found = worst_of(report, (stated) => stated.recorded_particle_stress);
  if (!found) return undefined;
  const { worst, row } = found;
  const link = el("a", { href: `#${check_id(row)}` }, percent(worst.error));
  const where = [row.owner.name, `${worst.solver} against ${worst.against}`, row.check.place ?? ""].filter(Boolean).join(", ");
  return el("span", { class: "recorded" }, "Largest difference only recorded, not judged: ", link, ` (${where}). Why: ${worst.why.replace(/\.$/, "")}.`);
}

function subdivision_figure(report: Report): Figure {
  const label = "Subdivision per added particle";
  const found = scenarios(report).find((row) => per_added(row) !== null);
  if (!found) return { label, value: dash, detail: "no Table 2 row in bench.json" };
  const paper = found.paper_per_added === null ? "" : ` Paper’s Table 2, 2010 Xeon W3530: ${number(found.paper_per_added, 3)} ms.`;
  const detail = `${found.title}, on ${found.machine}.${paper}`;
  return { label, value: `${number(per_added(found), 3)} ms`, detail, target: "subdivision", command: "cleave bench --filter table2" };
}

function block({ label, value, detail, target, command, state, beside }: Figure): HTMLElement {
  const shown = target ? el("a", { href: `#${target}` }, value) : value;
  return el(
    "div",
    state ? { class: state } : {},
    el("dt", {}, label),
    el("dd", { class: "figure" }, shown),
    el("dd", {}, detail),
    command ? el("dd", {}, el("code", {}, command)) : null,
    beside ? el("dd", {}, beside) : null,
  );
}

export function headline(report: Report): HTMLElement {
  const degrees = (error: number): string => `${number(error, 2)}°`;
  const stress = worst_figure(report, "Worst judged particle stress against the FEM", "worst_particle_stress", percent, "no judged stress of particles against the FEM");
  const figures = [
    checks_figure(report),
    { ...stress, beside: recorded(report) },
    worst_figure(report, "Worst judged energy release rate", "worst_energy_release_rate", percent, "no judged energy release rate"),
    worst_figure(report, "Worst judged crack angle", "worst_crack_angle", degrees, "no judged crack angle"),
    subdivision_figure(report),
  ];
  return el("dl", { class: "headline", "aria-label": "Headline numbers" }, ...figures.map(block));
}
