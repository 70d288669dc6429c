// All ladders in one table, folded: observed order, Richardson's extrapolation, grid convergence index.

import { case_id, check_id, type Report, type Row } from "./data";
import { DataTable, type Column } from "./data_table";
import { el, lines } from "./dom";
import { dash, number, quantity, words } from "./format";

const solver_text = (name: string): string => name.replace(".", ".\u200b");

function case_cell({ owner, check }: Row): Node {
  return lines(el("a", { href: `#${case_id(owner)}` }, owner.name.replace(/_/g, "_\u200b")), check.place ?? "");
}

function limit_cell({ check }: Row): Node | string {
  const { extrapolated, uncertainty } = check.convergence ?? {};
  if (typeof extrapolated !== "number") return dash;
  return lines(quantity(extrapolated, check.unit), `± ${quantity(uncertainty, check.unit, 2)}`);
}

function asserted({ check }: Row): string {
  const order = check.band?.order_at_least;
  return typeof order === "number" ? `asserted ≥ ${number(order)}` : "none asserted";
}

const marks = { stated: "✓", denied: "✗", unknown: "·" };

/// What shows a row's chart; null where it has none.
type Choose = (row: Row) => (() => void) | null;

function quantity_cell(row: Row, slot_id: string, choose: Choose): Node {
  const name = [words(row.check.quantity), row.check.component ?? ""].join(" ").trim();
  const check = el("a", { href: `#${check_id(row)}` }, name);
  const show = choose(row);
  if (!show) return check;
  const chart = el("a", { href: `#${slot_id}`, "aria-label": `Chart of ${name}, ${row.check.solver}, ${row.owner.name}` }, "chart");
  chart.addEventListener("click", show);
  return lines(check, chart);
}

const columns_of = (slot_id: string, choose: Choose): Column<Row>[] => [
  { key: "case", title: "Case", head: true, sort: ({ owner }) => owner.name, cell: case_cell },
  {
    key: "quantity",
    title: "Quantity",
    sort: ({ check }) => check.quantity,
    cell: (row) => quantity_cell(row, slot_id, choose),
  },
  { key: "solver", title: "Solver", sort: ({ check }) => check.solver, cell: ({ check }) => el("code", {}, solver_text(check.solver)) },
  { key: "meshes", title: "Meshes", numeric: true, sort: ({ check }) => check.ladder?.length ?? 0, cell: ({ check }) => number(check.ladder?.length) },
  {
    key: "order",
    title: "Order of the error",
    numeric: true,
    sort: ({ check }) => check.convergence?.order ?? null,
    cell: (row) => lines(number(row.check.convergence?.order, 3), asserted(row)),
  },
  {
    key: "order_of_values",
    title: "Order of the value",
    numeric: true,
    sort: ({ check }) => check.convergence?.order_of_values ?? null,
    cell: ({ check }) => number(check.convergence?.order_of_values, 3),
  },
  { key: "value", title: "Finest mesh", numeric: true, sort: ({ check }) => check.value ?? null, cell: ({ check }) => quantity(check.value, check.unit) },
  { key: "limit", title: "Extrapolated", numeric: true, sort: ({ check }) => check.convergence?.extrapolated ?? null, cell: limit_cell },
  {
    key: "reference",
    title: "Reference",
    numeric: true,
    sort: ({ check }) => check.reference ?? null,
    cell: ({ check }) => quantity(check.reference, check.unit),
  },
  {
    key: "why",
    title: "Asymptotic range",
    sort: ({ check }) => check.convergence?.asymptotic ?? "",
    cell: ({ check }) => {
      const state = check.convergence?.asymptotic ?? "unknown";
      return lines(el("span", {}, el("span", { "aria-hidden": "true" }, marks[state]), ` ${state}`), check.convergence?.why ?? "");
    },
  },
];

function csv_line({ check, owner }: Row): unknown[] {
  const limit = check.convergence;
  const numbers = [limit?.order, check.band?.order_at_least, limit?.order_of_values, limit?.extrapolated, limit?.uncertainty, limit?.asymptotic, limit?.why];
  return [owner.name, check.quantity, check.component, check.unit, check.place, check.solver, check.ladder?.length, check.value, check.reference, ...numbers];
}

/// The same ladder under two checks is one ladder.
function ladder_key({ owner, check }: Row): string {
  return [owner.name, check.quantity, check.component ?? "", check.place ?? "", check.solver, JSON.stringify(check.ladder)].join("|");
}

/// Ladders of two sizes and more. Must-fail twins repeat theirs with a wrong reference and are left out.
export function limit_table({ rows }: Report, slot_id: string, choose: Choose): HTMLElement[] {
  const found = rows.filter(({ check }) => !check.must_fail && (check.ladder?.length ?? 0) >= 2);
  const items = found.filter((row, i) => found.findIndex((other) => ladder_key(other) === ladder_key(row)) === i);
  if (items.length === 0) return [];
  const lead =
    "Extrapolated: Richardson’s limit of the value through all meshes, of three and more; ± the grid convergence index with the " +
    "safety factor 1.25 (Roache 1994; ASME V&V 20-2009). Asymptotic range: stated where neighbouring meshes show orders within a quarter of the observed one.";
  const table = new DataTable<Row>({
    id: "limit-table",
    caption: "Observed orders, extrapolated values with their uncertainty, and whether the asymptotic range is reached",
    label: "Convergence table",
    noun: "ladders",
    placeholder: "case, quantity, solver …",
    file: "cleave-convergence.csv",
    items,
    columns: columns_of(slot_id, choose),
    choices: [
      { label: "Solver", of: ({ check }) => check.solver },
      { label: "Asymptotic", of: ({ check }) => check.convergence?.asymptotic ?? "" },
    ],
    text: ({ owner, check }) => [owner.name, check.quantity, check.component, check.place, check.solver].filter(Boolean).join(" "),
    line: (row) => ({ "data-row": String(row.index) }),
    csv_head: ["case", "quantity", "component", "unit", "place", "solver", "meshes", "value", "reference", "order", "asserted_order", "order_of_values",
      "extrapolated", "uncertainty", "asymptotic", "why"],
    csv_line,
  });
  return [el("details", { class: "all" }, el("summary", {}, `All ${items.length} ladders as a table`), el("p", {}, lead), ...table.elements())];
}
