// Pages damaged on purpose. A check that none of them can fail would be no check.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { check_page } from "./page_checks.mjs";

const at_the_end = (script) => (page) => page.replace("</body>", `<script>${script}</script></body>`);
const remove = (selector) => at_the_end(`document.querySelector(${JSON.stringify(selector)}).remove()`);

/// Whatever is chosen, the chart that was drawn first comes back.
const first_drawing_stays = (section) =>
  at_the_end(`{
    const holder = document.getElementById("${section}-shown");
    const first = holder.querySelector(".chart").innerHTML;
    new MutationObserver(() => {
      const chart = holder.querySelector(".chart");
      if (chart && chart.innerHTML !== first) chart.innerHTML = first;
    }).observe(holder, { childList: true, subtree: true });
  }`);

/// Clouds of points are drawn only where the condition holds.
const drawing_points = (condition) => (page) =>
  page.replace(
    "<script>",
    `<script>{
      const draw = WebGL2RenderingContext.prototype.drawArrays;
      WebGL2RenderingContext.prototype.drawArrays = function (...words) { if (${condition}) draw.apply(this, words); };
    }</script><script>`,
  );

/// name, damage to the page's text, and what the complaint must say.
const twins = [
  { name: "console error", damage: at_the_end('console.error("deliberate")'), complaint: /error on the page: deliberate/ },
  { name: "exception", damage: at_the_end('throw new Error("deliberate")'), complaint: /error on the page: .*deliberate/ },
  { name: "rejected promise", damage: at_the_end('Promise.reject(new Error("deliberate"))'), complaint: /error on the page: .*deliberate/ },
  { name: "broken data", damage: (page) => page.replace('"cleave.report/1"', '"cleave.report/1'), complaint: /never finished drawing/ },
  { name: "a row lost", damage: remove("#verdict-table tbody tr"), complaint: /verdict table: \d+ rows for \d+ checks/ },
  {
    name: "a miss shown as a pass",
    damage: at_the_end('document.querySelector("#verdict-table .mark.fail").className = "mark pass"'),
    complaint: /rows marked pass/,
  },
  { name: "a twin not marked", damage: remove("#verdict-table .twin"), complaint: /must-fail twins marked/ },
  { name: "an empty chart", damage: remove("figure.panel .chart svg"), complaint: /chart not drawn/ },
  {
    name: "axes without curves",
    damage: at_the_end('document.querySelectorAll("figure.panel .chart path").forEach((path) => path.remove())'),
    complaint: /chart without curves/,
  },
  {
    name: "no asserted slope",
    damage: at_the_end(
      '[...document.querySelectorAll("#convergence svg text")].find((text) => text.textContent.startsWith("slope")).textContent = ""',
    ),
    complaint: /asserted slope .* is not written/,
  },
  { name: "a curve lost", damage: remove("#convergence .legend li"), complaint: /convergence: \d+ curves for \d+ ladders/ },
  { name: "a fact lost", damage: remove("#convergence .facts div"), complaint: /convergence: order is not told/ },
  {
    name: "a chooser that chooses nothing",
    damage: at_the_end('document.querySelectorAll("#convergence .chooser button").forEach((one) => one.replaceWith(one.cloneNode(true)))'),
    complaint: /convergence: 1 ladders are shown of/,
  },
  { name: "a chart that stays", damage: first_drawing_stays("convergence"), complaint: /convergence: the chart of .* is that of the ladder before/ },
  { name: "samples that stay", damage: first_drawing_stays("samples"), complaint: /samples: the chart of .* is that of the table before/ },
  {
    name: "a search that finds nothing",
    damage: at_the_end('document.querySelectorAll("#convergence .chooser input").forEach((one) => one.replaceWith(one.cloneNode(true)))'),
    complaint: /convergence: the search for/,
  },
  { name: "fields that draw nothing", damage: drawing_points("false"), complaint: /fields: view 1 of .* is empty/ },
  { name: "no view of the difference", damage: drawing_points("this.getParameter(this.VIEWPORT)[0] < this.drawingBufferWidth / 2"), complaint: /fields: view 3 of .* is empty/ },
  {
    name: "views that do not turn",
    damage: at_the_end('document.querySelector(".field-frame").addEventListener("keydown", (event) => event.stopImmediatePropagation(), true)'),
    complaint: /fields: the views do not turn/,
  },
  {
    name: "a field that stays",
    damage: at_the_end('document.querySelectorAll("#fields .chooser button").forEach((one) => one.replaceWith(one.cloneNode(true)))'),
    complaint: /fields: 1 are shown of/,
  },
  {
    name: "a measure that changes nothing",
    damage: at_the_end('document.querySelector("#fields .filters:not(.chooser) select").addEventListener("change", (event) => event.stopImmediatePropagation(), true)'),
    complaint: /fields: another measure changes nothing/,
  },
  { name: "a scale without numbers", damage: at_the_end('document.querySelectorAll("#fields .ticks span").forEach((tick) => tick.remove())'), complaint: /fields: the scales of .* have no numbers/ },
  {
    name: "a panel without end",
    damage: at_the_end('document.querySelector("#samples").style.minHeight = "3000px"'),
    complaint: /panel longer than three screens: samples/,
  },
  {
    name: "a line as high as a screen",
    damage: at_the_end('document.querySelector("#comparison-table td.basis").style.height = "400px"'),
    complaint: /comparison table: a line is \d+ px high/,
  },
  {
    name: "an empty section",
    damage: at_the_end('document.querySelector("#samples").textContent = ""'),
    complaint: /empty section: samples/,
  },
  {
    name: "a time lost",
    damage: at_the_end('document.querySelectorAll("#scenes table")[1].tBodies[0].rows[0].cells[4].textContent = "–"'),
    complaint: /times of ours are missing/,
  },
  { name: "no stage", damage: remove(".stage-view canvas"), complaint: /scene: no stage/ },
  {
    name: "a blank stage",
    damage: (page) => page.replace("<script>", "<script>WebGL2RenderingContext.prototype.drawElements = () => {};</script><script>"),
    complaint: /scene: (looks blank|does not move)/,
  },
  { name: "NaN printed", damage: at_the_end('document.querySelector(".headline .figure").textContent = "NaN"'), complaint: /prints NaN/ },
  {
    name: "too wide for a phone",
    damage: at_the_end('document.querySelector("h1").style.width = "600px"'),
    complaint: /wider than its window/,
  },
  { name: "blank", damage: at_the_end('document.getElementById("page").style.opacity = 0'), complaint: /looks blank/ },
  {
    name: "an unnamed button",
    damage: at_the_end('document.querySelector("#verdict-table th button").textContent = ""'),
    complaint: /no accessible name/,
  },
  {
    name: "a request",
    damage: (page) => page.replace(/<meta http-equiv[^>]*>/, '<img src="http://127.0.0.1:9/x.png" alt="">'),
    complaint: /asks for http/,
  },
  {
    name: "sorting that does nothing",
    damage: at_the_end('document.querySelectorAll("#verdict-table thead").forEach((head) => head.replaceWith(head.cloneNode(true)))'),
    complaint: /verdicts: sort/,
  },
  {
    name: "a central table that does not sort",
    damage: at_the_end('document.querySelectorAll("#comparison-table thead").forEach((head) => head.replaceWith(head.cloneNode(true)))'),
    complaint: /comparison: sort/,
  },
  { name: "a comparison lost", damage: remove("#comparison-table tbody tr"), complaint: /central table: \d+ lines for \d+ comparisons/ },
  { name: "a verdict without its check", damage: remove("#comparison-table a.mark"), complaint: /central table: \d+ verdicts linked/ },
  { name: "a headline number without its row", damage: remove(".headline a[href^='#check-']"), complaint: /headline: \d+ rows/ },
  {
    name: "no word of what is not judged",
    damage: remove(".headline .recorded"),
    complaint: /headline: the largest recorded difference is missing/,
  },
  {
    name: "a filter that hides nothing",
    damage: at_the_end(
      'document.querySelectorAll("#comparison .filters select").forEach((one) => one.replaceWith(one.cloneNode(true)))',
    ),
    complaint: /comparison: filter by/,
  },
  { name: "an empty cell without its reason", damage: remove("#coverage-table td a"), complaint: /coverage: \d+ cells/ },
  {
    name: "grey on grey",
    damage: at_the_end('document.querySelector(".lead").style.color = "#c8c8c8"; document.querySelector(".lead").style.background = "#bbb"'),
    complaint: /axe, light: color-contrast/,
  },
];

/// Names of the twins that were not caught.
export async function uncaught_twins(browser, file, folder, axe) {
  mkdirSync(folder, { recursive: true });
  const page = readFileSync(file, "utf8");
  const missed = [];
  for (const { name, damage, complaint } of twins) {
    const damaged = join(folder, `${name.replace(/ /g, "_")}.html`);
    const text = damage(page);
    if (text === page) throw new Error(`twin "${name}" changes nothing`);
    writeFileSync(damaged, text);
    const problems = await check_page(browser, damaged, { until: complaint, axe: /axe/.test(complaint.source) ? axe : null });
    const caught = problems.some((line) => complaint.test(line));
    console.log(`${caught ? "caught" : "MISSED"}: ${name}${caught ? "" : ` (said: ${problems.join("; ") || "nothing"})`}`);
    if (!caught) missed.push(name);
  }
  return missed;
}
