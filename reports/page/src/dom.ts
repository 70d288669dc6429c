// A few lines instead of a framework.

type Child = Node | string | null;

export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  for (const child of children) if (child !== null) element.append(child);
  return element;
}

/// A section with its heading. Sections without data say why in one line (see `missing`).
export function section(id: string, title: string, ...children: Child[]): HTMLElement {
  return el("section", { id, "aria-labelledby": `${id}-title` }, el("h2", { id: `${id}-title` }, title), ...children);
}

export function missing(why: string): HTMLElement {
  return el("p", { class: "missing" }, why);
}

/// A first line and smaller ones below it; empty ones are left out.
export function lines(first: Node | string, ...others: (Node | string)[]): Node {
  return el("span", {}, first, ...others.filter((text) => text !== "").map((text) => el("small", {}, text)));
}

/// A table that scrolls inside its own frame, by finger, wheel or arrow keys.
export function scroll_frame(label: string, table: HTMLTableElement): HTMLElement {
  return el("div", { class: "scroll", role: "region", tabindex: "0", "aria-label": label }, table);
}

/// The beginning of a text, up to a space.
export function beginning(text: string, room = 70): string {
  return text.length <= room ? text : `${text.slice(0, text.lastIndexOf(" ", room))} …`;
}

/// What opens on demand, so that a line of the table stays a line; on a narrow screen one word of it.
export function folded(start: string, content: Node | string): HTMLElement {
  return el("details", {}, el("summary", {}, el("span", { class: "wide-only" }, start), el("span", { class: "narrow-only" }, "why")), content);
}

/// A text in a table: as it is where it is short and the screen wide, else on demand.
export function foldable(text: string): HTMLElement {
  if (text.length > 90) return folded(beginning(text), text);
  const narrow = folded(text, text);
  narrow.classList.add("narrow-only");
  return el("span", {}, el("span", { class: "wide-only" }, text), narrow);
}

/// Terms and what they are.
export function facts(entries: [string, Node | string][]): HTMLElement {
  return el("dl", { class: "facts" }, ...entries.map(([term, what]) => el("div", {}, el("dt", {}, term), el("dd", {}, what))));
}

export interface PlainColumn {
  title: string;
  numeric?: boolean;
}

export function plain_table(caption: string, columns: PlainColumn[], rows: (string | Node)[][]): HTMLTableElement {
  const kind = (i: number): Record<string, string> => (columns[i].numeric ? { class: "number" } : {});
  const head = el("tr", {}, ...columns.map((column, i) => el("th", { scope: "col", ...kind(i) }, column.title)));
  const lines = rows.map((cells) =>
    el("tr", {}, ...cells.map((cell, i) => (i === 0 ? el("th", { scope: "row" }, cell) : el("td", kind(i), cell)))),
  );
  return el("table", {}, el("caption", {}, caption), el("thead", {}, head), el("tbody", {}, ...lines));
}
