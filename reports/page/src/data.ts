// The shape of the embedded report: what the results folders hold, unchanged (schema cleave.results/1).

import type { StressField } from "./stress_field";

export type Verdict = "pass" | "fail" | "info";

export interface LadderStep {
  size: number;
  h?: number | null; ///< representative size: what orders are taken over
  value?: number | null;
  error?: number | null;
  particles?: number | null;
  dofs?: number | null;
}
export interface ArtifactRef {
  file: string;
  title?: string;
  x?: string;
  y?: string;
}
export interface Resolution {
  size?: number | null;
  unit?: string;
  particles?: number | null;
  dofs?: number | null;
}

export interface Check {
  case?: string;
  tier?: string;
  quantity: string;
  component?: string | null;
  unit?: string | null;
  place?: string | null;
  detail?: string | null;
  solver: string;
  resolution?: Resolution | null;
  value?: number | null;
  reference?: number | null;
  reference_source?: string | null;
  error?: number | null;
  error_kind?: string | null;
  band?: Record<string, unknown> | null;
  basis?: string | null;
  order?: number | null;
  must_fail?: boolean | null;
  verdict: Verdict;
  artifacts?: ArtifactRef[] | null;
  ladder?: LadderStep[] | null;
  convergence?: Convergence | null;
  side?: Side;
  reference_side?: Side | null;
}

export type Side = "particles" | "fem" | "mathematics";

/// What the ladder tells about the limit; computed by the run, shown here.
export interface Convergence {
  order?: number | null;
  order_of_values?: number | null;
  extrapolated?: number | null;
  uncertainty?: number | null;
  asymptotic: "stated" | "denied" | "unknown";
  why: string;
}

export interface Statement {
  by: string;
  value?: number | null;
}
/// `check`: number of the check that judged it; null: measured for the record.
export interface Difference {
  error?: number | null;
  error_kind: string;
  check?: number | null;
}
/// One line of the central table.
export interface Comparison {
  quantity: string;
  component?: string;
  unit?: string;
  place?: string;
  particles?: Statement | null;
  fem?: Statement | null;
  mathematics?: Statement | null;
  particles_fem?: Difference | null;
  particles_mathematics?: Difference | null;
  fem_mathematics?: Difference | null;
  checks: number[];
}

export interface CoverageCell {
  symmetry: string;
  family: string;
  method: string;
  checks: number;
  cases?: string[];
  why?: string;
}

export interface WorstError {
  error: number;
  case: string;
  check: number;
  command?: string;
}
/// The largest difference that no band judges.
export interface RecordedError extends WorstError {
  solver: string;
  against: string;
  why: string;
}
export type Headline = Record<string, WorstError | null> & { recorded_particle_stress?: RecordedError | null };

export interface Case {
  name: string;
  tier?: string;
  about?: string;
  parameters?: Record<string, unknown>;
  command?: string;
  verdict?: string;
  symmetry?: string[];
  checks: Check[];
  comparison?: Comparison[];
}

export interface ArtifactTable {
  columns?: string[];
  rows?: (number | null)[][];
  total?: number;
  note?: string;
}

export interface Benchmark {
  name: string;
  run_type?: string;
  aggregate_name?: string;
  time_unit?: string;
  [key: string]: unknown;
}
export interface Bench {
  context?: Record<string, unknown>;
  benchmarks?: Benchmark[];
}

export interface SceneStatistics {
  scene?: string;
  frames?: number;
  physical_particles?: number;
  subdivided_particles?: number;
  boundary_particles?: number;
  fragments?: number;
  debris?: { count?: number; mass?: number; below?: number };
  mass?: number;
  paper?: { row?: string; physical?: number; subdivided?: number; boundary?: number; fragments?: number } | null;
}
export interface SceneTimings {
  threads?: number;
  frames?: number;
  frame_rate?: number;
  fractures?: number;
  stress_analysis?: { per_fracture_ms?: number };
  subdivision?: { per_fracture_ms?: number };
  crack_generation?: { per_fracture_ms?: number };
  paper?: {
    stress_analysis_ms?: number;
    particle_subdivision_ms?: number;
    crack_generation_ms?: number;
    frame_rate?: number;
  } | null;
}
export interface Scene {
  name: string;
  statistics: SceneStatistics;
  timings: SceneTimings | null;
  surface: string | null;
  note: string;
}

export interface Source {
  folder: string;
  results: { level?: string; cases: Case[]; headline?: Headline; coverage?: CoverageCell[] };
  bench: Bench | null;
  timings: { cases?: Record<string, { seconds?: number }>; solves?: Record<string, unknown>[] } | null;
  provenance: Record<string, unknown> | null;
  artifacts: Record<string, ArtifactTable>;
  fields?: Record<string, StressField>;
  scenes?: Scene[];
}

/// One check with the case and the folder it comes from.
export interface Row {
  check: Check;
  owner: Case;
  source: Source;
  tier: string;
  index: number;
}

/// One line of the central table with the case it comes from and the checks it was made of, by their numbers in the case.
export interface Line {
  line: Comparison;
  owner: Case;
  checks: Map<number, Row>;
  index: number;
}

/// Earlier runs, this one last, and what changed since the one before.
export interface History {
  runs: {
    folder: string;
    level?: string;
    commit?: string;
    counts: Record<Verdict, number>;
    headline?: Record<string, WorstError | null> | null;
  }[];
  changes: {
    kind: "drifted" | "new" | "vanished";
    case: string;
    what: string;
    before: number | null;
    now: number | null;
    verdict_before: Verdict | null;
    verdict_now: Verdict | null;
  }[];
}

export interface Report {
  history: History | null;
  sources: Source[];
  rows: Row[];
  lines: Line[];
}

function sides({ particles, fem, mathematics }: Comparison): number {
  return [particles, fem, mathematics].filter(Boolean).length;
}

export function read_report(): Report {
  const text = document.getElementById("report-data")?.textContent ?? "";
  const { sources, history } = JSON.parse(text) as { sources: Source[]; history?: History | null };
  const rows: Row[] = [];
  const lines: Line[] = [];
  for (const source of sources) {
    for (const owner of source.results.cases) {
      const checks = new Map<number, Row>();
      owner.checks.forEach((check, i) => {
        const row = { check, owner, source, tier: check.tier ?? owner.tier ?? "", index: rows.length };
        rows.push(row);
        checks.set(i, row);
      });
      for (const line of owner.comparison ?? []) lines.push({ line, owner, checks, index: 0 });
    }
  }
  lines.sort((a, b) => sides(b.line) - sides(a.line)); // those that all three sides have first, else as the results have them
  lines.forEach((line, index) => (line.index = index));
  return { sources, rows, lines, history: history ?? null };
}

export function count(rows: Row[], verdict: Verdict): number {
  return rows.filter((row) => row.check.verdict === verdict).length;
}

export function case_id(owner: Case): string {
  const parameters = Object.entries(owner.parameters ?? {})
    .map(([key, value]) => `${key}-${value}`)
    .join("-");
  return `case-${owner.name}-${parameters}`.replace(/[^\w-]+/g, "_");
}

export function check_id(row: Row): string {
  return `check-${row.index}`;
}
