// What the panels must hold that show one thing at a time: each item of their choosers is chosen and looked at.

const drawable = (check) => (check.ladder ?? []).filter(({ size, error }) => size > 0 && error > 0).length > 1;

/// What is wrong with a figure, as an expression: it must hold drawn curves or marks inside its axes, not only axes.
const chart_complaints = `((figure) => {
  const title = figure.querySelector("h3")?.textContent;
  const svg = figure.querySelector(".chart svg");
  const box = svg?.getBoundingClientRect();
  if (!svg || box.width < 200 || box.height < 150) return ["chart not drawn: " + title];
  const wanted = figure.querySelectorAll(".legend li").length;
  const colours = new Set([...figure.querySelectorAll(".legend svg")].map((key) => getComputedStyle(key).color));
  const probe = document.createElement("i");
  document.body.append(probe);
  const coloured = (path) => [path.getAttribute("stroke"), path.getAttribute("fill")].some((colour) => {
    if (!colour || colour === "none") return false;
    probe.style.color = colour;
    return colours.has(getComputedStyle(probe).color);
  });
  const drawn = [...svg.querySelectorAll("path")].filter(coloured).length;
  probe.remove();
  const counts = drawn + " coloured paths for " + wanted + " curves";
  return wanted > 0 && drawn >= wanted ? [] : ["chart without curves: " + title + " (" + counts + ")"];
})`;

export const charts = (tab) => tab.evaluate(`[...document.querySelectorAll("figure.panel")].flatMap(${chart_complaints})`);

/// Presses a chooser's own "Next" until it is back at the first item; what `look`, an expression of the chosen element, says of each one.
export const walk = (tab, section, look) =>
  tab.evaluate(`(async () => {
    const holder = document.getElementById("${section}-shown");
    const next = [...document.querySelectorAll("#${section} .chooser button")].find((button) => button.textContent === "Next");
    const seen = [];
    while (holder && next && seen.length < 5000) {
      const one = (${look})(holder);
      if (seen.length > 0 && one.key === seen[0].key) break;
      seen.push(one);
      next.click();
      await new Promise((done) => setTimeout(done));
    }
    return seen;
  })()`);

/// Of the chart shown: what it is of, its complaints, its texts, and its drawing without the numbers that the renderer gives its parts.
const look_at_chart = `((holder) => {
  const figure = holder.querySelector("figure.panel");
  const parts = [...(figure?.querySelectorAll(".chart svg *") ?? [])];
  const drawing = parts.map((part) => ["d", "transform", "stroke", "stroke-width", "stroke-opacity"].map((name) => part.getAttribute(name)).join()).join(";");
  const texts = (selector) => [...(figure?.querySelectorAll(selector) ?? [])].map((item) => item.textContent);
  return {
    key: holder.querySelector("[data-shown]")?.dataset.shown ?? "",
    note: holder.querySelector(".missing")?.textContent ?? "",
    complaints: figure ? ${chart_complaints}(figure) : [],
    legend: texts(".legend li"),
    labels: texts(".chart svg text"),
    facts: texts(".facts div"),
    drawing: drawing + texts(".chart svg text").join(),
  };
})`;

/// A search leaves what holds all its words, and shows one of them; emptied, all are back.
async function chooser_search(tab, section, words, expected, total) {
  const count = (text) =>
    tab.evaluate(`(() => {
      const field = document.querySelector("#${section} .chooser input[type=search]");
      field.value = ${JSON.stringify(text)};
      field.dispatchEvent(new Event("input"));
      return Number(/ of (\\d+) /.exec(document.querySelector("#${section} > .status").textContent)?.[1]);
    })()`);
  const [found, back] = [await count(words), await count("")];
  if (found !== expected || back !== total) return [`${section}: the search for "${words}" leaves ${found} of ${expected}, then ${back} of ${total}`];
  return [];
}

const group_of = (entry, check) => [entry.name, JSON.stringify(entry.parameters ?? {}), check.quantity, check.component ?? "", check.place ?? ""].join("|");
const range_words = { stated: "yes", denied: "no", unknown: "not known" };

/// What the words beside a ladder's chart must say.
function missing_facts(facts, check) {
  const { extrapolated, asymptotic } = check.convergence ?? {};
  const fact = (term) => facts.find((text) => text.startsWith(term)) ?? "";
  const asserted = check.band?.order_at_least;
  return [
    !/[0-9–]/.test(fact("Order of the error")) && "order",
    typeof asserted === "number" && !fact("Order of the error").includes(`≥ ${Number(asserted.toPrecision(4))}`) && "asserted order",
    typeof extrapolated === "number" && !/[0-9].*±/.test(fact("Richardson’s limit")) && "Richardson’s limit",
    typeof extrapolated === "number" && check.value && !/[0-9].*%/.test(fact("Grid convergence index")) && "grid convergence index",
    asymptotic && !fact("Asymptotic range").includes(range_words[asymptotic]) && "asymptotic range",
  ].filter(Boolean);
}

/// Every ladder can be chosen, is drawn with all of its quantity, with its asserted slope and no other, and is told in words.
export async function convergence(tab, cases) {
  const rows = cases.flatMap((entry) => entry.checks.map((check) => ({ check, group: group_of(entry, check), name: entry.name })));
  const ladders = rows.filter(({ check }) => drawable(check));
  if (ladders.length === 0) return [];
  const seen = await walk(tab, "convergence", look_at_chart);
  const problems = seen.flatMap(({ complaints }) => complaints);
  const shown = new Set(seen.map(({ key }) => key));
  const expected = rows.flatMap(({ check }, i) => (drawable(check) ? [String(i)] : []));
  if (seen.length !== ladders.length || expected.some((key) => !shown.has(key)))
    problems.push(`convergence: ${seen.length} ladders are shown of ${ladders.length}`);
  seen.forEach(({ key, legend, labels, facts, drawing }, i) => {
    const row = rows[Number(key)];
    if (!row) return;
    const { check, group, name } = row;
    const curves = legend.filter((text) => !text.startsWith("asserted slope")).length;
    const members = ladders.filter((one) => one.group === group).length;
    if (curves !== members) problems.push(`convergence: ${curves} curves for ${members} ladders (${name})`);
    const order = check.band?.order_at_least;
    const slopes = labels.filter((text) => text.startsWith("slope "));
    const wanted = typeof order === "number" ? [`slope ${Number(order.toPrecision(4))}`] : [];
    if (slopes.join() !== wanted.join()) problems.push(`convergence: the asserted slope ${order} is not written in a chart (${slopes.join() || "none is"})`);
    if (wanted.length > 0 && !legend.includes(`asserted ${wanted[0]}`)) problems.push(`convergence: the asserted slope ${order} is missing from a legend`);
    for (const fact of missing_facts(facts, check)) problems.push(`convergence: ${fact} is not told (${name})`);
    const before = i > 0 ? rows[Number(seen[i - 1].key)]?.check : null;
    if (before && drawing === seen[i - 1].drawing && JSON.stringify(before.ladder) !== JSON.stringify(check.ladder))
      problems.push(`convergence: the chart of ${name} is that of the ladder before`);
  });
  const word = ladders[ladders.length - 1].name;
  problems.push(...(await chooser_search(tab, "convergence", word, ladders.filter(({ name }) => name.includes(word)).length, ladders.length)));
  return [...new Set(problems)];
}

/// Every table of samples can be chosen and is drawn, or says why it is not.
export async function samples(tab, embedded) {
  const drawn = embedded.flatMap(({ results, artifacts }) => {
    const named = new Set(results.cases.flatMap((entry) => entry.checks.flatMap((check) => (check.artifacts ?? []).map(({ file }) => file))));
    return [...named].filter((file) => file.endsWith(".csv")).map((file) => artifacts[file]);
  });
  if (drawn.length === 0) return [];
  const seen = await walk(tab, "samples", look_at_chart);
  const problems = seen.flatMap(({ complaints }) => complaints);
  if (seen.length !== drawn.length) problems.push(`samples: ${seen.length} tables are shown of ${drawn.length}`);
  const notes = drawn.filter(({ note }) => note).length;
  const noted = seen.filter(({ note }) => note !== "").length;
  if (noted < notes || noted === seen.length) problems.push(`samples: ${noted} of ${seen.length} are not drawn`);
  seen.forEach(({ drawing, key }, i) => {
    if (i > 0 && drawing !== "" && drawing === seen[i - 1].drawing) problems.push(`samples: the chart of ${key} is that of the table before`);
  });
  return problems;
}
