// Symmetry class x quantity x method: how many checks, or why there is none.

import type { CoverageCell, Report } from "./data";
import { el, missing, scroll_frame, section } from "./dom";
import { number } from "./format";

const methods: [string, string][] = [
  ["particles", "particles"],
  ["fem", "FEM"],
  ["mathematics", "mathematics"],
];

/// Several folders: their checks together; a cell is empty where it is so in all.
function merged(report: Report): Map<string, CoverageCell> {
  const cells = new Map<string, CoverageCell>();
  for (const { results } of report.sources) {
    for (const cell of results.coverage ?? []) {
      const key = [cell.symmetry, cell.family, cell.method].join("|");
      const known = cells.get(key);
      cells.set(key, known ? { ...known, checks: known.checks + cell.checks } : { ...cell });
    }
  }
  return cells;
}

const unique = (values: string[]): string[] => [...new Set(values)];

export function coverage_section(report: Report): HTMLElement {
  const title = "Coverage";
  const cells = merged(report);
  if (cells.size === 0) return section("coverage", title, missing("results.json holds no coverage."));
  const all = [...cells.values()];
  const families = unique(all.map((cell) => cell.family));
  const reasons = unique(all.filter((cell) => cell.checks === 0).map((cell) => cell.why || "not in this run"));
  const shown = (cell: CoverageCell | undefined): HTMLElement => {
    if (cell && cell.checks > 0) return el("td", { class: "number" }, number(cell.checks));
    const note = reasons.indexOf(cell?.why || "not in this run") + 1;
    const link = el("a", { href: `#gap-${note}`, "aria-label": `none, see reason ${note}` }, `${note}`);
    return el("td", { class: "number none" }, "– ", el("sup", {}, link));
  };
  const body = el("tbody");
  for (const symmetry of unique(all.map((cell) => cell.symmetry))) {
    methods.forEach(([method, name], i) => {
      const head = i === 0 ? el("th", { scope: "rowgroup", rowspan: "3" }, symmetry) : null;
      const line = families.map((family) => shown(cells.get([symmetry, family, method].join("|"))));
      body.append(el("tr", i === 0 ? { class: "first" } : {}, head, el("th", { scope: "row" }, name), ...line));
    });
  }
  const heads = families.map((family) => el("th", { scope: "col", class: "number" }, family));
  const head = el("tr", {}, el("th", { scope: "col" }, "Symmetry"), el("th", { scope: "col" }, "Method"), ...heads);
  const caption = el("caption", {}, "Number of checks by symmetry class, method and quantity");
  const table = el("table", { id: "coverage-table" }, caption, el("thead", {}, head), body);
  const lead =
    "Checks of this run by the symmetry class of the material (told from its stiffness), the quantity, and who is judged: the particles, the finite " +
    "elements; mathematics counts the checks whose reference is a closed form, an integral or a literature value. Must-fail twins are left out.";
  const notes = el("ol", { class: "gaps" }, ...reasons.map((why, i) => el("li", { id: `gap-${i + 1}` }, `${why}.`)));
  const explained = reasons.length > 0 ? [el("h3", {}, "Why a cell is empty"), notes] : [];
  return section("coverage", title, el("p", {}, lead), scroll_frame("Coverage matrix", table), ...explained);
}
