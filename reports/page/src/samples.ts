// Sampled curves, one table at a time: a CSV that a check names, first column along x, "reference" as a line, the others as marks.

import { axis, base_option, symbols, type ChartBoard, type Colours, type LegendItem, type Panel } from "./chart_board";
import { Chooser } from "./chooser";
import type { ArtifactRef, ArtifactTable, Report, Row } from "./data";
import { el, missing, section } from "./dom";
import { number, words } from "./format";
import { linear_ticks } from "./ticks";

interface Sample {
  row: Row;
  artifact: ArtifactRef;
  table: ArtifactTable;
}
interface Curve {
  name: string;
  index: number;
  data: [number, number][];
}

/// Each file once, however many checks name it.
function samples_of(report: Report): Sample[] {
  const found = new Map<string, Sample>();
  for (const row of report.rows) {
    for (const artifact of row.check.artifacts ?? []) {
      const key = `${row.source.folder}|${artifact.file}`;
      if (artifact.file.endsWith(".csv") && !found.has(key))
        found.set(key, { row, artifact, table: row.source.artifacts[artifact.file] ?? {} });
    }
  }
  return [...found.values()];
}

function curves_of(table: ArtifactTable): Curve[] {
  const [, ...names] = table.columns ?? [];
  let marks = 0;
  return names
    .map((name, i) => {
      const data: [number, number][] = [];
      for (const row of table.rows ?? []) {
        const x = row[0];
        const y = row[i + 1];
        if (x !== null && y !== null && y !== undefined) data.push([x, y]);
      }
      const is_line = name === "reference";
      if (is_line) data.sort((a, b) => a[0] - b[0]);
      return { name, index: is_line ? -1 : marks++, data };
    })
    .filter((curve) => curve.data.length > 0);
}

function series_of(curve: Curve, colours: Colours): Record<string, unknown> {
  if (curve.index < 0) {
    return {
      type: "line",
      name: curve.name,
      data: curve.data,
      showSymbol: false,
      symbol: "none",
      z: 2,
      lineStyle: { color: colours.ink, width: 1.5 },
      itemStyle: { color: colours.ink },
    };
  }
  const colour = colours.series[curve.index % colours.series.length];
  const size = curve.data.length > 400 ? 3 : curve.data.length > 80 ? 5 : 7;
  return {
    type: "scatter",
    name: curve.name,
    data: curve.data,
    z: 3,
    symbol: symbols[curve.index % symbols.length],
    symbolSize: size,
    itemStyle: { color: colour, opacity: 0.85 },
  };
}

function covering(
  values: number[],
  name: string,
): { name: string; min: number; max: number; ticks: number[]; label: (value: number) => string } {
  const low = values.reduce((a, b) => Math.min(a, b), Infinity);
  const high = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const ticks = linear_ticks(low, high);
  return { name, min: ticks[0], max: ticks[ticks.length - 1], ticks, label: (value) => number(value, 3) };
}

function option_of(curves: Curve[], x_name: string, y_name: string, colours: Colours): Record<string, unknown> {
  const points = curves.flatMap((curve) => curve.data);
  const base = base_option(colours);
  const tooltip = (item: { seriesName: string; value: number[] }): string =>
    `${item.seriesName.replace(/[<&]/g, "")}<br>${number(item.value[0], 4)}, ${number(item.value[1], 4)}`;
  return {
    ...base,
    tooltip: { ...(base.tooltip as object), formatter: tooltip },
    xAxis: axis(
      covering(
        points.map(([x]) => x),
        x_name,
      ),
      colours,
      false,
    ),
    yAxis: axis(
      covering(
        points.map(([, y]) => y),
        y_name,
      ),
      colours,
      true,
    ),
    series: curves.map((curve) => series_of(curve, colours)),
  };
}

const title_of = ({ artifact }: Sample): string => artifact.title ?? artifact.file;

function panel_of(sample: Sample): Panel | null {
  const { row, artifact, table } = sample;
  const curves = curves_of(table);
  if (curves.length === 0) return null;
  const legend: LegendItem[] = curves.map(({ name, index }) => ({ series: [name], index, text: name, line: index < 0 }));
  const title = `${words(row.owner.name)}: ${title_of(sample)}`;
  const x_name = artifact.x ?? table.columns?.[0] ?? "";
  const y_name = artifact.y ?? "";
  const kept = table.rows?.length ?? 0;
  const notes = table.total && table.total > kept ? [`${number(kept)} of ${number(table.total)} rows drawn, evenly chosen.`] : [];
  notes.push(`Data: ${artifact.file}`);
  return {
    title,
    legend,
    notes,
    key: artifact.file,
    description: `${title}. ${y_name} against ${x_name}: ${curves.map((curve) => curve.name).join(", ")}`,
    option: (colours) => option_of(curves, x_name, y_name, colours),
  };
}

function why_not_drawn({ row, artifact, table }: Sample): HTMLElement {
  const note = missing(`${words(row.owner.name)}, ${artifact.file}: ${table.note ?? "no numbers in it"}.`);
  note.dataset.shown = artifact.file;
  return note;
}

export function samples_section(report: Report, board: ChartBoard): HTMLElement {
  const samples = samples_of(report);
  if (samples.length === 0) return section("samples", "Samples", missing("No check of these results names a table of samples."));
  const slot = board.slot("samples-shown");
  const drawable = (sample: Sample): boolean => !sample.table.note && curves_of(sample.table).length > 0;
  const chooser = new Chooser<Sample>({
    label: "Choose a table of samples",
    noun: "tables",
    placeholder: "case, title, file …",
    items: [...samples.filter(drawable), ...samples.filter((sample) => !drawable(sample))],
    levels: [
      { label: "Case", of: ({ row }) => row.owner.name },
      { label: "Table", of: title_of },
    ],
    text: ({ row, artifact }) => [row.owner.name, row.owner.about, artifact.title, artifact.file, artifact.x, artifact.y].filter(Boolean).join(" "),
    show: (sample) => {
      const panel = drawable(sample) ? panel_of(sample) : null;
      if (panel) slot.show(panel);
      else slot.show_note(why_not_drawn(sample));
    },
  });
  const lead = "Values along lines and fronts: mathematics as a line, solvers as marks.";
  return section("samples", "Samples", el("p", {}, lead), chooser.element, chooser.status, slot.element);
}
