// One ladder at a time: its errors drawn, its order, limit and grid convergence index in words; below, all ladders as a table.

import type { ChartBoard } from "./chart_board";
import { Chooser } from "./chooser";
import { asserted_order, can_be_drawn, convergence_panel, curve_title, groups_of, quantity_title } from "./convergence_chart";
import { case_id, check_id, type Report, type Row } from "./data";
import { el, facts, missing, section } from "./dom";
import { dash, number, percent, quantity } from "./format";
import { limit_table } from "./limits";

const slot_id = "convergence-shown";
const range_words = { stated: "yes", denied: "no", unknown: "not known" };

function order_text(row: Row): string {
  const { check } = row;
  const order = check.convergence?.order ?? check.order ?? (check.error_kind === "order" ? check.value : null);
  const asserted = asserted_order(row);
  const claim = asserted === null ? "none asserted" : `asserted ${check.must_fail ? "to miss " : ""}≥ ${number(asserted)}`;
  return `${number(order, 3)} (${claim})`;
}

function limit_text({ check }: Row): string {
  const { extrapolated, uncertainty } = check.convergence ?? {};
  if (typeof extrapolated !== "number") return `${dash} (the values give no extrapolation)`;
  return `${quantity(extrapolated, check.unit)} ± ${quantity(uncertainty, check.unit, 2)}`;
}

/// The uncertainty as a share of the value on the finest mesh, which is what it was made of.
function index_text({ check }: Row): string {
  const { uncertainty } = check.convergence ?? {};
  if (typeof uncertainty !== "number" || !check.value) return dash;
  return `${percent(uncertainty / Math.abs(check.value))} (safety factor 1.25)`;
}

function range_text({ check }: Row): string {
  const { asymptotic, why } = check.convergence ?? { asymptotic: "unknown" as const, why: "not examined" };
  return `${range_words[asymptotic]}: ${why}`;
}

function facts_of(row: Row): HTMLElement {
  const { check } = row;
  const verdict = el("a", { href: `#${check_id(row)}` }, check.verdict);
  return facts([
    ["Order of the error", order_text(row)],
    ["Order of the value", number(check.convergence?.order_of_values, 3)],
    ["Finest mesh", quantity(check.value, check.unit)],
    ["Richardson’s limit", limit_text(row)],
    ["Grid convergence index", index_text(row)],
    ["Reference", quantity(check.reference, check.unit)],
    ["Asymptotic range", range_text(row)],
    ["Check", el("span", {}, verdict, ", of ", el("a", { href: `#${case_id(row.owner)}` }, row.owner.name))],
  ]);
}

/// Asserted slopes first; otherwise in the order of the results.
function in_order(rows: Row[]): Row[] {
  const rank = (row: Row): number => (asserted_order(row) === null ? 1 : 0);
  return [...rows].sort((a, b) => rank(a) - rank(b) || a.index - b.index);
}

function chooser_of(drawn: Row[], board: ChartBoard): { chooser: Chooser<Row>; shown: HTMLElement } {
  const groups = groups_of(drawn);
  const group_of = new Map([...groups.values()].flatMap((group) => group.map((row): [Row, Row[]] => [row, group])));
  const slot = board.slot(slot_id);
  const chooser = new Chooser<Row>({
    label: "Choose a ladder",
    noun: "ladders",
    placeholder: "case, quantity, solver …",
    items: in_order(drawn),
    levels: [
      { label: "Case", of: ({ owner }) => owner.name },
      { label: "Quantity", of: quantity_title },
      { label: "Solver", of: (row) => curve_title(row, group_of.get(row) ?? [row]) },
    ],
    text: (row) => [row.owner.name, row.owner.about, quantity_title(row), row.check.solver, row.check.reference_source].filter(Boolean).join(" "),
    show: (row) => slot.show(convergence_panel(row, group_of.get(row) ?? [row], facts_of(row))),
  });
  return { chooser, shown: slot.element };
}

export function convergence_section(report: Report, board: ChartBoard): HTMLElement {
  const title = "Convergence";
  const drawn = report.rows.filter(can_be_drawn);
  if (drawn.length === 0) return section("convergence", title, missing("No check of these results has errors on two sizes or more."));
  const others = report.rows.length - drawn.length;
  const lead =
    "Error against representative size, over which the orders are taken, on logarithmic axes. Dashed: the slope that the check asserts." +
    (others > 0 ? ` ${others} of the ${report.rows.length} checks have no errors above zero on two sizes and are not drawn.` : "");
  const { chooser, shown } = chooser_of(drawn, board);
  const choose = (row: Row): (() => void) | null => (can_be_drawn(row) ? () => chooser.choose(row) : null);
  return section("convergence", title, el("p", {}, lead), chooser.element, chooser.status, shown, ...limit_table(report, slot_id, choose));
}
