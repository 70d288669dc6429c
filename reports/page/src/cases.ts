// The command behind each number, and where the numbers come from.

import { case_id, type Report, type Source } from "./data";
import { el, missing, plain_table, scroll_frame, section } from "./dom";
import { dash, number, words } from "./format";

function seconds_text(source: Source, name: string): string {
  const seconds = source.timings?.cases?.[name]?.seconds;
  return typeof seconds === "number" ? `${number(seconds, 3)} s` : dash;
}

function tally(source: Source, i: number): string {
  const verdicts = source.results.cases[i].checks.map((check) => check.verdict);
  return (
    (["pass", "fail", "info"] as const)
      .map((word) => ({ word, n: verdicts.filter((verdict) => verdict === word).length }))
      .filter(({ n }) => n > 0)
      .map(({ word, n }) => `${n} ${word}`)
      .join(", ") || "no check"
  );
}

export function cases_section(report: Report): HTMLElement {
  const rows = report.sources.flatMap((source) =>
    source.results.cases.map((owner, i) => {
      const parameters = Object.entries(owner.parameters ?? {})
        .map(([key, value]) => `${key} = ${value}`)
        .join(", ");
      const about = el("span", {}, owner.about ?? "", parameters ? el("small", {}, parameters) : null);
      return [
        el("span", { id: case_id(owner) }, owner.name.replace(/_/g, "_\u200b")),
        words(owner.tier ?? ""),
        about,
        tally(source, i),
        seconds_text(source, owner.name),
        owner.command ? el("code", { class: "command" }, owner.command) : dash,
      ];
    }),
  );
  if (rows.length === 0) return section("cases", "Cases and their commands", missing("results.json holds no case."));
  const columns = [
    { title: "Case" },
    { title: "Tier" },
    { title: "About" },
    { title: "Checks" },
    { title: "Time", numeric: true },
    { title: "Command" },
  ];
  const table = plain_table("Each case with the command that repeats it", columns, rows);
  return section("cases", "Cases and their commands", scroll_frame("Cases and their commands", table));
}

function entries_of(value: unknown, prefix: string): [string, string][] {
  if (value === null || value === undefined || value === "") return [];
  if (typeof value === "object" && !Array.isArray(value)) {
    return Object.entries(value).flatMap(([key, inner]) => entries_of(inner, prefix ? `${prefix} ${words(key)}` : words(key)));
  }
  return [[prefix, Array.isArray(value) ? value.join(", ") : String(value)]];
}

function provenance_list(source: Source, several: boolean): HTMLElement {
  const heading = several ? el("h3", {}, source.folder) : null;
  const entries = entries_of(source.provenance, "").map(([name, value]): [string, string] => [name.replace(/^versions /, ""), value]);
  if (entries.length === 0) return el("div", {}, heading, missing("No provenance.json in this folder."));
  return el(
    "div",
    {},
    heading,
    el("dl", { class: "provenance" }, ...entries.map(([name, value]) => el("div", {}, el("dt", {}, name), el("dd", {}, value)))),
  );
}

export function provenance_section(report: Report): HTMLElement {
  const several = report.sources.length > 1;
  return section(
    "provenance",
    "Provenance",
    ...report.sources.map((source) => provenance_list(source, several)),
  );
}
