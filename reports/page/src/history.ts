// Earlier runs beside this one, and what changed since the last of them.

import type { History, Report } from "./data";
import { DataTable } from "./data_table";
import { el, plain_table, scroll_frame, section } from "./dom";
import { dash, number, percent } from "./format";

type Run = History["runs"][number];
type Change = History["changes"][number];

function run_cells(run: Run): string[] {
  const error = (name: string): number | null => run.headline?.[name]?.error ?? null;
  const { pass, fail, info } = run.counts;
  const angle = error("worst_crack_angle");
  return [
    run.folder,
    run.commit ? run.commit.slice(0, 12) : dash,
    run.level ?? dash,
    `${pass} of ${pass + fail}`,
    number(info),
    percent(error("worst_particle_stress")),
    percent(error("worst_energy_release_rate")),
    angle === null ? dash : `${number(angle, 2)}°`,
  ];
}

const run_columns = [
  { title: "Run" },
  { title: "Commit" },
  { title: "Level" },
  ...["Passed", "Info", "Worst particle stress", "Worst energy release rate", "Worst crack angle"].map((title) => ({ title, numeric: true })),
];

function change_table(items: Change[]): DataTable<Change> {
  const verdicts = ({ verdict_before, verdict_now }: Change): string => `${verdict_before ?? dash} → ${verdict_now ?? dash}`;
  return new DataTable<Change>({
    id: "change-table",
    caption: "What changed since the run before",
    label: "Changes",
    noun: "changes",
    placeholder: "case, check …",
    file: "cleave-changes.csv",
    items,
    columns: [
      { key: "case", title: "Case", head: true, sort: (item) => item.case, cell: (item) => item.case.replace(/_/g, "_\u200b") },
      { key: "kind", title: "Change", sort: (item) => item.kind, cell: (item) => item.kind },
      { key: "what", title: "Check", sort: (item) => item.what, cell: (item) => item.what },
      { key: "before", title: "Error before", numeric: true, sort: (item) => item.before, cell: (item) => number(item.before, 3) },
      { key: "now", title: "Error now", numeric: true, sort: (item) => item.now, cell: (item) => number(item.now, 3) },
      { key: "verdicts", title: "Verdict", sort: verdicts, cell: verdicts },
    ],
    choices: [
      { label: "Change", of: (item) => item.kind },
      { label: "Verdict", of: verdicts },
    ],
    text: (item) => `${item.case} ${item.what}`,
    line: (item) => ({ class: item.verdict_now === "fail" ? "fail" : "" }),
    csv_head: ["case", "change", "check", "error_before", "error_now", "verdict_before", "verdict_now"],
    csv_line: (item) => [item.case, item.kind, item.what, item.before, item.now, item.verdict_before, item.verdict_now],
  });
}

/// Only where earlier runs were given.
export function history_section({ history }: Report): HTMLElement | null {
  if (!history) return null;
  const runs = scroll_frame("Runs", plain_table("Earlier runs and this one, oldest first", run_columns, history.runs.map(run_cells)));
  const changes = history.changes.length > 0 ? change_table(history.changes).elements() : [el("p", {}, "Nothing changed since the run before.")];
  return section("history", "History", runs, el("h3", {}, "Since the run before"), ...changes);
}
