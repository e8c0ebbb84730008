// The page of a study in a real browser: no request, no error, switches and sliders that show the
// program's own numbers, no overflow, accessible.
//   node page.mjs PROGRAM EXAMPLES [SCREENSHOTS]
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {appendFileSync, cpSync, mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {pathToFileURL} from "node:url";
import {chromium} from "playwright-core";
import {createRequire} from "node:module";

const [program, examples, screenshots] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const folder = mkdtempSync(join(tmpdir(), "pendular-page-"));
process.env.PENDULAR_STORE = join(folder, "store.sqlite");
const pendular = (...words) => execFileSync(program, words, {encoding: "utf8", stdio: ["ignore", "pipe", "pipe"]});
const study = join(folder, "study");
cpSync(join(examples, "hidden-effect"), study, {recursive: true});
rmSync(join(study, "out"), {recursive: true, force: true});

const check = async (name, test) => { await test(); console.log("ok   " + name); };
const near = (a, b, relative, what) => assert.ok(Math.abs(a - b) <= relative * Math.abs(b), `${what}: ${a} is not ${b}`);

pendular("report", study, "--quiet", "--switches", "3");
const html = readFileSync(join(study, "out/report.html"), "utf8");
assert.ok(html.length < 1e6, "the page is smaller than 1 MB");
const browser = await chromium.launch({executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ["--no-sandbox"]});
const context = await browser.newContext({viewport: {width: 1600, height: 1000}, acceptDownloads: true});
const page = await context.newPage();
page.setDefaultTimeout(0);  // waits are for events; ctest ends a test that hangs
const requests = [], errors = [];
page.on("request", request => { if (!/^(file|blob|data):/.test(request.url()) || !request.url().includes("report.html") && request.url().startsWith("file:")) requests.push(request.url()); });
page.on("console", message => { if (message.type() === "error" || message.type() === "warning") errors.push(message.text()); });
page.on("pageerror", error => errors.push(String(error)));
await page.goto(pathToFileURL(join(study, "out/report.html")).href);
const chi2 = async () => Number(await page.locator("[data-chi2]").getAttribute("data-chi2"));
const rms = async () => (await page.locator("[data-rms]").getAttribute("data-rms")).split(" ").map(Number);
// The page's policy forbids the evaluation by which the driver would wait itself.
const until = async done => { while (!await done()) await new Promise(resolve => setTimeout(resolve, 20)); };
const settled = () => until(() => page.evaluate(() => !window.page.move));  // no transition is under way
const firstCurve = () => page.locator("svg[data-name=dry-stress-ratio] path.curve").first().getAttribute("d");

try {
  await check("shows the verdict and every figure", async () => {
    assert.match(await page.locator("h1").innerText(), /Missing: wall-friction/);
    assert.ok(await page.locator("figure svg").count() >= 8);
    for (const text of await page.locator("figure svg").evaluateAll(all => all.map(svg => svg.outerHTML))) assert.doesNotMatch(text, /NaN|Infinity/);
  });
  // Curves are left out where they do not pass the model at the readings, so that each that is there does.
  const curvesMissing = () => page.evaluate(() => window.page.plots.flatMap(plot => plot.shown.filter(s => s.marks && s.marks.length > 2 && s.curve && s.curve.length === 0).map(s => `${plot.spec.title}: ${s.label}`)));
  const before = {chi2: await chi2(), rms: await rms(), curve: await firstCurve()};
  await check("the error that falls has no column for switches that nobody has touched", async () => {
    assert.deepEqual(await page.evaluate(() => [window.page.ladder.names(), window.page.ladder.times()]), [["this study", "+ wall-friction"], ["", "proposed"]]);
  });
  await check("switches stand in the order of what they bring", async () => {
    const chi2s = await page.evaluate(() => [...document.querySelectorAll("#switches input[data-effect]")].map(box => {
      const {page} = window, k = page.data.switches.findIndex(s => s.name === box.dataset.effect);
      return page.models[page.index ^ 1 << k].chi2;
    }));
    assert.equal(chi2s.length, 3);
    assert.deepEqual(chi2s, [...chi2s].sort((a, b) => a - b));
  });
  await check("the line on a reading is in sight wherever the reading is pointed at", async () => {
    const seen = () => page.evaluate(() => { const box = document.getElementById("reading").getBoundingClientRect(); return box.top < innerHeight && box.bottom > 0; });
    const height = await page.evaluate(() => innerHeight);
    await page.setViewportSize({width: 1600, height: 500});
    await page.evaluate(() => scrollTo(0, 0));
    assert.equal(await seen(), false);
    await page.evaluate(() => window.page.show(3));
    assert.equal(await seen(), true);
    await page.evaluate(() => window.page.show(-1));
    assert.equal(await seen(), false);
    await page.setViewportSize({width: 1600, height});
  });
  await check("a switch shows what 'pendular add' gives", async () => {
    await page.locator("input[data-effect=wall-friction]").check();
    pendular("add", study, "wall-friction", "--quiet", "--json", join(folder, "add.json"));
    const add = JSON.parse(readFileSync(join(folder, "add.json"), "utf8"));
    near(before.chi2, add.before.chi2, 1e-3, "chi2 before");
    near(await chi2(), add.after.chi2, 1e-3, "chi2 after");
    near((await rms())[0], add.after.rms_percent.shear_stress, 5e-3, "RMS of shear stress");
    near((await rms())[1], add.after.rms_percent.solid_fraction, 5e-3, "RMS of solid fraction");
    assert.notEqual(await firstCurve(), before.curve);
    assert.deepEqual(await curvesMissing(), [], "each curve passes the model at its readings");
    const shown = await page.locator("#fit-table tbody tr").nth(1).locator("td").nth(1).textContent();
    near(Number(shown.split(" ")[0]), add.after.parameters["wall-friction.coefficient"].value, 1e-2, "coefficient");
  });
  await check("tells the story from the answer to the provenance; the error that falls is the first picture", async () => {
    assert.deepEqual(await page.locator("main section").evaluateAll(all => all.map(section => section.id)),
      ["ladder", "live", "where", "effects", "next", "fit", "recordings", "paste", "impacts", "provenance"]);
    assert.deepEqual(await page.locator("section.folded > details").evaluateAll(all => all.map(fold => fold.parentElement.id)), ["fit", "recordings", "paste", "impacts", "provenance"]);
    const first = await page.locator("figure svg").first().getAttribute("data-name");
    assert.equal(first, "ladder");
    const {columns, dots, texts} = await page.evaluate(() => {
      const plot = window.page.plots[0];
      return {columns: plot.spec.names(), dots: plot.shown.reduce((sum, s) => sum + s.points.length, 0), texts: plot.shown.flatMap(s => (s.texts || []).map(t => t.text))};
    });
    assert.deepEqual(columns, ["this study", "+ wall-friction", "switches below"]);
    assert.equal(dots, 2 * columns.length * 24, "a dot for each reading, stress and solid fraction, in each column");
    assert.equal(texts[0], `${before.rms[0].toPrecision(3)} %`);
  });
  await check("axes stay when an effect is switched, unless the reader wants otherwise", async () => {
    const box = page.locator("input[data-effect=wall-friction]");
    const axes = () => page.locator("#results figure svg").evaluateAll(all => all.filter(svg => /^(ladder|dry|wet|residuals)/.test(svg.dataset.name))
      .map(svg => svg.dataset.name + ": " + [...svg.querySelectorAll("text[text-anchor=end]")].map(t => `${t.textContent}@${Number(t.getAttribute("y")).toFixed(1)}`).join(" ")));
    await settled();
    const on = await axes();
    await box.uncheck();
    await settled();
    assert.deepEqual(await axes(), on);
    await page.locator("#keep-axes").uncheck();
    const follows = await axes();
    await box.check();
    await settled();
    assert.notDeepEqual(await axes(), follows, "axes that follow the model");
    await page.locator("#keep-axes").check();
    assert.deepEqual(await axes(), on);
  });
  await check("a switched effect moves the readings, at once for readers who want no motion", async () => {
    const ways = () => page.evaluate(async () => {
      const {page} = window, residual = () => page.normalised(0)[0], box = document.querySelector("input[data-effect=wall-friction]"), seen = [];
      const ends = [page.residualsOf(page.index, 0)[0], page.residualsOf(page.index ^ 1, 0)[0]].sort((a, b) => a - b);
      box.click();
      do { seen.push(residual()); await new Promise(requestAnimationFrame); } while (page.move);
      box.click();
      while (page.move) await new Promise(requestAnimationFrame);
      return seen.filter(value => value > ends[0] + 1e-6 && value < ends[1] - 1e-6).length;
    });
    assert.ok(await ways() > 0, "values on the way");
    await page.emulateMedia({reducedMotion: "reduce"});
    assert.equal(await ways(), 0);
    await page.emulateMedia({reducedMotion: "no-preference"});
  });
  await check("time is on linear axes, in figures of residuals and of recordings", async () => {
    const plots = await page.evaluate(() => [...window.page.plots, ...window.page.recordings].map(plot => ({name: plot.spec.name, x: plot.spec.xLabel, log: Boolean(plot.spec.logX)})));
    const of = name => plots.find(plot => plot.name === name);
    assert.deepEqual(of("residuals-time"), {name: "residuals-time", x: "time [s]", log: false});
    assert.equal(of("recording-1").x, "time [s]");
    const ends = await page.evaluate(() => { const x = window.page.recordings[0].shown[0].curve.map(p => p[0]); return [x[0], x[x.length - 1]]; });
    const file = readFileSync(join(study, "dry_1.csv"), "utf8").trim().split("\n").slice(1).map(line => Number(line.split(",")[0]));
    assert.ok(Math.abs(ends[0] - file[0]) < .02 && Math.abs(ends[1] - file[file.length - 1]) < .02, `${ends}`);
  });
  await check("pictures show what effects do in the cell and to the readings", async () => {
    const labels = await page.locator("#effects .picture svg").evaluateAll(all => all.map(svg => svg.getAttribute("aria-label")));
    assert.equal(labels.length, 2);
    assert.match(labels[0], /^wall-friction: .*Changed: torque, normal force/);
    assert.match(labels[1], /Change of stress ratio/);
  });
  await check("copies table and methods, which are files too", async () => {
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    await page.locator("#paste summary").click();
    for (const [id, name] of [["paste-csv", "results.csv"], ["paste-latex", "results.tex"], ["paste-methods", "methods.txt"]]) {
      await page.locator(`button[data-copy=${id}]`).click();
      await until(async () => await page.locator(`button[data-copy=${id}]`).textContent() === "Copied");
      assert.equal(await page.evaluate(() => navigator.clipboard.readText()), readFileSync(join(study, "out", name), "utf8"), name);
    }
    await page.locator("#paste summary").click();
  });
  await check("a slider shows what the program predicts", async () => {
    const file = join(study, "out/fit.json"), fit = JSON.parse(readFileSync(file, "utf8"));
    const compared = () => JSON.parse(pendular("compare", study, "--quiet", "--json", "-")).rms_percent;
    const atFit = await chi2();
    near((await rms())[0], compared().shear_stress, 1e-3, "RMS of shear stress at the fit");
    const value = await page.evaluate(() => {
      const slider = document.querySelector("#sliders input[data-parameter=friction]");
      slider.value = Number(slider.min) + .8 * (Number(slider.max) - Number(slider.min));
      slider.dispatchEvent(new Event("input"));
      return Number(slider.value);
    });
    assert.ok(Math.abs(value - fit.parameters.friction.value) > 2 * fit.parameters.friction.stderr, "the slider moved far");
    fit.parameters.friction.value = value;
    writeFileSync(file, JSON.stringify(fit));
    const moved = compared(), shown = await rms();
    near(shown[0], moved.shear_stress, 1e-2, "RMS of shear stress at another friction");
    near(shown[1], moved.solid_fraction, 1e-2, "RMS of solid fraction at another friction");
    assert.ok(await chi2() > atFit + .3);
    await page.getByRole("button", {name: "Back to the fit"}).click();
    near(await chi2(), atFit, 2e-2, "chi2 at the fit");
  });
  await check("a reading can be left out", async () => {
    await page.locator("#live details summary").click();
    await page.getByLabel("Leave out dry_1.csv step 5", {exact: true}).click();
    assert.match(await page.locator("[data-without]").innerText(), /Refit without dry_1.csv step 5: chi2 falls by/);
    await page.locator("input[data-effect=torque-gain]").check();
    assert.match(await page.locator("[data-without]").innerText(), /Refit without dry_1.csv step 5/, "left out with another effect too");
    await page.locator("input[data-effect=torque-gain]").uncheck();
    await page.getByLabel("Leave out dry_1.csv step 5", {exact: true}).click();
    assert.equal(await page.locator("[data-without]").count(), 0);
  });
  await check("the line about a reading follows the model", async () => {
    await page.locator("#readings tbody tr").nth(4).hover();
    const before = await page.locator("#reading").innerText();
    assert.match(before, /^dry_1.csv step 5: /);
    await page.mouse.move(1, 1);
    await page.locator("input[data-effect=torque-gain]").check();
    const after = await page.locator("#reading").innerText();
    assert.match(after, /^dry_1.csv step 5: /);
    assert.notEqual(after, before);
    await page.locator("input[data-effect=torque-gain]").uncheck();
  });
  await check("errors of measurement are folded, words are on the left", async () => {
    const table = page.locator("#impacts details details table");
    assert.equal(await table.count(), 1);
    await page.locator("#impacts > details > summary").click();
    assert.ok(!await table.isVisible());
    await page.locator("#impacts details details > summary").click();
    assert.ok(await table.isVisible());
    const alignment = cell => page.locator(`#effects table`).nth(1).locator(`tbody tr`).first().locator("td").nth(cell).evaluate(td => getComputedStyle(td).textAlign);
    assert.equal(await alignment(1), "left");
    assert.equal(await alignment(3), "right");
    await page.locator("#impacts > details > summary").click();
  });
  await check("arrow keys step through readings, brushing marks them everywhere", async () => {
    const svg = page.locator("svg[data-name=dry-stress-ratio]");
    await svg.focus();
    await page.keyboard.press("ArrowRight");
    assert.match(await page.locator("#reading").innerText(), /^(dry|wet)_\S+\.csv step \d+: /);
    await svg.scrollIntoViewIfNeeded();
    const box = await svg.boundingBox();
    await page.mouse.move(box.x + box.width * .2, box.y + 15);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * .9, box.y + box.height * .8, {steps: 4});
    await page.mouse.up();
    assert.match(await page.locator("#reading").innerText(), /readings are marked/);
    const faded = await page.locator("svg[data-name=quantiles] path[data-id][opacity='0.25']").count();
    assert.ok(faded > 0, "other figures fade what is not marked");
    await svg.focus();
    await page.keyboard.press("Escape");
  });
  await check("saves what a figure shows", async () => {
    const [csv] = await Promise.all([page.waitForEvent("download"), page.getByLabel(/^Save the numbers of Dry readings: stress ratio/).click()]);
    const text = readFileSync(await csv.path(), "utf8"), rows = text.trim().split("\n");
    assert.match(rows[0], /^series,kind,/);
    const drawn = await page.evaluate(() => window.page.plots.find(plot => plot.spec.name === "dry-stress-ratio").shown.reduce((sum, s) => sum + s.points.length + s.marks.length + s.curve.length, 0));
    assert.equal(rows.length, drawn + 1);
    const [svg] = await Promise.all([page.waitForEvent("download"), page.getByLabel(/^Save Dry readings: stress ratio as SVG/).click()]);
    const drawing = readFileSync(await svg.path(), "utf8");
    assert.match(drawing, /^<svg[^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
    assert.doesNotMatch(drawing, /var\(/);
  });
  await check("shows every recording with the rows that are averaged", async () => {
    const readings = await page.evaluate(() => window.page.data.readings);
    const files = [...new Set(readings.map(r => r.file))];
    const shown = await page.evaluate(() => window.page.recordings.map(plot => ({title: plot.spec.title, parts: plot.spec.parts,
      windows: plot.shown.filter(s => s.label !== "recorded").map(s => ({label: s.label, part: s.part, ids: s.points.map(p => p.id), drawn: s.curve.length}))})));
    assert.deepEqual(shown.map(r => r.title).sort(), files.sort());
    for (const {title, parts, windows} of shown) {
      assert.deepEqual(parts, ["torque [N m]", "normal force [N]"]);
      for (const part of [0, 1]) {
        const here = windows.filter(w => w.part === part);
        assert.ok(here.every(w => w.label === "reading" && w.drawn === 2), "every window reached a plateau");
        assert.deepEqual(here.flatMap(w => w.ids).map(id => readings[id].file), readings.filter(r => r.file === title).map(() => title));
      }
    }
    assert.equal(await page.locator("#recordings path.curve[stroke='var(--mark2)']").count(), 2 * readings.length);
  });
  await check("saves a recording as it is shown, peaks included", async () => {
    await page.locator("#recordings summary").click();
    const [csv] = await Promise.all([page.waitForEvent("download"), page.getByLabel("Save the numbers of dry_1.csv as CSV").click()]);
    const rows = readFileSync(await csv.path(), "utf8").trim().split("\n").slice(1).map(row => row.split(","));
    const drawn = await page.evaluate(() => window.page.recordings.find(plot => plot.spec.title === "dry_1.csv").shown
      .flatMap(s => [...s.points.map(p => [p.x, p.y]), ...s.curve].map(([x, y]) => [s.label, s.kind, String(x), String(y)])));
    assert.deepEqual(rows.map(row => row.slice(0, 4)), drawn);
    const recorded = kind => rows.filter(row => row[0] === "recorded" && row[1] === kind).map(row => Number(row[3]));
    const file = readFileSync(join(study, "dry_1.csv"), "utf8").trim().split("\n").slice(1).map(row => row.split(",").map(Number));
    for (const [kind, values] of [["torque [N m]", file.map(row => row[1] / 1e3)], ["normal force [N]", file.map(row => row[2])]]) {
      assert.ok(recorded(kind).length > 200 && recorded(kind).length <= 400, `${recorded(kind).length} points`);
      near(Math.max(...recorded(kind)), Math.max(...values), 1e-6, "largest " + kind);
      near(Math.min(...recorded(kind)) + 1, Math.min(...values) + 1, 1e-6, "smallest " + kind);
    }
  });
  for (const scheme of ["light", "dark"]) {
    for (const width of [400, 1600]) {
      await check(`${scheme}, ${width} px: fits and is accessible`, async () => {
        await page.emulateMedia({colorScheme: scheme});
        await page.setViewportSize({width, height: 900});
        const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.ok(over <= 0, `${over} px too wide`);
        await page.locator("#fit details").evaluate(fold => { fold.open = true; });
        const cut = await page.locator("#fit-table table").first().evaluate(table => table.getBoundingClientRect().right - table.parentElement.getBoundingClientRect().right);
        assert.ok(cut <= 0, `the table of the fit is cut off by ${cut} px`);
        await page.evaluate(axe);
        const {violations} = await page.evaluate(() => window.axe.run(document));
        assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes.length} x ${v.nodes[0].html.slice(0, 80)}`), []);
        if (screenshots) await page.screenshot({path: join(screenshots, `${scheme}-${width}.png`), fullPage: true});
      });
    }
  }
  await check("prints", async () => {
    await page.locator("details").evaluateAll(all => all.forEach(fold => { fold.open = false; }));
    await page.emulateMedia({colorScheme: "light", media: "print"});
    const pdf = await page.pdf({format: "A4"});
    const pages = (pdf.toString("latin1").match(/\/Type\s*\/Page\b/g) || []).length;
    assert.ok(pages >= 2 && pages <= 4, `${pages} pages`);
    if (screenshots) writeFileSync(join(screenshots, "print.pdf"), pdf);
  });
  await check("a name cannot become markup; dry readings alone suffice", async () => {
    const odd = join(folder, "a<b>&\"'<script>window.hit=1<");
    cpSync(join(examples, "dry-recordings"), odd, {recursive: true});
    rmSync(join(odd, "out"), {recursive: true, force: true});
    renameSync(join(odd, "dry_1.csv"), join(odd, "dry_<img src=x onerror=window.hit=2>.csv"));
    appendFileSync(join(odd, "study.toml"), `
[[effect]]
name = "odd-torque"
parameter = "gain"
unit = "1"
lower = 0
upper = 1
summary = "</script><script>window.hit=3</script><!--<script>"
torque = "torque*(1 + gain)"
`);
    pendular("add", odd, "odd-torque", "--quiet");
    pendular("report", odd, "--quiet", "--switches", "1");
    await page.emulateMedia({media: "screen"});
    await page.goto(pathToFileURL(join(odd, "out/report.html")).href);
    assert.equal(await page.locator(".study").innerText(), "a<b>&\"'<script>window.hit=1<");
    assert.ok((await page.locator("#readings").textContent()).includes("dry_<img src=x onerror=window.hit=2>.csv step 1"));
    assert.match(await page.locator("input[data-effect=odd-torque]").locator("..").getAttribute("title"), /<\/script><script>window.hit=3/);
    assert.match(await page.locator("#sliders").innerText(), /odd-torque.gain = (not determined|\d)/);
    assert.equal(await page.evaluate(() => window.hit), undefined);
    assert.equal(await page.locator("svg[data-name=wet-stress-ratio]").count(), 0);
    assert.ok(await page.locator("svg[data-name=dry-stress-ratio]").count() === 1);
  });
  await check("a step without a plateau is told apart", async () => {
    const rising = join(folder, "rising");
    cpSync(join(examples, "hidden-effect"), rising, {recursive: true});
    rmSync(join(rising, "out"), {recursive: true, force: true});
    const file = join(rising, "dry_2.csv"), lines = readFileSync(file, "utf8").trim().split("\n");
    // The torque of the third step doubles in the course of the step.
    writeFileSync(file, lines.map((line, k) => {
      const cells = line.split(",");
      if (cells[5] === "3") cells[1] = Number(cells[1]) * (1 + (k - 800) / 400);
      return cells.join(",");
    }).join("\n") + "\n");
    pendular("report", rising, "--quiet", "--switches", "0");
    await page.goto(pathToFileURL(join(rising, "out/report.html")).href);
    const windows = await page.evaluate(() => Object.fromEntries(window.page.recordings.map(plot => [plot.spec.title, plot.shown.filter(s => s.part === 0 && s.label !== "recorded").map(s => s.label)])));
    assert.equal(windows["dry_2.csv"].filter(label => label === "no plateau, no reading").length, 1);
    assert.equal(windows["dry_2.csv"].filter(label => label === "reading").length, 5);
    assert.equal(windows["dry_1.csv"].filter(label => label !== "reading").length, 0);
    assert.match(await page.locator("#recordings figure").nth(1).textContent(), /no plateau, no reading/);
  });
  await check("no key has more than eight entries, however many series there are", async () => {
    const many = join(folder, "many"), rates = Array.from({length: 15}, (_, k) => .003 * 25 ** (k / 14));
    mkdirSync(many);
    const rows = [[0, [500]], [.01, [300, 500, 1000]], [.03, [300, 500, 1000, 2000]]].flatMap(([content, stresses]) => stresses.flatMap(stress => rates.map((rate, k) =>
      [stress * (1 + .001 * k), (.33 + .8 * rate + 3 * content * 300 / stress).toFixed(4), .004, (.61 - .25 * rate).toFixed(4), .002, rate.toPrecision(4), content].join(","))));
    writeFileSync(join(many, "points.csv"), "normal_stress [Pa],stress_ratio,stress_ratio_se,solid_fraction,solid_fraction_se,inertial_number,liquid_content\n" + rows.join("\n") + "\n");
    writeFileSync(join(many, "study.toml"), readFileSync(join(study, "study.toml"), "utf8").split("[cell]")[0] + `[[readings]]\nfile = "points.csv"\n[model]\nfit_to = "all"\n`);
    pendular("report", many, "--quiet", "--switches", "0");
    await page.goto(pathToFileURL(join(many, "out/report.html")).href);
    const keys = await page.evaluate(() => window.page.plots.map(plot => ({name: plot.spec.name, series: plot.shown.length, entries: plot.key.children.length, words: plot.key.textContent})));
    for (const {name, entries} of keys) assert.ok(entries <= 8, `${name}: ${entries} entries`);
    const wet = keys.find(key => key.name === "wet-stress-ratio");
    assert.equal(wet.series, 7, "wet readings stand against the inertial number");
    for (const width of [400, 1600]) {
      await page.setViewportSize({width, height: 900});
      const wide = await page.evaluate(() => window.page.plots.map(plot => plot.key.children.length));
      assert.ok(Math.max(...wide) <= 8);
    }
    // Sixteen series, which a scale of colours tells apart.
    const scale = await page.evaluate(() => { const {series, entries} = scaled(Array.from({length: 16}, (_, k) => ({group: k % 2 ? "a" : "b", value: .003 * 1.3 ** k})), "speed [rpm]"); return {colours: new Set(series.map(s => s.colour)).size, entries: entries.map(e => e.label)}; });
    assert.equal(scale.colours, 16);
    assert.deepEqual(scale.entries, ["speed [rpm] 0.003 to 0.154", "b", "a"]);
  });
  await check("draws marks in colours that stand out from the page, light and dark", async () => {
    for (const scheme of ["light", "dark"]) {
      await page.emulateMedia({colorScheme: scheme});
      const contrasts = await page.evaluate(() => {
        const style = getComputedStyle(document.documentElement);
        const luminance = name => [1, 3, 5].map(k => parseInt(style.getPropertyValue(name).trim().slice(k, k + 2), 16) / 255)
          .map(c => c <= .04045 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4).reduce((sum, c, k) => sum + c * [.2126, .7152, .0722][k], 0);
        const ground = luminance("--ground");
        return Array.from({length: 8}, (_, k) => luminance(`--mark${k}`)).map(mark => (Math.max(mark, ground) + .05) / (Math.min(mark, ground) + .05));
      });
      assert.ok(Math.min(...contrasts) >= 3, `${scheme}: ${contrasts.map(c => c.toFixed(2))}`);
    }
    await page.emulateMedia({colorScheme: "light"});
  });
  await check("sends no request and logs no error", async () => {
    assert.deepEqual(requests, []);
    assert.deepEqual(errors, []);
  });
} finally {
  await browser.close();
  rmSync(folder, {recursive: true, force: true});
}
