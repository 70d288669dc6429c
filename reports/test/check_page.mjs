// Command line of the page check; see check_page.sh.

import { existsSync, readFileSync } from "node:fs";
import { Chromium } from "./chromium.mjs";
import { check_page } from "./page_checks.mjs";
import { uncaught_twins } from "./page_twins.mjs";

function usage(why) {
  console.error(`check_page: ${why}\nusage: check_page.sh [--twins] INDEX.html [--results RESULTS.json] [--axe AXE.min.js] [--out FOLDER]`);
  process.exit(2);
}

function read_arguments(words) {
  const options = { twins: false, file: null, results: null, axe: null, out: null };
  for (let i = 0; i < words.length; ++i) {
    if (words[i] === "--twins") options.twins = true;
    else if (["--results", "--axe", "--out"].includes(words[i]))
      options[words[i].slice(2)] = words[++i] ?? usage(`${words[i - 1]} needs a value`);
    else if (words[i].startsWith("--") || options.file) usage(`unexpected ${words[i]}`);
    else options.file = words[i];
  }
  if (!options.file || !existsSync(options.file)) usage("no such page");
  if (options.twins && !options.out) usage("--twins needs --out");
  return options;
}

async function run(browser, { twins, file, results, axe, out }) {
  const rules = axe ? readFileSync(axe, "utf8") : null;
  if (twins) return (await uncaught_twins(browser, file, out, rules)).map((name) => `not caught: ${name}`);
  const expected = results ? JSON.parse(readFileSync(results, "utf8")) : null;
  return check_page(browser, file, { results: expected, folder: out, axe: rules });
}

const options = read_arguments(process.argv.slice(2));
const browser = new Chromium();
try {
  const problems = await run(browser, options);
  for (const problem of problems) console.error(`check_page: ${problem}`);
  if (problems.length === 0) console.log(`check_page: ${options.file} is in order`);
  process.exitCode = problems.length === 0 ? 0 : 1;
} catch (error) {
  console.error(`check_page: ${error.message}`);
  process.exitCode = 3;
} finally {
  await browser.close();
}
