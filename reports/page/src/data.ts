// The shape of the embedded report: what the results folders hold, unchanged (schema cleave.results/1).

export type Verdict = "pass" | "fail" | "info";

export interface LadderStep {
  size: number;
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
}

export interface Case {
  name: string;
  tier?: string;
  about?: string;
  parameters?: Record<string, unknown>;
  command?: string;
  verdict?: string;
  checks: Check[];
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
  results: { level?: string; cases: Case[] };
  bench: Bench | null;
  timings: { cases?: Record<string, { seconds?: number }>; solves?: Record<string, unknown>[] } | null;
  provenance: Record<string, unknown> | null;
  artifacts: Record<string, ArtifactTable>;
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

export interface Report {
  sources: Source[];
  rows: Row[];
}

export function read_report(): Report {
  const text = document.getElementById("report-data")?.textContent ?? "";
  const sources = (JSON.parse(text) as { sources: Source[] }).sources;
  const rows: Row[] = [];
  for (const source of sources) {
    for (const owner of source.results.cases) {
      for (const check of owner.checks) {
        rows.push({ check, owner, source, tier: check.tier ?? owner.tier ?? "", index: rows.length });
      }
    }
  }
  return { sources, rows };
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

export function is_reference_by_fem(row: Row): boolean {
  return row.tier === "cross_code" || /^fem\b/.test(row.check.reference_source ?? "");
}
