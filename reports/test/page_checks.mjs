// What a report page must hold. Each check returns lines that say what is wrong; none: fine.

import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { Tab } from "./chromium.mjs";
import { fields } from "./field_checks.mjs";
import { charts, convergence, samples } from "./panel_checks.mjs";
import { describe_png } from "./png.mjs";

const ready = 'document.documentElement.dataset.ready === "true"';
const stopped = '(document.documentElement.dataset.errors ?? "[]") !== "[]"';
const patience_seconds = 30;
const sides = (line) => [line.particles, line.fem, line.mathematics].filter(Boolean).length;
const lines_of = (results) => results.cases.flatMap((entry) => entry.comparison ?? []);
const rows_of = (results) => results.cases.flatMap((entry) => entry.checks);

/// What the page claims to show, from its own data block; scenes and drawn fields without their bulk.
const read_embedded = (tab) =>
  tab.evaluate(`JSON.parse(document.getElementById("report-data")?.textContent ?? '{"sources":[]}').sources.map(({ results, artifacts, fields }) => ({
    results,
    artifacts: Object.fromEntries(Object.entries(artifacts ?? {}).map(([file, { note }]) => [file, { note }])),
    fields: Object.fromEntries(Object.entries(fields ?? {}).map(([file, { note, stress }]) => [file, { note, print: stress?.data.slice(-4000) }])),
  }))`);

async function errors(tab) {
  const kept = await tab.evaluate("JSON.parse(document.documentElement.dataset.errors ?? '[\"the page does not collect its errors\"]')");
  return [...new Set([...kept, ...tab.log])].map((text) => `error on the page: ${text}`);
}

function outside_requests(tab, url) {
  return tab.requests.filter((asked) => asked !== url && !/^(data|blob|about):/.test(asked)).map((asked) => `asks for ${asked}`);
}

async function table_rows(tab, checks) {
  const problems = [];
  const shown = await tab.evaluate('document.querySelectorAll("#verdict-table tbody tr[data-row]").length');
  if (shown !== checks.length) problems.push(`verdict table: ${shown} rows for ${checks.length} checks`);
  const twins = await tab.evaluate('document.querySelectorAll("#verdict-table .twin").length');
  const expected = checks.filter((check) => check.must_fail).length;
  if (twins !== expected) problems.push(`verdict table: ${twins} must-fail twins marked of ${expected}`);
  for (const verdict of ["pass", "fail", "info"]) {
    const marked = await tab.evaluate(`document.querySelectorAll("#verdict-table .mark.${verdict}").length`);
    const stated = checks.filter((check) => check.verdict === verdict).length;
    if (marked !== stated) problems.push(`verdict table: ${marked} rows marked ${verdict}, ${stated} in the results`);
  }
  return problems;
}

/// One line per comparison; a difference that a check judged shows its verdict and leads to it, and so do the headline numbers.
async function central_table(tab, lines) {
  const shown = await tab.evaluate('document.querySelectorAll("#comparison-table tbody tr[data-row]").length');
  const problems = shown === lines.length ? [] : [`central table: ${shown} lines for ${lines.length} comparisons`];
  const pairs = ["particles_fem", "particles_mathematics", "fem_mathematics"];
  const judged = lines.flatMap((line) => pairs.map((pair) => line[pair]?.check)).filter((check) => typeof check === "number").length;
  const linked = await tab.evaluate('document.querySelectorAll("#comparison-table td a.mark[href^=\'#check-\']").length');
  if (linked < judged) problems.push(`central table: ${linked} verdicts linked of ${judged}`);
  const dashes = await tab.evaluate('document.querySelectorAll("#comparison-table .none").length');
  const absent = lines.flatMap((line) => [...pairs, "particles", "fem", "mathematics"].map((key) => line[key])).filter((one) => !one).length;
  if (dashes !== absent) problems.push(`central table: ${dashes} dashes for ${absent} values that are not there`);
  return problems;
}

/// Each cell has its number, or a note that says why it is empty.
async function coverage(tab, results) {
  const cells = results.flatMap((one) => one.coverage ?? []);
  const shown = await tab.evaluate('document.querySelectorAll("#coverage-table td").length');
  const noted = await tab.evaluate('document.querySelectorAll("#coverage-table td a").length');
  const distinct = new Set(cells.map(({ symmetry, family, method }) => [symmetry, family, method].join())).size;
  const empty = results.length === 1 ? cells.filter(({ checks }) => checks === 0).length : noted;
  if (shown !== distinct || noted !== empty) return [`coverage: ${shown} cells for ${distinct}, ${noted} notes for ${empty} empty ones`];
  return [];
}

async function headline_links(tab, results) {
  const stated = results.flatMap((one) => Object.values(one.headline ?? {})).filter(Boolean).length;
  const linked = await tab.evaluate('document.querySelectorAll(".headline .figure a[href^=\'#check-\']").length');
  const commands = await tab.evaluate('document.querySelectorAll(".headline dd code").length');
  const wanted = Math.min(stated, 3);
  if (linked < wanted || commands < wanted) return [`headline: ${linked} rows and ${commands} commands for ${wanted} worst numbers`];
  return recorded(tab, results);
}

/// Beside the worst judged stress stands the largest that is only recorded, with its row and the reason why nothing judges it.
async function recorded(tab, results) {
  const stated = results.map((one) => one.headline?.recorded_particle_stress).filter(Boolean);
  if (stated.length === 0) return [];
  const { why } = stated.reduce((a, b) => (b.error > a.error ? b : a));
  const text = await tab.evaluate('document.querySelector(".headline .recorded:has(a[href^=\'#check-\'])")?.textContent ?? ""');
  return text.includes(why.replace(/\.$/, "")) ? [] : ["headline: the largest recorded difference is missing, or why it is not judged"];
}

/// axe-core's rules (WCAG 2 A and AA, best practices), on the page as it stands.
async function accessibility(tab, axe, scheme) {
  if (!axe) return [];
  await tab.emulate("screen", scheme);
  await tab.evaluate(axe);
  const found = await tab.evaluate(`axe.run(document, { resultTypes: ["violations"] }).then(({ violations }) => violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, impact, nodes }) => "axe, ${scheme}: " + id + " (" + impact + ", " + nodes.length + " times): " + nodes[0].html.slice(0, 120)))`);
  await tab.emulate("screen", "light");
  return found;
}

/// No panel is longer than three screens, whatever the results hold.
const lengths = (tab) =>
  tab.evaluate(`[...document.querySelectorAll("main section")].map((part) => [part.id, Math.round(part.getBoundingClientRect().height)])
    .filter(([, height]) => height > 2700).map(([id, height]) => "panel longer than three screens: " + id + " (" + height + " px)")`);

/// A line of the tables stays a line, on a phone too.
const row_heights = (tab) =>
  tab.evaluate(`["comparison", "verdict"].flatMap((table) => {
    const heights = [...document.querySelectorAll("#" + table + "-table tbody tr")].map((row) => Math.round(row.getBoundingClientRect().height));
    const highest = Math.max(0, ...heights);
    return highest > 200 ? [table + " table: a line is " + highest + " px high"] : [];
  })`);

/// A section shows something, or one line that says why not.
const sections = (tab) =>
  tab.evaluate(`[...document.querySelectorAll("main section")].filter((part) =>
  !part.querySelector("table, figure.panel .chart svg, .missing, dl, li")).map((part) => "empty section: " + part.id)`);

/// (`undefined groups` is a quantity of Algorithm 1.)
const figures = (tab) =>
  tab.evaluate(`(() => {
  const empty = [...document.querySelectorAll(".headline dd")].filter((item) => item.textContent.trim() === "").length;
  const count = document.querySelectorAll(".headline .figure").length;
  const nonsense = /\\bNaN\\b|undefined(?! groups)|Infinity|\\[object/.exec(document.getElementById("page")?.innerText ?? "");
  return [...(count === 5 && empty === 0 ? [] : ["headline numbers missing"]), ...(nonsense ? ["prints " + nonsense[0]] : [])];
})()`);

const fits = async (tab, width) => {
  const wide = await tab.evaluate("document.scrollingElement.scrollWidth");
  return wide > width ? [`wider than its window: ${wide} of ${width} px`] : [];
};

const names = (tab) =>
  tab.evaluate(`(() => {
  const all = (selector) => [...document.querySelectorAll(selector)];
  const named = (item) => (item.getAttribute("aria-label") || item.closest("label")?.textContent || item.textContent).trim() !== "";
  const target = (link) => document.getElementById(link.getAttribute("href").slice(1));
  const structured = document.documentElement.lang && document.querySelector("h1") && document.querySelector("main h2");
  return [
    ...all("th, button, select, input, [role=img], [role=region]").filter((item) => !named(item))
      .map((item) => "no accessible name: " + item.outerHTML.slice(0, 80)),
    ...all("a[href^='#']").filter((link) => !target(link)).map((link) => "link to nowhere: " + link.getAttribute("href")),
    ...all("[id]").filter((item) => document.getElementById(item.id) !== item).map((item) => "id used twice: " + item.id),
    ...(structured ? [] : ["no headings or language"]),
  ];
})()`);

/// The chosen scene is drawn: its canvas holds more than a background, and another time looks different.
async function scenes(tab) {
  const wanted = await tab.evaluate(
    'JSON.parse(document.getElementById("report-data")?.textContent ?? \'{"sources":[]}\').sources.flatMap((one) => one.scenes ?? [])' +
      ".filter((scene) => scene.surface).length",
  );
  if (wanted === 0) return [];
  const shown = await tab.evaluate(`(async () => {
    for (let i = 0; i < 100 && !document.querySelector(".stage-view")?.dataset.shown; ++i) await new Promise((done) => setTimeout(done, 50));
    const canvas = document.querySelector(".stage-view canvas");
    const time = document.querySelector(".stage input[type=range]");
    if (!canvas || !time) return null;
    const look = () => {
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [160, 90];
      const context = copy.getContext("2d");
      context.drawImage(canvas, 0, 0, 160, 90);
      return [...context.getImageData(0, 0, 160, 90).data];
    };
    const at = (share) => {
      time.value = String(share * Number(time.max));
      time.dispatchEvent(new Event("input"));
      return look();
    };
    const [early, late] = [at(0.1), at(1)];
    const colours = new Set();
    for (let i = 0; i < late.length; i += 4) colours.add(late.slice(i, i + 3).join());
    return { colours: colours.size, moved: early.filter((value, i) => Math.abs(value - late[i]) > 8).length };
  })()`);
  if (!shown) return ["scene: no stage"];
  // Scene, fractures, then ours and the paper's by turns: ours must be numbers.
  const blank = await tab.evaluate(`[...(document.querySelectorAll("#scenes table")[1]?.tBodies[0].rows ?? [])]
    .flatMap((row) => [1, 2, 4, 6, 8].filter((column) => !/[0-9]/.test(row.cells[column].textContent))).length`);
  return [
    ...(blank === 0 ? [] : [`scene: ${blank} times of ours are missing`]),
    ...(shown.colours > 20 ? [] : [`scene: looks blank (${shown.colours} colours)`]),
    ...(shown.moved > 100 ? [] : [`scene: does not move (${shown.moved} values differ)`]),
  ];
}

/// Sort by keyboard, filter, CSV: done on the page, then undone. `numbers`: what the column holds, in the order of the rows;
/// `choice`: which of the selects, and the value a row has for it.
async function interaction(tab, { section, table, column, numbers, choice }) {
  if (numbers.length === 0) return [];
  const problems = [];
  const order = () => tab.evaluate(`[...document.querySelectorAll("#${table} tbody tr")].map((row) => Number(row.dataset.row))`);
  await tab.evaluate(`document.querySelector("#${table} th.${column} button").focus()`);
  await tab.press("Enter");
  const sorted = (await order()).map((i) => numbers[i]).filter((number) => typeof number === "number");
  if (sorted.some((number, i) => i > 0 && number < sorted[i - 1])) problems.push(`${section}: sort by ${column}: not ascending`);
  const state = await tab.evaluate(`document.querySelector("#${table} th.${column}").getAttribute("aria-sort")`);
  if (state !== "ascending") problems.push(`${section}: sort by keyboard: aria-sort is ${state}`);
  await tab.press("Enter");
  await tab.press("Enter");
  await tab.evaluate("document.activeElement.blur()");
  if ((await order()).some((row, i) => row !== i)) problems.push(`${section}: sort: the third press does not restore the order`);

  const csv = await tab.evaluate(`(async () => {
    let text;
    const make = URL.createObjectURL;
    URL.createObjectURL = (blob) => { text = blob.text(); return "#csv"; };
    const select = document.querySelectorAll("#${section} .filters select")[${choice.number}];
    select.value = select.options[1].value;
    select.dispatchEvent(new Event("change"));
    const shown = document.querySelectorAll("#${table} tbody tr:not([hidden])").length;
    document.querySelector("#${section} .download").click();
    URL.createObjectURL = make;
    const value = select.value;
    select.value = "";
    select.dispatchEvent(new Event("change"));
    return { lines: (await text).trim().split("\\n").length - 1, shown, value };
  })()`);
  const expected = choice.values.filter((value) => value === csv.value).length;
  if (csv.shown !== expected) problems.push(`${section}: filter by ${csv.value}: ${csv.shown} rows of ${expected}`);
  if (csv.lines !== expected) problems.push(`${section}: CSV: ${csv.lines} lines for ${expected} rows`);
  return problems;
}

const checks_table = (checks) => ({
  section: "verdicts",
  table: "verdict-table",
  column: "error",
  numbers: checks.map((check) => check.error),
  choice: { number: 2, values: checks.map((check) => check.solver) },
});
const comparison_table = (lines) => ({
  section: "comparison",
  table: "comparison-table",
  column: "particles_mathematics",
  numbers: lines.map((line) => line.particles_mathematics?.error),
  choice: { number: 0, values: lines.map((line) => line.quantity) },
});

/// A drawn page has text and curves: many colours (smoothed letters), and a good part of it is not background.
function blank(png, name) {
  const { colours, drawn } = describe_png(png);
  return colours > 30 && drawn > 0.02 ? [] : [`${name}: looks blank (${colours} colours, ${(100 * drawn).toFixed(1)} % drawn)`];
}

const looks = [
  { name: "phone", width: 400, media: "screen", scheme: "light" },
  { name: "wide", width: 1400, media: "screen", scheme: "light" },
  { name: "wide-dark", width: 1400, media: "screen", scheme: "dark" },
  { name: "phone-dark", width: 400, media: "screen", scheme: "dark" },
  { name: "print", width: 1100, media: "print", scheme: "dark" },
];

async function picture(tab, { name, width, media, scheme }, folder) {
  await tab.emulate(media, scheme);
  await tab.resize(width);
  await tab.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
  const problems = [...(await fits(tab, width)), ...(await charts(tab)), ...(media === "screen" ? await row_heights(tab) : [])].map((text) => `${name}: ${text}`);
  const png = await tab.picture();
  if (folder) writeFileSync(join(folder, `${name}.png`), png);
  return [...problems, ...blank(png, name)];
}

/// The checks in their order, each a function that gives its complaints.
function stages(tab, url, { results, folder, axe }) {
  let checks = [];
  let lines = [];
  let all = [];
  let embedded = [];
  return [
    async () => {
      embedded = await read_embedded(tab);
      all = results ? [results] : embedded.map((source) => source.results);
      checks = all.flatMap(rows_of);
      lines = all.flatMap(lines_of).sort((a, b) => sides(b) - sides(a)); // all three sides first, as the page has them
      return [];
    },
    () => errors(tab),
    () => outside_requests(tab, url),
    () => table_rows(tab, checks),
    () => central_table(tab, lines),
    () => headline_links(tab, all),
    () => coverage(tab, all),
    () => charts(tab),
    () => convergence(tab, all.flatMap(({ cases }) => cases)),
    () => samples(tab, embedded),
    () => fields(tab, embedded),
    () => lengths(tab),
    () => sections(tab),
    () => figures(tab),
    () => names(tab),
    () => interaction(tab, checks_table(checks)),
    () => interaction(tab, comparison_table(lines)),
    () => scenes(tab),
    () => accessibility(tab, axe, "light"),
    () => accessibility(tab, axe, "dark"),
    ...looks.map((look) => () => picture(tab, look, folder)),
    () => errors(tab),
    () => outside_requests(tab, url),
  ];
}

/// What is wrong with the page in `file`; nothing: an empty list. `results`: what it should show (default: what it holds).
/// `folder` keeps the pictures. `axe`: the text of axe.min.js, or null. Stops at the first complaint that matches `until`.
export async function check_page(browser, file, { results = null, folder = null, until = null, axe = null } = {}) {
  if (folder) mkdirSync(folder, { recursive: true });
  const url = pathToFileURL(file).href;
  const tab = await Tab.open(browser, 1400);
  try {
    await tab.go(url, `(${ready}) || (${stopped})`, patience_seconds);
    if (!(await tab.evaluate(ready))) return [...(await errors(tab)), "the page never finished drawing"];
    const problems = new Set();
    for (const stage of stages(tab, url, { results, folder, axe })) {
      for (const problem of await stage()) problems.add(problem);
      if (until && [...problems].some((problem) => until.test(problem))) break;
    }
    return [...problems];
  } finally {
    await tab.close();
  }
}
