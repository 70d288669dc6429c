// The three views of a stress field: drawn, different, turning together, and told in words and numbers.

import { walk } from "./panel_checks.mjs";

/// Of the three views: how many colours each has and what share of it is drawn; and what stands beside them.
const look_at_field = `((holder) => {
  const frame = holder.querySelector(".field-frame");
  const canvas = frame?.querySelector("canvas");
  const outer = frame?.getBoundingClientRect();
  const views = [...(frame?.querySelectorAll(".field-view") ?? [])].map((cell) => {
    const box = cell.getBoundingClientRect();
    const ratio = canvas.width / outer.width;
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [160, 120];
    const context = copy.getContext("2d");
    context.drawImage(canvas, (box.left - outer.left) * ratio, (box.top - outer.top) * ratio, box.width * ratio, box.height * ratio, 0, 0, 160, 120);
    const data = context.getImageData(0, 0, 160, 120).data;
    const colours = new Set();
    let [drawn, print] = [0, 17];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] < 128) continue;
      ++drawn;
      colours.add(data.slice(i, i + 3).join());
      for (let k = 0; k < 3; ++k) print = (Math.imul(print, 31) + i + data[i + k]) | 0;
    }
    return { colours: colours.size, share: drawn / (160 * 120), print };
  });
  return {
    key: frame?.dataset.shown ?? "",
    views,
    words: holder.querySelector("[role=status]")?.textContent ?? "",
    ticks: [...holder.querySelectorAll(".ticks span")].map((tick) => tick.textContent),
    rows: holder.querySelectorAll("tbody tr").length,
  };
})`;

/// Every field can be chosen; its three views are drawn, differ where the solvers do, turn together by the arrow keys, and follow the choice of
/// the measure; the differences stand in words and numbers.
export async function fields(tab, embedded) {
  const drawn = embedded.flatMap((source) => Object.values(source.fields ?? {})).filter(({ note }) => !note);
  if (drawn.length === 0) return [];
  const prints = new Map(embedded.flatMap((source) => Object.entries(source.fields ?? {}).map(([file, { print }]) => [file, print])));
  const seen = await walk(tab, "fields", look_at_field);
  const problems = seen.length === drawn.length ? [] : [`fields: ${seen.length} are shown of ${drawn.length}`];
  seen.forEach(({ key, views, words, ticks, rows }, i) => {
    views.forEach(({ colours, share }, view) => {
      if (colours < 8 || share < 0.02) problems.push(`fields: view ${view + 1} of ${key} is empty (${colours} colours, ${(100 * share).toFixed(1)} %)`);
    });
    if (views.length !== 3 || views[2].print === views[0].print) problems.push(`fields: ${key} has no view of the difference`);
    if (!/rms .*[0-9].*largest .*[0-9]/.test(words) || rows !== 7) problems.push(`fields: the difference of ${key} is not told in words and numbers`);
    if (ticks.length !== 10 || !ticks.every((tick) => /[0-9]/.test(tick))) problems.push(`fields: the scales of ${key} have no numbers`);
    const same = i > 0 && prints.get(key) === prints.get(seen[i - 1].key); // two cases may share a body and its load
    if (i > 0 && !same && views[0].print === seen[i - 1].views[0].print) problems.push(`fields: the views of ${key} are those of the field before`);
  });
  const look = (act) => tab.evaluate(`((holder) => { ${act}; return (${look_at_field})(holder); })(document.getElementById("fields-shown"))`);
  const before = await look("");
  const turned = await look('holder.querySelector(".field-frame").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }))');
  if (turned.views.some(({ print }, i) => print === before.views[i].print)) problems.push("fields: the views do not turn together by the arrow keys");
  if (!(await measure_shows(look, drawn.length))) problems.push("fields: another measure changes nothing");
  return problems;
}

/// Of one of the fields at least (a uniform one keeps its colour): another measure gives other views and other words.
async function measure_shows(look, count) {
  for (let i = 0; i < count; ++i) {
    const before = await look("");
    const after = await look(`const measure = document.querySelector("#fields .filters:not(.chooser) select");
      measure.selectedIndex = (measure.selectedIndex + 1) % 3;
      measure.dispatchEvent(new Event("change"))`);
    if (after.views[0].print !== before.views[0].print && after.words !== before.words) return true;
    await look('[...document.querySelectorAll("#fields .chooser button")][1].click()');
  }
  return false;
}
