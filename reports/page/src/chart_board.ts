// Charts by Apache ECharts, drawn as SVG. The board redraws them when the colour scheme, the width or the medium changes.

import { LineChart, ScatterChart } from "echarts/charts";
import { GridComponent, LegendComponent, TooltipComponent } from "echarts/components";
import * as echarts from "echarts/core";
import { SVGRenderer } from "echarts/renderers";
import type { EChartsCoreOption, EChartsType } from "echarts/core";
import { el } from "./dom";

echarts.use([LineChart, ScatterChart, GridComponent, LegendComponent, TooltipComponent, SVGRenderer]);

export interface Colours {
  ink: string;
  faint: string;
  rule: string;
  paper: string;
  series: string[];
}

export const symbols = ["circle", "triangle", "diamond", "rect"];
const series_count = 6;

function read_colours(): Colours {
  const style = getComputedStyle(document.documentElement);
  const value = (name: string): string => style.getPropertyValue(name).trim();
  const series = Array.from({ length: series_count }, (_, i) => value(`--series-${i + 1}`));
  return { ink: value("--ink"), faint: value("--faint"), rule: value("--rule"), paper: value("--paper"), series };
}

export interface LegendItem {
  series: string[];
  text: string;
  index: number;
  dashed?: boolean;
  line?: boolean;
}

/// One chart: its legend is HTML (wraps, can be read aloud, switches curves), its option is made for given colours.
export interface Panel {
  title: string;
  description: string; ///< for readers who do not see the chart
  legend: LegendItem[];
  option: (colours: Colours) => EChartsCoreOption;
  notes: string[]; ///< lines of the caption
  facts?: HTMLElement; ///< what the chart says, in words
  extra?: HTMLElement; ///< numbers behind the chart
  key: string; ///< of what is shown, for tests: data-shown of the figure
}

function swatch(item: LegendItem): SVGSVGElement {
  const shapes = [
    '<circle cx="14" cy="6" r="4"/>',
    '<path d="M14 1.5 18.5 10h-9z"/>',
    '<path d="M14 1l5 5-5 5-5-5z"/>',
    '<path d="M10 2h8v8h-8z"/>',
  ];
  const holder = document.createElement("div");
  const rule =
    item.dashed || item.line
      ? `<path d="M0 6h28" fill="none" stroke="currentColor" stroke-width="2"${item.dashed ? ' stroke-dasharray="5 4"' : ""}/>`
      : "";
  const mark = item.dashed || item.index < 0 ? "" : shapes[item.index % shapes.length];
  const colour = item.index < 0 ? "var(--ink)" : `var(--series-${(item.index % series_count) + 1})`;
  const look = `viewBox="0 0 28 12" aria-hidden="true" fill="currentColor" style="color:${colour}"`;
  holder.innerHTML = `<svg width="28" height="12" ${look}>${rule}${mark}</svg>`;
  return holder.firstElementChild as SVGSVGElement;
}

function toggle(item: LegendItem, canvas: HTMLElement): HTMLElement {
  const button = el("button", { type: "button", "aria-pressed": "true" }, swatch(item), el("span", {}, item.text));
  button.addEventListener("click", () => {
    const shown = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(shown));
    const chart = echarts.getInstanceByDom(canvas);
    for (const name of item.series) chart?.dispatchAction({ type: shown ? "legendSelect" : "legendUnSelect", name });
  });
  return button;
}

function figure(panel: Panel, canvas: HTMLElement): HTMLElement {
  const caption = el("figcaption", {}, el("h3", {}, panel.title));
  const legend = el("ul", { class: "legend" }, ...panel.legend.map((item) => el("li", {}, toggle(item, canvas))));
  const notes = panel.notes.map((note) => el("p", { class: "note" }, note));
  const side = el("div", { class: "side" }, legend, panel.facts ?? null, ...notes, panel.extra ?? null);
  return el("figure", { class: "panel", "data-shown": panel.key }, caption, canvas, side);
}

/// Holds one chart at a time.
export class ChartSlot {
  readonly element: HTMLElement;
  private chart_: EChartsType | null = null;
  private shown_: { panel: Panel; canvas: HTMLElement } | null = null;

  constructor(id: string) {
    this.element = el("div", { class: "chosen", id });
  }

  show(panel: Panel): void {
    this.clear();
    const canvas = el("div", { class: "chart", role: "img", "aria-label": panel.description });
    this.shown_ = { panel, canvas };
    this.element.replaceChildren(figure(panel, canvas));
    if (this.element.isConnected) this.draw();
  }

  /// Where there is nothing to draw.
  show_note(note: HTMLElement): void {
    this.clear();
    this.element.replaceChildren(note);
  }

  /// The slot must be in the document, so that its chart has a size.
  draw(): void {
    if (!this.shown_) return;
    this.chart_ ??= echarts.init(this.shown_.canvas, null, { renderer: "svg" });
    this.chart_.resize();
    this.chart_.setOption(this.shown_.panel.option(read_colours()));
  }

  resize(): void {
    this.chart_?.resize();
  }

  private clear(): void {
    this.chart_?.dispose();
    this.chart_ = null;
    this.shown_ = null;
  }
}

export class ChartBoard {
  private readonly slots_: ChartSlot[] = [];

  /// `id`: of its element, so that links can lead to it.
  slot(id: string): ChartSlot {
    const made = new ChartSlot(id);
    this.slots_.push(made);
    return made;
  }

  /// Draws all slots, once they are in the document; from then on they follow its width, medium and colours by themselves.
  draw(): void {
    const redraw = (): void => this.slots_.forEach((slot) => slot.draw());
    redraw();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
    matchMedia("print").addEventListener("change", redraw);
    addEventListener("resize", () => this.slots_.forEach((slot) => slot.resize()));
  }
}

export interface AxisSpec {
  name: string;
  min: number;
  max: number;
  ticks: number[];
  label: (value: number) => string;
}

/// An axis with ticks of our choice, in the page's colours.
export function axis(spec: AxisSpec, colours: Colours, vertical: boolean): Record<string, unknown> {
  return {
    type: "value",
    min: spec.min,
    max: spec.max,
    name: spec.name,
    nameLocation: vertical ? "end" : "middle",
    nameGap: vertical ? 14 : 30,
    nameTextStyle: { color: colours.ink, fontSize: 12, align: vertical ? "left" : "center" },
    axisLine: { show: true, onZero: false, lineStyle: { color: colours.faint } },
    axisTick: { show: true, customValues: spec.ticks, lineStyle: { color: colours.faint } },
    axisLabel: { color: colours.ink, fontSize: 12, customValues: spec.ticks, formatter: spec.label, hideOverlap: true },
    splitLine: { show: true, customValues: spec.ticks, lineStyle: { color: colours.rule } },
  };
}

/// What every chart shares: no animation (a picture of data, and the same DOM each time), tooltip and grid.
export function base_option(colours: Colours): Record<string, unknown> {
  return {
    animation: false,
    textStyle: { fontFamily: "inherit", color: colours.ink },
    grid: { left: 8, right: 20, top: 34, bottom: 40, outerBoundsMode: "same", outerBoundsContain: "axisLabel" },
    legend: { show: false },
    tooltip: {
      trigger: "item",
      confine: true,
      backgroundColor: colours.paper,
      borderColor: colours.faint,
      textStyle: { color: colours.ink, fontSize: 12 },
    },
  };
}
