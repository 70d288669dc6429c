import "./page.css";

import { cases_section, provenance_section } from "./cases";
import { ChartBoard } from "./chart_board";
import { comparison_section } from "./comparison";
import { convergence_section } from "./convergence";
import { costs_section } from "./costs";
import { coverage_section } from "./coverage";
import { read_report, type Report } from "./data";
import { el } from "./dom";
import { fields_section } from "./fields";
import { headline } from "./headline";
import { history_section } from "./history";
import { samples_section } from "./samples";
import { scenes_section } from "./scenes";
import { subdivision_section } from "./subdivision";
import { missed_section, verdict_section } from "./verdict_table";

function unique(values: unknown[]): string {
  return [...new Set(values.filter((value) => typeof value === "string" && value !== "" && value !== "unknown"))].join(", ");
}

function origin({ sources }: Report): string {
  const level = unique(sources.map((source) => source.results.level));
  const commit = unique(sources.map((source) => source.provenance?.commit));
  const cpu = unique(sources.map((source) => source.provenance?.cpu));
  return [level && `Level ${level}`, commit && `commit ${commit.slice(0, 12)}`, cpu].filter(Boolean).join(" · ");
}

function header(report: Report): HTMLElement {
  const lead = "Brittle fracture of anisotropic solids by smoothed particles, checked against mathematics and a finite-element reference.";
  return el(
    "header",
    {},
    el("h1", {}, "Cleave cross-check"),
    el("p", { class: "lead" }, lead),
    el("p", { class: "origin" }, origin(report)),
  );
}

function navigation(sections: HTMLElement[]): HTMLElement {
  const items = sections.map((part) => el("li", {}, el("a", { href: `#${part.id}` }, part.querySelector("h2")?.textContent ?? part.id)));
  return el("nav", { "aria-label": "Sections" }, el("ul", {}, ...items));
}

function build(report: Report): void {
  const board = new ChartBoard();
  const missed = missed_section(report);
  const history = history_section(report);
  const sections = [
    ...(missed ? [missed] : []),
    comparison_section(report),
    verdict_section(report),
    coverage_section(report),
    convergence_section(report, board),
    fields_section(report),
    samples_section(report, board),
    subdivision_section(report),
    scenes_section(report),
    costs_section(report),
    ...(history ? [history] : []),
    cases_section(report),
    provenance_section(report),
  ];
  const footer = el(
    "footer",
    {},
    "Written by cleave-report from the results alone; it judges nothing. " +
      "Charts: Apache ECharts (Apache-2.0) and ZRender (BSD-3-Clause). Scenes: three.js (MIT).",
  );
  document
    .getElementById("page")
    ?.append(
      el("a", { class: "skip", href: "#comparison" }, "Skip to the central table"),
      header(report),
      el("main", {}, headline(report), navigation(sections), ...sections),
      footer,
    );
  board.draw();
}

// On paper nothing can be opened.
addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((one) => (one.open = true)));
build(read_report());
document.documentElement.dataset.ready = "true";
