// Per case the stress of particles and finite elements side by side in 3D, with one colour scale, and their difference with its own.

import { Chooser } from "./chooser";
import type { Report, Row } from "./data";
import { el, missing, plain_table, scroll_frame, section } from "./dom";
import { FieldViews } from "./field_views";
import { number, percent, quantity, words } from "./format";
import { has_webgl } from "./stage";
import {
  colouring_of,
  colours_of,
  difference_range,
  diverging,
  gradient_of,
  points_of,
  sequential,
  shared_range,
  type FieldMeasure,
  type Points,
  type Range,
  type StressField,
} from "./stress_field";

interface Shown {
  row: Row;
  file: string;
  title: string;
  field: StressField;
}

const measure_title = (name: string): string => (name === "largest_principal" ? "largest principal stress" : `stress ${name}`);

/// Each file once; those that cannot be drawn are told apart by their note.
function fields_of(report: Report): Shown[] {
  const found = new Map<string, Shown>();
  for (const row of report.rows)
    for (const { file, title } of row.check.artifacts ?? []) {
      const field = row.source.fields?.[file];
      const key = `${row.source.folder}|${file}`;
      if (field && !found.has(key)) found.set(key, { row, file, title: title ?? file, field });
    }
  return [...found.values()];
}

function bar(title: string, stops: [number, number, number][], { low, high, beyond }: Range): HTMLElement {
  const digits = 3 + Math.max(0, Math.round(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / (high - low)))); // neighbours must differ
  const ticks = [0, 0.25, 0.5, 0.75, 1].map((share) => el("span", {}, quantity(low + share * (high - low), "Pa", digits)));
  const strip = el("div", { class: "strip", "aria-hidden": "true" });
  strip.style.background = gradient_of(stops);
  const outside = beyond > 0 ? `; ${percent(beyond)} of the volume lies beyond and takes the colour of the end` : "";
  return el("div", { class: "bar" }, el("p", { class: "note" }, `${title}${outside}`), strip, el("div", { class: "ticks" }, ...ticks));
}

function in_words({ name, fem_rms, difference_rms, difference_max, at }: FieldMeasure, { total, shown, particles, fem }: StressField): string {
  const thinned = shown < total ? `; ${number(shown)} of them are drawn, evenly chosen` : "";
  return (
    `Difference of the ${measure_title(name)}, ${particles} less ${fem}: rms ${quantity(difference_rms, "Pa", 3)}, ` +
    `${percent(fem_rms > 0 ? difference_rms / fem_rms : null)} of the rms of ${fem}; largest ${quantity(difference_max, "Pa", 3)} ` +
    `at (${at.map((x) => number(x, 3)).join(", ")}) m. Over all ${number(total)} points, by volume${thinned}.`
  );
}

function numbers_of({ measures, fem }: StressField): HTMLElement {
  const rows = measures.map(({ name, fem_rms, difference_rms, difference_max }) => [
    measure_title(name),
    quantity(fem_rms, "Pa", 3),
    quantity(difference_rms, "Pa", 3),
    percent(fem_rms > 0 ? difference_rms / fem_rms : null),
    quantity(difference_max, "Pa", 3),
  ]);
  const columns = [{ title: "Measure" }, ...[`${fem}, rms`, "Difference, rms", "Share", "Difference, largest"].map((title) => ({ title, numeric: true }))];
  return scroll_frame("Differences in numbers", plain_table("Difference of particles and finite elements by measure", columns, rows));
}

/// The panel of the chosen field: views, scales, words and numbers.
class FieldPanel {
  readonly element: HTMLElement;
  readonly controls: HTMLElement[];
  private readonly views_: FieldViews | null;
  private readonly frame_: HTMLElement;
  private readonly titles_ = ["", "", ""].map((text) => el("p", {}, text));
  private readonly scales_ = el("div", { class: "scales" });
  private readonly words_ = el("p", { class: "note", role: "status", "aria-live": "polite", id: "fields-words" });
  private readonly numbers_ = el("div");
  private readonly measure_ = el("select");
  private readonly axis_: HTMLSelectElement;
  private readonly depth_ = el("input", { type: "range", min: "0", max: "1", step: "0.01", value: "0.5", "aria-label": "Place of the cut" });
  private shown_: Shown | null = null;
  private points_: Points | null = null;

  constructor() {
    const cells = this.titles_.map((title) => el("div", { class: "field-view" }, title));
    this.frame_ = el("div", { class: "field-frame", role: "group", tabindex: "0", "aria-describedby": "fields-words" }, ...cells);
    this.frame_.setAttribute("aria-label", "Particles, finite elements and their difference in three views that turn together");
    const axes = ["none", "x", "y", "z"].map((name, i) => el("option", { value: String(i - 1) }, name === "none" ? name : `across ${name}`));
    this.axis_ = el("select", {}, ...axes);
    this.views_ = has_webgl() ? new FieldViews(this.frame_, cells) : null;
    this.measure_.addEventListener("change", () => this.colour());
    for (const control of [this.axis_, this.depth_]) control.addEventListener("input", () => this.cut());
    this.controls = [el("label", {}, "Stress", this.measure_), el("label", {}, "Cut", this.axis_), el("label", { class: "depth" }, "Place of the cut", this.depth_)];
    const help = "Drag or press the arrow keys to turn all three, + and − (or the wheel, once clicked) to approach, Home for the first view.";
    const drawn = this.views_
      ? [this.frame_, this.scales_, el("p", { class: "note" }, help)]
      : [missing("This browser has no WebGL: the fields cannot be drawn here. Their differences stand below.")];
    this.element = el("div", { class: "fields", id: "fields-shown" }, ...drawn, this.words_, this.numbers_);
  }

  show(shown: Shown): void {
    this.shown_ = shown;
    const { field } = shown;
    const measure = this.measure_.value;
    this.measure_.replaceChildren(...field.measures.map(({ name }) => el("option", { value: name }, measure_title(name))));
    if (field.measures.some(({ name }) => name === measure)) this.measure_.value = measure;
    this.points_ = points_of(field);
    this.numbers_.replaceChildren(numbers_of(field));
    this.titles_.forEach((title, i) => (title.textContent = [`Particles: ${field.particles}`, `Finite elements: ${field.fem}`, "Particles − finite elements"][i]));
    this.colour();
    this.cut();
  }

  private colour(): void {
    if (!this.shown_ || !this.points_) return;
    const { field, file } = this.shown_;
    const name = this.measure_.value;
    const values = colouring_of(field, name);
    const [shared, apart] = [shared_range(values, this.points_.volume), difference_range(values, this.points_.volume)];
    this.views_?.show(this.points_, [colours_of(values.particles, shared, sequential), colours_of(values.fem, shared, sequential), colours_of(values.difference, apart, diverging)]);
    this.scales_.replaceChildren(bar(`Both: ${measure_title(name)}`, sequential, shared), bar("Difference", diverging, apart));
    const measure = field.measures.find((one) => one.name === name);
    this.words_.textContent = measure ? in_words(measure, field) : "";
    this.frame_.dataset.shown = file;
    this.frame_.dataset.measure = name;
  }

  private cut(): void {
    const axis = Number(this.axis_.value);
    this.depth_.disabled = axis < 0;
    if (axis < 0 || !this.points_) {
      this.views_?.cut(null);
      return;
    }
    const along = this.points_.position.filter((_, i) => i % 3 === axis);
    const [low, high] = [along.reduce((a, b) => Math.min(a, b), Infinity), along.reduce((a, b) => Math.max(a, b), -Infinity)];
    this.views_?.cut({ axis, at: low + Number(this.depth_.value) * (high - low) });
  }
}

export function fields_section(report: Report): HTMLElement {
  const title = "Stress of particles and finite elements in 3D";
  const all = fields_of(report);
  if (all.length === 0) return section("fields", title, missing("No case of these results has run both particles and finite elements on one body."));
  const drawable = all.filter(({ field }) => !field.note);
  const absent = all.filter(({ field }) => field.note).map(({ row, file, field }) => el("li", {}, `${words(row.owner.name)}, ${file}: ${field.note}.`));
  const notes = absent.length > 0 ? el("ul", { class: "note" }, ...absent) : null;
  if (drawable.length === 0) return section("fields", title, notes);
  const panel = new FieldPanel();
  const chooser = new Chooser<Shown>({
    label: "Choose a case",
    noun: "fields",
    placeholder: "case, solver …",
    items: drawable,
    levels: [
      { label: "Case", of: ({ row }) => row.owner.name },
      { label: "Field", of: (one) => one.title },
    ],
    text: ({ row, field, file }) => [row.owner.name, row.owner.about, field.particles, field.fem, file].filter(Boolean).join(" "),
    show: (one) => panel.show(one),
  });
  const lead =
    "Both solvers at the same points, the particles’ centres, each as solved unless its name says recovered: smoothed over its neighbours. One camera " +
    "and one scale for both. Balls stand for the particles’ volumes.";
  const controls = el("div", { class: "filters" }, ...panel.controls);
  return section("fields", title, el("p", {}, lead), chooser.element, chooser.status, controls, panel.element, notes);
}
