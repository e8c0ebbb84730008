// The page of a study in a real browser: no request, no error, switches and sliders that show the
// program's own numbers, no overflow, accessible.
//   node page.mjs PROGRAM EXAMPLES [SCREENSHOTS]
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {appendFileSync, cpSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync} from "node:fs";
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
const requests = [], errors = [];
page.on("request", request => { if (!/^(file|blob|data):/.test(request.url()) || !request.url().includes("report.html") && request.url().startsWith("file:")) requests.push(request.url()); });
page.on("console", message => { if (message.type() === "error" || message.type() === "warning") errors.push(message.text()); });
page.on("pageerror", error => errors.push(String(error)));
await page.goto(pathToFileURL(join(study, "out/report.html")).href);
const chi2 = async () => Number(await page.locator("[data-chi2]").getAttribute("data-chi2"));
const rms = async () => (await page.locator("[data-rms]").getAttribute("data-rms")).split(" ").map(Number);
const firstCurve = () => page.locator("svg[data-name=dry-stress-ratio] path.curve").first().getAttribute("d");

try {
  await check("shows the verdict and every figure", async () => {
    assert.match(await page.locator("h1").innerText(), /Missing: wall-friction/);
    assert.ok(await page.locator("figure svg").count() >= 8);
    for (const text of await page.locator("figure svg").evaluateAll(all => all.map(svg => svg.outerHTML))) assert.doesNotMatch(text, /NaN|Infinity/);
  });
  // Curves are left out where they do not pass the model at the readings, so that each that is there does.
  const curvesMissing = () => page.evaluate(() => window.page.plots.flatMap(plot => plot.shown.filter(s => s.marks && s.marks.length > 2 && s.curve.length === 0).map(s => `${plot.spec.title}: ${s.label}`)));
  const before = {chi2: await chi2(), rms: await rms(), curve: await firstCurve()};
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
    const shown = await page.locator("#fit-table tbody tr").nth(1).innerText();
    near(Number(shown.split("\t")[1].split(" ")[0]), add.after.parameters["wall-friction.coefficient"].value, 1e-2, "coefficient");
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
    await page.getByLabel("Leave out reading 5", {exact: true}).click();
    assert.match(await page.locator("[data-without]").innerText(), /Refit without reading 5: chi2 falls by/);
    await page.locator("input[data-effect=torque-gain]").check();
    assert.match(await page.locator("[data-without]").innerText(), /Refit without reading 5/, "left out with another effect too");
    await page.locator("input[data-effect=torque-gain]").uncheck();
    await page.getByLabel("Leave out reading 5", {exact: true}).click();
    assert.equal(await page.locator("[data-without]").count(), 0);
  });
  await check("the line about a reading follows the model", async () => {
    await page.locator("#readings tbody tr").nth(4).hover();
    const before = await page.locator("#reading").innerText();
    assert.match(before, /^Reading 5, /);
    await page.mouse.move(1, 1);
    await page.locator("input[data-effect=torque-gain]").check();
    const after = await page.locator("#reading").innerText();
    assert.match(after, /^Reading 5, /);
    assert.notEqual(after, before);
    await page.locator("input[data-effect=torque-gain]").uncheck();
  });
  await check("errors of measurement are folded, words are on the left", async () => {
    const table = page.locator("#impacts details table");
    assert.equal(await table.count(), 1);
    assert.ok(!await table.isVisible());
    await page.locator("#impacts summary").click();
    assert.ok(await table.isVisible());
    const alignment = cell => page.locator(`#effects table`).last().locator(`tbody tr`).first().locator("td").nth(cell).evaluate(td => getComputedStyle(td).textAlign);
    assert.equal(await alignment(1), "left");
    assert.equal(await alignment(3), "right");
    await page.locator("#impacts summary").click();
  });
  await check("arrow keys step through readings, brushing marks them everywhere", async () => {
    const svg = page.locator("svg[data-name=dry-stress-ratio]");
    await svg.focus();
    await page.keyboard.press("ArrowRight");
    assert.match(await page.locator("#reading").innerText(), /^Reading \d+, /);
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
    const drawn = await page.evaluate(() => window.page.plots[0].shown.reduce((sum, s) => sum + s.points.length + s.marks.length + s.curve.length, 0));
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
      windows: plot.shown.filter(s => s.label.startsWith("averaged")).map(s => ({label: s.label, part: s.part, ids: s.points.map(p => p.id), drawn: s.curve.length}))})));
    assert.deepEqual(shown.map(r => r.title).sort(), files.sort());
    for (const {title, parts, windows} of shown) {
      assert.deepEqual(parts, ["torque [N m]", "normal force [N]"]);
      for (const part of [0, 1]) {
        const here = windows.filter(w => w.part === part);
        assert.ok(here.every(w => w.label === "averaged" && w.drawn === 2), "every window reached a plateau");
        assert.deepEqual(here.flatMap(w => w.ids).map(id => readings[id].file), readings.filter(r => r.file === title).map(() => title));
      }
    }
    assert.equal(await page.locator("#recordings path.curve[stroke='#009e73']").count(), 2 * readings.length);
  });
  await check("saves a recording as it is shown, peaks included", async () => {
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
        await page.evaluate(axe);
        const {violations} = await page.evaluate(() => window.axe.run(document));
        assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes.length} x ${v.nodes[0].html.slice(0, 80)}`), []);
        if (screenshots) await page.screenshot({path: join(screenshots, `${scheme}-${width}.png`), fullPage: true});
      });
    }
  }
  await check("prints", async () => {
    await page.emulateMedia({colorScheme: "light", media: "print"});
    const pdf = await page.pdf({format: "A4"});
    const pages = (pdf.toString("latin1").match(/\/Type\s*\/Page\b/g) || []).length;
    assert.ok(pages >= 2 && pages <= 14, `${pages} pages`);
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
    assert.ok((await page.locator("#readings").textContent()).includes("dry_<img src=x onerror=window.hit=2>.csv:"));
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
    assert.equal(windows["dry_2.csv"].filter(label => label === "averaged, no plateau").length, 1);
    assert.equal(windows["dry_2.csv"].filter(label => label === "averaged").length, 5);
    assert.equal(windows["dry_1.csv"].filter(label => label !== "averaged").length, 0);
    assert.match(await page.locator("#recordings figure").nth(1).innerText(), /averaged, no plateau/);
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
