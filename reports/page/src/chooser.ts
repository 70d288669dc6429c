// One thing at a time out of many: a search and a chain of lists, each narrowed by those before it. By mouse, keyboard and screen reader.

import { el } from "./dom";

export interface ChooserLevel<Item> {
  label: string;
  of: (item: Item) => string;
}

export interface ChooserSpec<Item> {
  label: string; ///< of the controls, for screen readers
  noun: string; ///< what an item is, in the plural
  placeholder: string;
  items: Item[]; ///< at least one
  levels: ChooserLevel<Item>[]; ///< items alike on every level are told apart by a number
  text: (item: Item) => string; ///< that the search looks through
  show: (item: Item) => void; ///< called with the first item at once, then with each one chosen
}

interface Entry<Item> {
  item: Item;
  path: string[];
  text: string;
}

function entries_of<Item>({ items, levels, text }: ChooserSpec<Item>): Entry<Item>[] {
  const times = new Map<string, number>();
  return items.map((item) => {
    const path = levels.map(({ of }) => of(item));
    const key = JSON.stringify(path);
    const time = (times.get(key) ?? 0) + 1;
    times.set(key, time);
    if (time > 1) path[path.length - 1] += ` (${time})`;
    return { item, path, text: text(item).toLowerCase() };
  });
}

export class Chooser<Item> {
  readonly element: HTMLElement;
  readonly status = el("p", { class: "status", role: "status", "aria-live": "polite" });
  private readonly entries_: Entry<Item>[];
  private readonly search_: HTMLInputElement;
  private readonly selects_: HTMLSelectElement[];
  private readonly steps_: HTMLButtonElement[];
  private open_: Entry<Item>[]; ///< those that the search leaves
  private shown_: Entry<Item> | null = null;

  constructor(private readonly spec_: ChooserSpec<Item>) {
    this.entries_ = entries_of(spec_);
    this.open_ = this.entries_;
    this.search_ = el("input", { type: "search", placeholder: spec_.placeholder });
    this.search_.addEventListener("input", () => this.filter());
    this.selects_ = spec_.levels.map((_, i) => {
      const select = el("select");
      select.addEventListener("change", () => this.take(i));
      return select;
    });
    this.steps_ = [this.step_button("Previous", -1), this.step_button("Next", 1)];
    const lists = spec_.levels.map(({ label }, i) => el("label", {}, label, this.selects_[i]));
    this.element = el(
      "div",
      { class: "filters chooser", role: "search", "aria-label": spec_.label },
      el("label", {}, "Search", this.search_),
      ...lists,
      el("span", { class: "steps" }, ...this.steps_),
    );
    this.show(this.entries_[0]);
  }

  /// Shows an item of the list; the search is cleared, so that it stands in the lists.
  choose(item: Item): void {
    const found = this.entries_.find((entry) => entry.item === item);
    if (!found) return;
    this.search_.value = "";
    this.open_ = this.entries_;
    this.show(found);
  }

  private step_button(title: string, by: number): HTMLButtonElement {
    const button = el("button", { type: "button" }, title);
    button.addEventListener("click", () => {
      const at = this.open_.findIndex((entry) => entry === this.shown_);
      this.show(this.open_[(at + by + this.open_.length) % this.open_.length]);
    });
    return button;
  }

  /// The first item that agrees with the lists up to `level`, and with those after it as far as it can.
  private take(level: number): void {
    const wanted = this.selects_.map((select) => select.value);
    const agrees = ({ path }: Entry<Item>): number => path.findIndex((value, i) => value !== wanted[i]);
    let best: Entry<Item> | null = null;
    let reach = level;
    for (const entry of this.open_) {
      const differs = agrees(entry);
      const same = differs < 0 ? wanted.length : differs;
      if (same > reach) [best, reach] = [entry, same];
    }
    if (best) this.show(best);
  }

  private filter(): void {
    const sought = this.search_.value.toLowerCase().split(/\s+/).filter(Boolean);
    this.open_ = this.entries_.filter(({ text }) => sought.every((word) => text.includes(word)));
    if (this.open_.length === 0) this.status.textContent = `None of ${this.entries_.length} ${this.spec_.noun} matches; the last one stays.`;
    for (const control of [...this.selects_, ...this.steps_]) control.disabled = this.open_.length === 0;
    if (this.open_.length > 0) this.show(this.open_.find((entry) => entry === this.shown_) ?? this.open_[0]);
  }

  private show(entry: Entry<Item>): void {
    const before = this.shown_;
    this.shown_ = entry;
    let rest = this.open_;
    this.selects_.forEach((select, i) => {
      const values = [...new Set(rest.map(({ path }) => path[i]))];
      select.replaceChildren(...values.map((value) => el("option", { value }, value)));
      select.value = entry.path[i];
      rest = rest.filter(({ path }) => path[i] === entry.path[i]);
    });
    const searched = this.open_.length < this.entries_.length ? ` that match, of ${this.entries_.length}` : "";
    this.status.textContent = `${this.open_.indexOf(entry) + 1} of ${this.open_.length} ${this.spec_.noun}${searched}`;
    if (entry !== before) this.spec_.show(entry.item);
  }
}
