// The scenes beside the paper's Tables 1 and 2, and one of them playing.

import type { Report, Scene } from "./data";
import { el, missing, plain_table, scroll_frame, section } from "./dom";
import { dash, number, words } from "./format";
import { stage } from "./stage";

const count_columns = [
  { title: "Scene" },
  { title: "Physical particles", numeric: true },
  { title: "Paper", numeric: true },
  { title: "After subdivision", numeric: true },
  { title: "Paper", numeric: true },
  { title: "Boundary particles", numeric: true },
  { title: "Paper", numeric: true },
  { title: "Fragments", numeric: true },
  { title: "Paper", numeric: true },
  { title: "Debris among them", numeric: true },
  { title: "Its share of the mass", numeric: true },
];

const time_columns = [
  { title: "Scene" },
  { title: "Fractures", numeric: true },
  { title: "Stress analysis (ms)", numeric: true },
  { title: "Paper", numeric: true },
  { title: "Subdivision and links (ms)", numeric: true },
  { title: "Paper", numeric: true },
  { title: "Crack generation (ms)", numeric: true },
  { title: "Paper", numeric: true },
  { title: "Frames per second", numeric: true },
  { title: "Paper", numeric: true },
];

const title_of = (scene: Scene): string => words(scene.name).replace(/^./, (letter) => letter.toUpperCase());

const figure = (value: number | null | undefined, digits?: number): string =>
  typeof value === "number" ? number(value, digits) : dash;

function counts({ statistics, ...scene }: Scene): string[] {
  const { paper, debris, mass } = statistics;
  const share = typeof debris?.mass === "number" && mass ? `${number((100 * debris.mass) / mass, 3)} %` : dash;
  return [
    title_of({ statistics, ...scene }),
    figure(statistics.physical_particles),
    figure(paper?.physical),
    figure(statistics.subdivided_particles),
    figure(paper?.subdivided),
    figure(statistics.boundary_particles),
    figure(paper?.boundary),
    figure(statistics.fragments),
    figure(paper?.fragments),
    figure(debris?.count),
    share,
  ];
}

function times(scene: Scene): string[] {
  const { timings } = scene;
  const paper = timings?.paper;
  return [
    title_of(scene),
    figure(timings?.fractures),
    figure(timings?.stress_analysis?.per_fracture_ms, 3),
    figure(paper?.stress_analysis_ms),
    figure(timings?.subdivision?.per_fracture_ms, 3),
    figure(paper?.particle_subdivision_ms),
    figure(timings?.crack_generation?.per_fracture_ms, 3),
    figure(paper?.crack_generation_ms),
    figure(timings?.frame_rate, 3),
    figure(paper?.frame_rate),
  ];
}

function left_out(scenes: Scene[]): HTMLElement | null {
  const notes = scenes.filter((scene) => scene.note !== "").map((scene) => el("li", {}, `${title_of(scene)}: ${scene.note}.`));
  return notes.length === 0 ? null : el("ul", { class: "note" }, ...notes);
}

export function scenes_section(report: Report): HTMLElement {
  const scenes = report.sources.flatMap((source) => source.scenes ?? []);
  const title = "Scenes beside the paper’s Tables 1 and 2";
  if (scenes.length === 0) return section("scenes", title, missing("No scenes in these results: run cleave simulate NAME --out DIR/scenes/NAME."));
  const shown = scenes.filter((scene) => scene.surface);
  return section(
    "scenes",
    title,
    el("p", {}, "Times are ours per fracture, on this machine, and the paper’s on a 2010 Xeon W3530: context, not a race."),
    scroll_frame("Table 1 beside ours", plain_table("Particles and fragments, ours and the paper’s", count_columns, scenes.map(counts))),
    scroll_frame("Table 2 beside ours", plain_table("Times, ours and the paper’s", time_columns, scenes.map(times))),
    shown.length > 0 ? stage(shown.map((scene) => ({ title: title_of(scene), surface: scene.surface as string }))) : null,
    left_out(scenes),
  );
}
