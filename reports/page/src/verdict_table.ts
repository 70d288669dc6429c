import { case_id, type Report, type Row } from "./data";
import { el, missing, scroll_frame, section } from "./dom";
import { band_text, dash, error_text, number, quantity, words } from "./format";

interface Column {
  key: string;
  title: string;
  numeric?: boolean;
  sort: (row: Row) => string | number | null;
  cell: (row: Row) => Node | string;
}

const marks = { pass: "✓", fail: "✗", info: "·" };

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

/// A first line and smaller ones below it; empty ones are left out.
function lines(first: Node | string, ...others: string[]): Node {
  return el("span", {}, first, ...others.filter(Boolean).map((text) => el("small", {}, text)));
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

const columns: Column[] = [
  { key: "verdict", title: "Verdict", sort: ({ check }) => ["fail", "info", "pass"].indexOf(check.verdict), cell: verdict_cell },
  { key: "case", title: "Case", sort: (row) => row.owner.name, cell: case_cell },
  {
    key: "quantity",
    title: "Quantity",
    sort: ({ check }) => check.quantity,
    cell: ({ check }) => lines(words(check.quantity), check.component ?? ""),
  },
  { key: "place", title: "Place", sort: ({ check }) => check.place ?? "", cell: ({ check }) => check.place || dash },
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
  { key: "basis", title: "Why this band", sort: ({ check }) => check.basis ?? "", cell: ({ check }) => check.basis || dash },
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
    check.solver,
    check.reference_source,
    check.basis,
    check.must_fail ? "must-fail twin" : "",
    parameters_text(row),
  ]
    .filter(Boolean)
    .join(" ")
    .toLowerCase();
}

function table_line(row: Row): HTMLTableRowElement {
  const cells = columns.map((column) =>
    column.key === "case"
      ? el("th", { scope: "row" }, column.cell(row))
      : el("td", { class: `${column.key}${column.numeric ? " number" : ""}` }, column.cell(row)),
  );
  return el("tr", { "data-row": String(row.index), class: row.check.verdict }, ...cells);
}

/// Nulls last in both directions.
function compare(a: string | number | null, b: string | number | null, sign: number): number {
  if (a === null || b === null) return a === b ? 0 : a === null ? 1 : -1;
  return sign * (typeof a === "number" && typeof b === "number" ? a - b : String(a).localeCompare(String(b), "en"));
}

function csv_cell(value: unknown): string {
  const text = value === null || value === undefined ? "" : typeof value === "object" ? JSON.stringify(value) : String(value);
  return /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
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

function csv(rows: Row[]): string {
  const head = ["case", "tier", ...csv_keys.slice(0, 5), "size", "size_unit", "particles", "dofs", ...csv_keys.slice(5), "command"];
  const line = ({ check, owner, tier }: Row): unknown[] => {
    const { size, unit, particles, dofs } = check.resolution ?? {};
    return [
      owner.name,
      tier,
      ...csv_keys.slice(0, 5).map((key) => check[key]),
      size,
      unit,
      particles,
      dofs,
      ...csv_keys.slice(5).map((key) => check[key]),
      owner.command,
    ];
  };
  return [head, ...rows.map(line)].map((cells) => cells.map(csv_cell).join(",")).join("\n") + "\n";
}

function download(name: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: "text/csv;charset=utf-8" }));
  el("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

function choice(label: string, values: string[]): { field: HTMLElement; select: HTMLSelectElement } {
  const select = el("select", {}, el("option", { value: "" }, "all"), ...values.map((value) => el("option", { value }, words(value))));
  return { field: el("label", {}, label, select), select };
}

/// The table of all checks: filter by text, tier, verdict, solver; sort by any column (again: reversed, a third time: file order).
class VerdictTable {
  private readonly lines_: { row: Row; line: HTMLTableRowElement; text: string }[];
  private readonly body_ = el("tbody");
  private readonly status_ = el("p", { class: "status", role: "status", "aria-live": "polite" });
  private readonly heads_: HTMLTableCellElement[] = [];
  private readonly search_ = el("input", { type: "search", placeholder: "case, place, source …" });
  private readonly selects_: { select: HTMLSelectElement; of: (row: Row) => string }[] = [];
  private readonly filters_ = el("div", { class: "filters", role: "search", "aria-label": "Filter the checks" });

  constructor(rows: Row[]) {
    this.lines_ = rows.map((row) => ({ row, line: table_line(row), text: searchable(row) }));
    this.search_.addEventListener("input", () => this.filter());
    this.filters_.append(el("label", {}, "Search", this.search_));
    this.add_choice("Tier", rows, (row) => row.tier);
    this.add_choice("Verdict", rows, (row) => row.check.verdict);
    this.add_choice("Solver", rows, (row) => row.check.solver);
    const button = el("button", { type: "button", class: "download" }, "Download these rows as CSV");
    button.addEventListener("click", () => download("cleave-checks.csv", csv(this.shown())));
    this.filters_.append(button);
    this.body_.append(...this.lines_.map(({ line }) => line));
    this.filter();
  }

  elements(): HTMLElement[] {
    const head = el("tr", {}, ...columns.map((column, i) => this.head(column, i)));
    const caption = el("caption", {}, "Every check: value, reference, error, acceptance band and verdict");
    const table = el("table", { id: "verdict-table" }, caption, el("thead", {}, head), this.body_);
    return [this.filters_, this.status_, scroll_frame("Verdict table", table)];
  }

  private add_choice(label: string, rows: Row[], of: (row: Row) => string): void {
    const { field, select } = choice(label, [...new Set(rows.map(of))].sort());
    select.addEventListener("change", () => this.filter());
    this.selects_.push({ select, of });
    this.filters_.append(field);
  }

  private head(column: Column, i: number): HTMLTableCellElement {
    const button = el("button", { type: "button" }, column.title, el("span", { class: "arrow", "aria-hidden": "true" }));
    const head = el("th", { scope: "col", "aria-sort": "none", class: `${column.key}${column.numeric ? " number" : ""}` }, button);
    button.addEventListener("click", () => this.sort(i));
    this.heads_.push(head);
    return head;
  }

  private sort(i: number): void {
    const next = { none: "ascending", ascending: "descending", descending: "none" } as const;
    const order = next[(this.heads_[i].getAttribute("aria-sort") ?? "none") as keyof typeof next];
    this.heads_.forEach((head, j) => head.setAttribute("aria-sort", i === j ? order : "none"));
    const key = columns[i].sort;
    const sign = order === "descending" ? -1 : 1;
    const sorted = [...this.lines_];
    if (order !== "none") sorted.sort((a, b) => compare(key(a.row), key(b.row), sign) || a.row.index - b.row.index);
    this.body_.append(...sorted.map(({ line }) => line));
  }

  private filter(): void {
    const sought = this.search_.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const { row, line, text } of this.lines_) {
      const chosen = this.selects_.every(({ select, of }) => select.value === "" || select.value === of(row));
      line.hidden = !chosen || !sought.every((word) => text.includes(word));
    }
    this.status_.textContent = `${this.shown().length} of ${this.lines_.length} checks shown`;
  }

  private shown(): Row[] {
    return this.lines_.filter(({ line }) => !line.hidden).map(({ row }) => row);
  }
}

export function verdict_section({ rows }: Report): HTMLElement {
  if (rows.length === 0) return section("verdicts", "Verdicts", missing("results.json holds no check."));
  return section("verdicts", "Verdicts", ...new VerdictTable(rows).elements());
}

function missed_text(row: Row): string {
  const { check } = row;
  const what = [`${words(check.quantity)}${check.component ? ` ${check.component}` : ""} by ${check.solver}`, check.place]
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
