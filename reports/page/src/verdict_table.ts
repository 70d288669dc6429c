import { case_id, check_id, type Report, type Row } from "./data";
import { DataTable, type Column } from "./data_table";
import { el, foldable, lines, missing, section } from "./dom";
import { band_text, dash, error_text, number, quantity, words } from "./format";

export const marks = { pass: "✓", fail: "✗", info: "·" };

function verdict_cell({ check }: Row): Node {
  const cell = el(
    "span",
    { class: `mark ${check.verdict}` },
    el("span", { "aria-hidden": "true" }, marks[check.verdict]),
    ` ${check.verdict}`,
  );
  if (!check.must_fail) return cell;
  const why =
    check.verdict === "pass" ? "Must-fail twin: the wrong reference was caught" : "Must-fail twin: the wrong reference was NOT caught";
  return el("span", {}, cell, " ", el("abbr", { class: "twin", title: why }, "must-fail twin"));
}

function parameters_text(row: Row): string {
  return Object.entries(row.owner.parameters ?? {})
    .map(([key, value]) => `${key.split(".").pop()} = ${value}`)
    .join(", ");
}

function case_cell(row: Row): Node {
  const link = el("a", { href: `#${case_id(row.owner)}` }, row.owner.name.replace(/_/g, "_\u200b"));
  return lines(link, [words(row.tier), parameters_text(row)].filter(Boolean).join("; "));
}

function resolution_cell({ check }: Row): Node {
  const { size, unit, particles, dofs } = check.resolution ?? {};
  const cells = check.solver.startsWith("fem") ? "tets" : "particles"; // a particle is a tet of the same mesh
  const counts = [];
  if (typeof particles === "number") counts.push(`${number(particles)} ${cells}`);
  if (typeof dofs === "number") counts.push(`${number(dofs)} dofs`);
  return lines(typeof size === "number" ? quantity(size, unit ?? "", 3) : dash, ...counts);
}

function reference_cell({ check }: Row): Node {
  return lines(quantity(check.reference, check.unit), check.reference_source ?? "");
}

/// The error on the finest size; the observed order below it where there is one.
function error_cell({ check }: Row): Node {
  const order = typeof check.order === "number" ? `order ${number(check.order, 3)}` : "";
  return lines(error_text(check.error, check.error_kind, check.unit), order);
}

function band_cell({ check }: Row): string {
  const text = band_text(check.band, check.unit);
  return check.must_fail && check.band ? `must miss ${text}` : text;
}

const columns: Column<Row>[] = [
  { key: "verdict", title: "Verdict", sort: ({ check }) => ["fail", "info", "pass"].indexOf(check.verdict), cell: verdict_cell },
  { key: "case", title: "Case", head: true, sort: (row) => row.owner.name, cell: case_cell },
  {
    key: "quantity",
    title: "Quantity",
    sort: ({ check }) => check.quantity,
    cell: ({ check }) => lines(words(check.quantity), check.component ?? ""),
  },
  { key: "place", title: "Place", sort: ({ check }) => check.place ?? "", cell: ({ check }) => (check.detail ? lines(check.place ?? "", check.detail) : check.place || dash) },
  {
    key: "solver",
    title: "Solver",
    sort: ({ check }) => check.solver,
    cell: ({ check }) => el("code", {}, check.solver.replace(".", ".\u200b")),
  },
  { key: "resolution", title: "Resolution", numeric: true, sort: ({ check }) => check.resolution?.size ?? null, cell: resolution_cell },
  {
    key: "value",
    title: "Value",
    numeric: true,
    sort: ({ check }) => check.value ?? null,
    cell: ({ check }) => quantity(check.value, check.unit),
  },
  { key: "reference", title: "Reference", numeric: true, sort: ({ check }) => check.reference ?? null, cell: reference_cell },
  { key: "error", title: "Error", numeric: true, sort: ({ check }) => check.error ?? null, cell: error_cell },
  { key: "band", title: "Band", sort: (row) => band_cell(row), cell: band_cell },
  { key: "basis", title: "Why this band, or none", sort: ({ check }) => check.basis ?? "", cell: ({ check }) => (check.basis ? foldable(check.basis) : dash) },
];

function searchable(row: Row): string {
  const { check, owner } = row;
  return [
    owner.name,
    owner.about,
    row.tier,
    check.quantity,
    check.component,
    check.place,
    check.detail,
    check.solver,
    check.reference_source,
    check.basis,
    check.must_fail ? "must-fail twin" : "",
    parameters_text(row),
  ]
    .filter(Boolean)
    .join(" ");
}

const csv_keys = [
  "quantity",
  "component",
  "unit",
  "place",
  "solver",
  "value",
  "reference",
  "reference_source",
  "error",
  "error_kind",
  "band",
  "basis",
  "order",
  "must_fail",
  "verdict",
] as const;

const csv_head = ["case", "tier", ...csv_keys.slice(0, 5), "size", "size_unit", "particles", "dofs", ...csv_keys.slice(5), "command"];

function csv_line({ check, owner, tier }: Row): unknown[] {
  const { size, unit, particles, dofs } = check.resolution ?? {};
  const first = csv_keys.slice(0, 5).map((key) => check[key]);
  return [owner.name, tier, ...first, size, unit, particles, dofs, ...csv_keys.slice(5).map((key) => check[key]), owner.command];
}

function table_of(rows: Row[]): DataTable<Row> {
  return new DataTable({
    id: "verdict-table",
    caption: "Every check: value, reference, error, acceptance band and verdict",
    label: "Verdict table",
    noun: "checks",
    placeholder: "case, place, source …",
    file: "cleave-checks.csv",
    items: rows,
    columns,
    choices: [
      { label: "Tier", of: (row) => row.tier },
      { label: "Verdict", of: (row) => row.check.verdict },
      { label: "Solver", of: (row) => row.check.solver },
    ],
    text: searchable,
    line: (row) => ({ id: check_id(row), "data-row": String(row.index), class: row.check.verdict }),
    csv_head,
    csv_line,
  });
}

export function verdict_section({ rows }: Report): HTMLElement {
  if (rows.length === 0) return section("verdicts", "All checks", missing("results.json holds no check."));
  return section("verdicts", "All checks", ...table_of(rows).elements());
}

function missed_text(row: Row): string {
  const { check } = row;
  const what = [`${words(check.quantity)}${check.component ? ` ${check.component}` : ""} by ${check.solver}`, check.place, check.detail]
    .filter(Boolean)
    .join(", ");
  if (check.must_fail) return `${what}: the wrong reference was not caught.`;
  const measured = [
    typeof check.value === "number" ? quantity(check.value, check.unit) : "",
    typeof check.reference === "number" ? `reference ${quantity(check.reference, check.unit)}` : "",
    typeof check.error === "number" && check.error_kind !== "order" ? `error ${error_text(check.error, check.error_kind, check.unit)}` : "",
    typeof check.order === "number" ? `observed order ${number(check.order, 3)}` : "",
    `band ${band_cell(row)}`,
  ];
  return `${what}: ${measured.filter(Boolean).join(", ")}.`;
}

/// Only where a band was missed: what and where, before anything else.
export function missed_section({ rows }: Report): HTMLElement | null {
  const missed = rows.filter((row) => row.check.verdict === "fail");
  if (missed.length === 0) return null;
  const items = missed.map((row) => el("li", {}, el("a", { href: `#${case_id(row.owner)}` }, row.owner.name), `: ${missed_text(row)}`));
  return section("missed", "Missed bands", el("ul", {}, ...items));
}
