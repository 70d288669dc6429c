// Error against size, both axes logarithmic: one ladder, the others of the same quantity pale beside it. The slope that is drawn dashed is
// the slope that was asserted of this ladder.

import { axis, base_option, symbols, type Colours, type LegendItem, type Panel } from "./chart_board";
import { case_id, type LadderStep, type Row } from "./data";
import { el, plain_table, scroll_frame } from "./dom";
import { number, quantity, superscript, unit_text, words } from "./format";
import { log_ticks, spread } from "./ticks";

interface Point {
  x: number;
  y: number;
  size: number;
  error: number;
}
interface Curve {
  row: Row;
  name: string;
  title: string;
  points: Point[];
  asserted: number | null;
  index: number;
  chosen: boolean;
}

export function asserted_order(row: Row): number | null {
  const order = row.check.band?.order_at_least;
  return typeof order === "number" ? order : null;
}

/// What the order was taken over: the representative size, where the results have it.
function size_of({ h, size }: LadderStep): number {
  return typeof h === "number" && h > 0 ? h : size;
}

function points_of(row: Row): Point[] {
  const points: Point[] = [];
  for (const step of row.check.ladder ?? []) {
    const { error } = step;
    const size = size_of(step);
    if (size > 0 && typeof error === "number" && error > 0) points.push({ x: Math.log10(size), y: Math.log10(error), size, error });
  }
  return points.sort((a, b) => a.x - b.x);
}

function group_key({ owner, check }: Row): string {
  return [case_id(owner), check.quantity, check.component ?? "", check.place ?? ""].join("|");
}

/// Those of the same quantity at the same place of the same case, by their key.
export function groups_of(rows: Row[]): Map<string, Row[]> {
  const groups = new Map<string, Row[]>();
  for (const row of rows) groups.set(group_key(row), [...(groups.get(group_key(row)) ?? []), row]);
  return groups;
}

export function quantity_title({ check }: Row): string {
  return [words(check.quantity), check.component ?? "", check.place ?? ""].filter(Boolean).join(", ");
}

/// The solver, with what it is compared with where its quantity has several references.
export function curve_title({ check }: Row, group: Row[]): string {
  const several_references = new Set(group.map((row) => row.check.reference_source ?? "")).size > 1;
  const against = several_references && check.reference_source ? ` against ${check.reference_source}` : "";
  return `${check.solver}${against}${check.must_fail ? ", must-fail twin" : ""}`;
}

/// A ladder keeps its colour and mark whichever of the group is chosen.
function curves_of(group: Row[], chosen: Row): Curve[] {
  return group.map((row, index) => ({
    row,
    index,
    title: curve_title(row, group),
    name: `curve ${index}`,
    points: points_of(row),
    asserted: asserted_order(row),
    chosen: row === chosen,
  }));
}

/// The asserted slope through the finest point, a little below the curve so that both can be seen.
function slope_line(curve: Curve, drop: number): [number, number][] {
  const [finest] = curve.points;
  const coarsest = curve.points[curve.points.length - 1];
  const at = (x: number): [number, number] => [x, finest.y - drop + (curve.asserted ?? 0) * (x - finest.x)];
  return [at(finest.x), at((finest.x + coarsest.x) / 2), at(coarsest.x)];
}

function has_slope(curve: Curve): boolean {
  return curve.chosen && curve.asserted !== null && curve.points.length > 1;
}

function observed_text({ row }: Curve): string {
  const order = row.check.order ?? (row.check.error_kind === "order" ? row.check.value : null);
  return typeof order === "number" ? `observed order ${number(order, 3)}` : "order not computed";
}

function asserted_text(curve: Curve): string {
  if (curve.asserted === null) return "no slope asserted";
  return `asserted ${curve.row.check.must_fail ? "to miss " : ""}≥ ${number(curve.asserted)}`;
}

function legend_of(curves: Curve[]): LegendItem[] {
  return curves.flatMap((curve) => {
    const items: LegendItem[] = [
      { series: [curve.name], index: curve.index, line: true, text: `${curve.title}: ${observed_text(curve)}, ${asserted_text(curve)}` },
    ];
    if (has_slope(curve))
      items.push({ series: [`slope ${curve.index}`], index: curve.index, dashed: true, text: `asserted slope ${number(curve.asserted)}` });
    return items;
  });
}

function series_of(curve: Curve, drop: number, colours: Colours): Record<string, unknown>[] {
  const colour = colours.series[curve.index % colours.series.length];
  const opacity = curve.chosen ? 1 : 0.4;
  const measured = {
    type: "line",
    name: curve.name,
    data: curve.points.map(({ x, y, size, error }) => [x, y, size, error]),
    z: curve.chosen ? 3 : 1,
    symbol: symbols[curve.index % symbols.length],
    symbolSize: curve.chosen ? 10 : 7,
    lineStyle: { color: colour, width: curve.chosen ? 2.5 : 1.25, opacity },
    itemStyle: { color: colour, opacity },
    encode: { x: 0, y: 1 },
  };
  if (!has_slope(curve)) return [measured];
  const text = {
    show: true,
    position: "right",
    distance: 8,
    offset: [0, 9],
    color: colour,
    fontSize: 12,
    formatter: `slope ${number(curve.asserted)}`,
    textBorderColor: colours.paper,
    textBorderWidth: 3,
  };
  const data = slope_line(curve, drop).map((value, i) => ({ value, label: i === 1 ? text : { show: false } }));
  const slope = {
    type: "line",
    name: `slope ${curve.index}`,
    data,
    symbol: "circle",
    symbolSize: 0.1,
    silent: true,
    z: 2,
    lineStyle: { color: colour, width: 1.5, type: [6, 4] },
    itemStyle: { color: colour },
  };
  return [slope, measured];
}

function log_label(value: number): string {
  const power = Math.round(value);
  if (Math.abs(value - power) < 1e-9) return power >= -2 && power <= 3 ? number(10 ** power) : `10${superscript(power)}`;
  const shown = 10 ** value;
  return shown >= 0.001 && shown < 1e4
    ? number(shown, 2)
    : `${number(10 ** (value - Math.floor(value)), 2)}·10${superscript(Math.floor(value))}`;
}

function option_of(curves: Curve[], unit: string, colours: Colours): Record<string, unknown> {
  const all = curves.flatMap((curve) => curve.points);
  const ys = all.map((point) => point.y);
  const drop = Math.max(0.05, 0.07 * (Math.max(...ys) - Math.min(...ys)));
  const slopes = curves.filter(has_slope).flatMap((curve) => slope_line(curve, drop).map(([, y]) => y));
  const low = Math.min(...ys, ...slopes);
  const high = Math.max(...ys, ...slopes);
  const margin = Math.max(0.1, 0.08 * (high - low));
  const xs = all.map((point) => point.x);
  const width = Math.max(Math.max(...xs) - Math.min(...xs), 0.3);
  const x_axis = {
    name: `size${unit ? ` (${unit_text(unit)})` : ""}`,
    min: Math.min(...xs) - 0.08 * width,
    max: Math.max(...xs) + 0.14 * width,
    ticks: spread(xs, 0.09 * width),
    label: (value: number) => number(10 ** value, 3),
  };
  const y_axis = { name: "error", min: low - margin, max: high + margin, ticks: log_ticks(low - margin, high + margin), label: log_label };
  const tooltip = (item: { value: number[] }): string => `size ${quantity(item.value[2], unit, 3)}<br>error ${number(item.value[3], 3)}`;
  const base = base_option(colours);
  return {
    ...base,
    tooltip: { ...(base.tooltip as object), formatter: tooltip },
    xAxis: axis(x_axis, colours, false),
    yAxis: axis(y_axis, colours, true),
    series: curves.flatMap((curve) => series_of(curve, drop, colours)),
  };
}

/// The numbers behind the chart; the order between two sizes is ln(e1/e0) / ln(h1/h0).
function numbers_of(curves: Curve[], unit: string): HTMLElement {
  const rows = curves.flatMap(({ row, title }) => {
    const steps = [...(row.check.ladder ?? [])].sort((a, b) => size_of(b) - size_of(a));
    return steps.map((step, i) => {
      const coarser = steps[i - 1];
      const order = coarser?.error && step.error ? Math.log(step.error / coarser.error) / Math.log(size_of(step) / size_of(coarser)) : null;
      return [title, quantity(size_of(step), unit, 3), number(step.particles), number(step.dofs), number(step.error, 3), number(order, 3)];
    });
  });
  const columns = [
    { title: "Curve" },
    ...["Size", "Particles", "Dofs", "Error", "Order from the coarser size"].map((title) => ({ title, numeric: true })),
  ];
  return el(
    "details",
    {},
    el("summary", {}, "Numbers"),
    scroll_frame("Numbers behind the chart", plain_table("Errors per size", columns, rows)),
  );
}

/// Two sizes make a slope; an error of exactly zero has no logarithm.
export function can_be_drawn(row: Row): boolean {
  return points_of(row).length > 1;
}

/// `group`: ladders that can be drawn, the chosen one among them.
export function convergence_panel(chosen: Row, group: Row[], facts: HTMLElement): Panel {
  const curves = curves_of(group, chosen);
  const unit = group.find((row) => row.check.resolution?.unit)?.check.resolution?.unit ?? "";
  const first = [...curves].sort((a, b) => Number(b.chosen) - Number(a.chosen));
  const legend = legend_of(first);
  return {
    title: `${words(chosen.owner.name)}: ${quantity_title(chosen)}, ${curve_title(chosen, group)}`,
    legend,
    notes: curves.length > 1 ? ["Pale: the other ladders of this quantity."] : [],
    facts,
    extra: numbers_of(first, unit),
    key: String(chosen.index),
    description: `Error against size, logarithmic axes. ${legend.map((item) => item.text).join("; ")}`,
    option: (colours) => option_of(curves, unit, colours),
  };
}
