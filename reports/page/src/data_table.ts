// A table that filters by text and choices, sorts by any column, and gives the rows it shows as CSV. By mouse, keyboard and screen reader.

import { el, scroll_frame } from "./dom";
import { words } from "./format";

export interface Column<Item> {
  key: string;
  title: string;
  numeric?: boolean;
  head?: boolean; ///< names the row
  sort: (item: Item) => string | number | null;
  cell: (item: Item) => Node | string;
}

export interface Choice<Item> {
  label: string;
  of: (item: Item) => string;
}

export interface TableSpec<Item> {
  id: string;
  caption: string;
  label: string; ///< of the frame, for screen readers
  noun: string; ///< what a row is, in the plural
  placeholder: string;
  file: string; ///< of the CSV
  items: Item[];
  columns: Column<Item>[];
  choices: Choice<Item>[];
  text: (item: Item) => string; ///< that the search looks through
  line: (item: Item) => Record<string, string>; ///< attributes of the row
  csv_head: string[];
  csv_line: (item: Item) => unknown[];
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

export function csv(lines: unknown[][]): string {
  return lines.map((cells) => cells.map(csv_cell).join(",")).join("\n") + "\n";
}

function download(name: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: "text/csv;charset=utf-8" }));
  el("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

interface Line<Item> {
  item: Item;
  element: HTMLTableRowElement;
  text: string;
  index: number;
}

/// Sort: a press ascending, a second descending, a third as the results have them.
export class DataTable<Item> {
  private readonly lines_: Line<Item>[];
  private readonly body_ = el("tbody");
  private readonly status_ = el("p", { class: "status", role: "status", "aria-live": "polite" });
  private readonly heads_: HTMLTableCellElement[] = [];
  private readonly search_: HTMLInputElement;
  private readonly selects_: { select: HTMLSelectElement; of: (item: Item) => string }[] = [];
  private readonly filters_: HTMLElement;

  constructor(private readonly spec_: TableSpec<Item>) {
    this.lines_ = spec_.items.map((item, index) => ({ item, index, element: this.line(item), text: spec_.text(item).toLowerCase() }));
    this.search_ = el("input", { type: "search", placeholder: spec_.placeholder });
    this.search_.addEventListener("input", () => this.filter());
    this.filters_ = el("div", { class: "filters", role: "search", "aria-label": `Filter the ${spec_.noun}` });
    this.filters_.append(el("label", {}, "Search", this.search_));
    for (const choice of spec_.choices) this.add_choice(choice);
    const button = el("button", { type: "button", class: "download" }, "Download these rows as CSV");
    button.addEventListener("click", () => download(spec_.file, csv([spec_.csv_head, ...this.shown().map(spec_.csv_line)])));
    this.filters_.append(button);
    this.body_.append(...this.lines_.map(({ element }) => element));
    this.filter();
  }

  elements(): HTMLElement[] {
    const head = el("tr", {}, ...this.spec_.columns.map((column, i) => this.head(column, i)));
    const table = el("table", { id: this.spec_.id, class: "data" }, el("caption", {}, this.spec_.caption), el("thead", {}, head), this.body_);
    return [this.filters_, this.status_, scroll_frame(this.spec_.label, table)];
  }

  private line(item: Item): HTMLTableRowElement {
    const cells = this.spec_.columns.map((column) =>
      column.head
        ? el("th", { scope: "row", class: column.key }, column.cell(item))
        : el("td", { class: `${column.key}${column.numeric ? " number" : ""}` }, column.cell(item)),
    );
    return el("tr", this.spec_.line(item), ...cells);
  }

  private add_choice({ label, of }: Choice<Item>): void {
    const values = [...new Set(this.spec_.items.map(of))].sort();
    const select = el("select", {}, el("option", { value: "" }, "all"), ...values.map((value) => el("option", { value }, words(value))));
    select.addEventListener("change", () => this.filter());
    this.selects_.push({ select, of });
    this.filters_.append(el("label", {}, label, select));
  }

  private head(column: Column<Item>, i: number): HTMLTableCellElement {
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
    const key = this.spec_.columns[i].sort;
    const sign = order === "descending" ? -1 : 1;
    const sorted = [...this.lines_];
    if (order !== "none") sorted.sort((a, b) => compare(key(a.item), key(b.item), sign) || a.index - b.index);
    this.body_.append(...sorted.map(({ element }) => element));
  }

  private filter(): void {
    const sought = this.search_.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const { item, element, text } of this.lines_) {
      const chosen = this.selects_.every(({ select, of }) => select.value === "" || select.value === of(item));
      element.hidden = !chosen || !sought.every((word) => text.includes(word));
    }
    this.status_.textContent = `${this.shown().length} of ${this.lines_.length} ${this.spec_.noun} shown`;
  }

  private shown(): Item[] {
    return this.lines_.filter(({ element }) => !element.hidden).map(({ item }) => item);
  }
}
