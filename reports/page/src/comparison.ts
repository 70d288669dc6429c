// The central table: quantity by quantity what the particles, the finite elements and mathematics say, and how far each pair is apart.

import { case_id, check_id, type Difference, type Line, type Report, type Row, type Statement } from "./data";
import { DataTable, type Column } from "./data_table";
import { beginning, el, foldable, folded, lines, missing, section } from "./dom";
import { band_text, dash, error_text, quantity, words } from "./format";
import { marks } from "./verdict_table";

type Side = "particles" | "fem" | "mathematics";
type Pair = "particles_fem" | "particles_mathematics" | "fem_mathematics";

const pair_titles: Record<Pair, string> = {
  particles_fem: "Particles − FEM",
  particles_mathematics: "Particles − mathematics",
  fem_mathematics: "FEM − mathematics",
};
const pairs = Object.keys(pair_titles) as Pair[];

function breakable(text: string): string {
  return text.replace(/[._]/g, "$&\u200b");
}

function statement_cell(side: Side): (item: Line) => Node | string {
  return ({ line }) => {
    const one: Statement | null | undefined = line[side];
    if (!one) return el("span", { class: "none" }, dash);
    return lines(quantity(one.value, line.unit), side === "mathematics" ? one.by : el("code", {}, breakable(one.by)));
  };
}

function judge_of({ line, checks }: Line, pair: Pair): Row | null {
  const number = line[pair]?.check;
  return typeof number === "number" ? (checks.get(number) ?? null) : null;
}

function verdict_link(row: Row): Node {
  const { check } = row;
  const name = `${check.verdict}: ${words(check.quantity)} by ${check.solver}`;
  const mark = el("span", { "aria-hidden": "true" }, marks[check.verdict]);
  return el("a", { class: `mark ${check.verdict}`, href: `#${check_id(row)}`, "aria-label": name }, mark, ` ${check.verdict}`);
}

function difference_cell(pair: Pair): (item: Line) => Node | string {
  return (item) => {
    const one: Difference | null | undefined = item.line[pair];
    if (!one) return el("span", { class: "none" }, dash);
    const row = judge_of(item, pair);
    const amount = error_text(one.error, one.error_kind, item.line.unit);
    if (!row) return lines(amount, "for the record");
    if (!row.check.band) return lines(amount, verdict_link(row));
    return lines(amount, band_text(row.check.band, row.check.unit), verdict_link(row));
  };
}

/// Each reason once, with the pairs that share it.
function basis_cell(item: Line): Node | string {
  const reasons = new Map<string, string[]>();
  for (const pair of pairs) {
    const basis = judge_of(item, pair)?.check.basis;
    if (basis) reasons.set(basis, [...(reasons.get(basis) ?? []), pair_titles[pair]]);
  }
  if (reasons.size === 0) return dash;
  const [first] = reasons.keys();
  if (reasons.size > 1) {
    const parts = [...reasons].map(([basis, of]) => el("span", { class: "reason" }, el("small", {}, of.join(", ")), basis));
    return folded(`${reasons.size} reasons: ${beginning(first, 50)}`, el("span", {}, ...parts));
  }
  return foldable(first);
}

function worst_verdict(item: Line): string {
  const found = item.line.checks.map((number) => item.checks.get(number)?.check.verdict);
  return found.includes("fail") ? "fail" : found.includes("pass") ? "pass" : "info";
}

function sides_of({ line }: Line): string {
  const present = [line.particles && "particles", line.fem && "FEM", line.mathematics && "mathematics"].filter(Boolean);
  return present.join(" + ");
}

function case_cell({ line, owner, checks }: Line): Node {
  const link = el("a", { href: `#${case_id(owner)}` }, breakable(owner.name));
  const tier = line.checks.map((number) => checks.get(number)?.tier).find(Boolean) ?? owner.tier ?? "";
  return lines(link, words(tier), (owner.symmetry ?? []).join(", "));
}

const value_column = (key: Side, title: string): Column<Line> => ({
  key,
  title,
  numeric: true,
  sort: ({ line }) => line[key]?.value ?? null,
  cell: statement_cell(key),
});

const columns: Column<Line>[] = [
  { key: "case", title: "Case", head: true, sort: ({ owner }) => owner.name, cell: case_cell },
  {
    key: "quantity",
    title: "Quantity",
    sort: ({ line }) => line.quantity,
    cell: ({ line }) => lines(words(line.quantity), line.component ?? "", line.place ?? ""),
  },
  value_column("particles", "Particles"),
  value_column("fem", "FEM"),
  value_column("mathematics", "Mathematics"),
  ...pairs.map(
    (pair): Column<Line> => ({
      key: pair,
      title: pair_titles[pair],
      numeric: true,
      sort: ({ line }) => line[pair]?.error ?? null,
      cell: difference_cell(pair),
    }),
  ),
  { key: "basis", title: "Why these bands", sort: (item) => item.line.checks.length, cell: basis_cell },
];

const csv_head = [
  "case",
  "symmetry",
  "quantity",
  "component",
  "unit",
  "place",
  ...["particles", "fem", "mathematics"].flatMap((side) => [`${side}_by`, `${side}_value`]),
  ...pairs.flatMap((pair) => [`${pair}_error`, `${pair}_kind`, `${pair}_band`, `${pair}_basis`, `${pair}_verdict`]),
  "command",
];

function csv_line(item: Line): unknown[] {
  const { line, owner } = item;
  return [
    owner.name,
    (owner.symmetry ?? []).join("; "),
    line.quantity,
    line.component,
    line.unit,
    line.place,
    ...[line.particles, line.fem, line.mathematics].flatMap((one) => [one?.by, one?.value]),
    ...pairs.flatMap((pair) => {
      const check = judge_of(item, pair)?.check;
      return [line[pair]?.error, line[pair]?.error_kind, check?.band, check?.basis, check?.verdict];
    }),
    owner.command,
  ];
}

function searchable({ line, owner }: Line): string {
  const sides = [line.particles, line.fem, line.mathematics].map((one) => one?.by ?? "");
  return [owner.name, owner.about, ...(owner.symmetry ?? []), line.quantity, line.component, line.place, ...sides].filter(Boolean).join(" ");
}

export function comparison_section({ lines: items }: Report): HTMLElement {
  const title = "Particles, finite elements, mathematics";
  if (items.length === 0) return section("comparison", title, missing("results.json holds no comparison."));
  const lead =
    "Each quantity of each case on its finest mesh, as all three have it, and how far each pair is apart. A verdict leads to its check; " +
    "“for the record” is measured but has no band. Fields are compared by the norm of their difference, so their sizes may agree better than they do. " +
    "A dash: this case did not ask that side.";
  const table = new DataTable<Line>({
    id: "comparison-table",
    caption: "Particles, finite elements and mathematics side by side: values, pairwise differences, bands and why the bands are that wide",
    label: "Comparison table",
    noun: "lines",
    placeholder: "case, quantity, source …",
    file: "cleave-comparison.csv",
    items,
    columns,
    choices: [
      { label: "Quantity", of: ({ line }) => line.quantity },
      { label: "Verdict", of: worst_verdict },
      { label: "Sides", of: sides_of },
    ],
    text: searchable,
    line: (item) => ({ id: `line-${item.index}`, "data-row": String(item.index), class: worst_verdict(item) }),
    csv_head,
    csv_line,
  });
  return section("comparison", title, el("p", {}, lead), ...table.elements());
}
