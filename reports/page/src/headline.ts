import { count, is_reference_by_fem, type Report, type Row } from "./data";
import { el } from "./dom";
import { dash, number, percent, words } from "./format";
import { per_added, scenarios } from "./subdivision";

interface Figure {
  label: string;
  value: string;
  detail: string;
  state?: string;
}

function checks_figure({ rows }: Report): Figure {
  const pass = count(rows, "pass");
  const fail = count(rows, "fail");
  const twins = rows.filter((row) => row.check.must_fail).length;
  const detail = [fail > 0 ? `${fail} missed` : "none missed"];
  if (twins > 0) detail.push(`among the judged ${twins} must-fail twins`);
  detail.push(`${count(rows, "info")} more for information`);
  return { label: "Checks passed", value: `${pass} of ${pass + fail}`, detail: detail.join("; "), state: fail > 0 ? "fail" : "pass" };
}

/// Judged, particles, stress, against the FEM: the row with the largest relative error.
function worst_stress(rows: Row[]): Row | undefined {
  const judged = rows.filter(
    ({ check }) =>
      check.quantity === "stress" &&
      check.solver.startsWith("sph") &&
      !check.must_fail &&
      check.verdict !== "info" &&
      check.error_kind === "relative" &&
      typeof check.error === "number",
  );
  const against_fem = judged.filter(is_reference_by_fem);
  return against_fem.reduce<Row | undefined>(
    (worst, row) => (!worst || (row.check.error ?? 0) > (worst.check.error ?? 0) ? row : worst),
    undefined,
  );
}

function stress_figure({ rows }: Report): Figure {
  const label = "Worst particle stress against the FEM";
  const row = worst_stress(rows);
  if (!row) return { label, value: dash, detail: "no judged stress check of particles against the FEM in these results" };
  const { check, owner } = row;
  return { label, value: percent(check.error), detail: [words(owner.name), check.solver, check.place ?? ""].filter(Boolean).join(", ") };
}

function subdivision_figure(report: Report): Figure {
  const label = "Subdivision per added particle";
  const found = scenarios(report).find((row) => per_added(row) !== null);
  if (!found) return { label, value: dash, detail: "no Table 2 row in bench.json" };
  const paper = found.paper_per_added === null ? "" : ` Paper’s Table 2, 2010 Xeon W3530: ${number(found.paper_per_added, 3)} ms.`;
  return { label, value: `${number(per_added(found), 3)} ms`, detail: `${found.title}, on ${found.machine}.${paper}` };
}

export function headline(report: Report): HTMLElement {
  const figures = [checks_figure(report), stress_figure(report), subdivision_figure(report)];
  return el(
    "dl",
    { class: "headline", "aria-label": "Headline numbers" },
    ...figures.map((figure) =>
      el(
        "div",
        figure.state ? { class: figure.state } : {},
        el("dt", {}, figure.label),
        el("dd", { class: "figure" }, figure.value),
        el("dd", {}, figure.detail),
      ),
    ),
  );
}
