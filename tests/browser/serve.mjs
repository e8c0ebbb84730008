// 'pendular serve' in a real browser: recordings that are dropped or appear on the disk, broken files, two
// browsers, effects that are added, requests that are refused, and its end.
//   node serve.mjs PROGRAM EXAMPLES [SCREENSHOTS]
import assert from "node:assert/strict";
import {execFileSync, spawn, spawnSync} from "node:child_process";
import {cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, statSync, writeFileSync} from "node:fs";
import {request as send} from "node:http";
import {createRequire} from "node:module";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {chromium} from "playwright-core";

const [program, examples, screenshots] = process.argv.slice(2);
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const folder = mkdtempSync(join(tmpdir(), "pendular-serve-"));
process.env.PENDULAR_STORE = join(folder, "store.sqlite");
const outside = join(folder, "outside"), study = join(outside, "study");
mkdirSync(outside);
writeFileSync(join(outside, "dry_9.csv"), "not of the study\n");
cpSync(join(examples, "dry-recordings"), study, {recursive: true});
rmSync(join(study, "out"), {recursive: true, force: true});

const check = async (name, test) => { await test(); console.log("ok   " + name); };
const running = [];
// Starts the server, and waits for its address.
async function serve(...words) {
  const child = spawn(program, ["serve", ...words], {stdio: ["ignore", "pipe", "pipe"]}), server = {child, text: ""};
  child.stdout.on("data", data => { server.text += data; });
  child.stderr.on("data", data => { server.text += data; });
  server.ended = new Promise(resolve => child.on("exit", (code, signal) => resolve({code, signal})));
  running.push(child);
  servers.push(server);
  await until(() => /http:\S+/.test(server.text), "the address");
  server.address = new URL(server.text.match(/http:\S+/)[0]);
  server.token = server.address.pathname.split("/")[1];
  return server;
}
// Waits for an event, however long it takes on a busy machine: ctest ends a test that hangs. `what` says which event it was.
const servers = [];
async function until(done, what) {
  for (let waits = 0; !await done(); await new Promise(resolve => setTimeout(resolve, 50))) {
    for (const {child, wanted} of servers) assert.ok(wanted || child.exitCode === null, `a server ended while the test waited for: ${what}`);
    if (++waits % 600 === 0) console.log(`...  still waiting for: ${what}`);
  }
}
// Status and text of a request exactly as it is given.
const ask = (server, path, {method = "GET", headers = {}, body = ""} = {}) => new Promise((resolve, reject) => {
  const request = send({host: "127.0.0.1", port: server.address.port, path, method, headers: {Host: server.address.host, ...headers}}, answer => {
    let text = "";
    answer.on("data", data => { text += data; });
    answer.on("end", () => resolve({status: answer.statusCode, text, headers: answer.headers}));
  });
  request.on("error", reject);
  request.end(body);
});
const state = async server => JSON.parse((await ask(server, `/${server.token}/state`)).text);
// All files of a folder with size and time, without what is in `but`.
const listing = (path, but) => readdirSync(path, {withFileTypes: true}).flatMap(entry => {
  const file = join(path, entry.name);
  return file === but ? [] : entry.isDirectory() ? listing(file, but) : [`${file} ${statSync(file).size} ${statSync(file).mtimeMs}`];
}).sort();
// Recording of another filling, with torques that are larger by a factor: each step has a scatter of its own, without which it
// would count as a copy.
const recording = factor => readFileSync(join(examples, "dry-recordings/dry_3.csv"), "utf8").split("\n").map((line, k) => {
  const cells = line.split(",");
  if (k > 0 && cells.length > 1) {
    const own = 1e4 * factor * Number(cells[5]);
    cells[1] = (Number(cells[1]) * factor * (1 + .01 * Math.sin(own))).toFixed(4);
    cells[3] = (Number(cells[3]) * (1 + .0015 * Math.cos(own))).toFixed(5);
  }
  return cells.join(",");
}).join("\n");
const put = (name, text) => { writeFileSync(join(folder, "part"), text); renameSync(join(folder, "part"), join(study, name)); };

const before = listing(outside, study);
const server = await serve(study, "--switches", "2");
const browser = await chromium.launch({executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ["--no-sandbox"]});
const requests = [], errors = [];
async function open(address) {
  const page = await (await browser.newContext({viewport: {width: 1400, height: 900}})).newPage();
  page.setDefaultTimeout(0);
  page.on("request", request => { if (!request.url().startsWith(server.address.origin)) requests.push(request.url()); });
  page.on("console", message => { if (["error", "warning"].includes(message.type()) && !/status of 4\d\d/.test(message.text())) errors.push(message.text()); });
  page.on("pageerror", error => errors.push(String(error)));
  await page.goto(address);
  return page;
}
const count = page => page.evaluate(() => window.page ? window.page.data.readings.length : 0);
const readings = (page, number) => until(async () => await count(page) === number, `${number} readings`);
const drop = (page, name, text) => page.evaluate(([n, t]) => {
  const data = new DataTransfer();
  data.items.add(new File([t], n));
  document.getElementById("drop").dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true}));
}, [name, text]);
const warned = (page, pattern) => until(async () => await page.locator("#trouble").isVisible() && pattern.test(await page.locator("#trouble").innerText()), `warning ${pattern}`);
const answered = (page, pattern) => until(async () => pattern.test(await page.locator("#answers").innerText()), `answer ${pattern}`);

try {
  const page = await open(server.address.href), box = () => page.locator("#switches input").first();
  await check("shows the page and what to do next", async () => {
    await readings(page, 9);
    assert.match(await page.locator(".measure").innerText(), /What to do next: .*(pendular|[Tt]ake \d+ reading|Measure|To rule out)/);
    await until(async () => /Results of \d{4}-\d\d-\d\d \d\d:\d\d:\d\d/.test(await page.locator("#status").innerText()), "time of the results");
  });
  await check("a recording that is dropped is stored and read; switches stay", async () => {
    await box().check();
    const effect = await box().getAttribute("data-effect");
    await drop(page, "dry_4.csv", recording(1.01));
    await answered(page, /dry_4.csv is stored/);
    await readings(page, 12);
    assert.ok(await page.locator(`input[data-effect=${effect}]`).isChecked(), "the switch is on");
    assert.equal(readFileSync(join(study, "dry_4.csv"), "utf8"), recording(1.01));
    assert.match(await page.locator("#readings").textContent(), /dry_4\.csv step 1/);
    await until(() => /dry_4.csv is new: .*([Tt]ake|To rule out|Measure|Repeat)/.test(server.text), "line on the console");
  });
  await check("recordings that would not be read, or replace one, are refused", async () => {
    const now = listing(study);
    await drop(page, "wet_4.csv", recording(1));
    await answered(page, /wet_4.csv was not stored: .*"dry_\*\.csv"/);
    await drop(page, "dry_5.csv", "Time [s],Torque [mN m]\n1,x\n");
    await answered(page, /dry_5.csv was not stored: dry_5.csv:2:3: column 'Torque/);
    await drop(page, "dry_5.csv", "Time [s],Torque [mN m]\n1,2\n");
    await answered(page, /dry_5.csv was not stored: .* has no /);
    await drop(page, "dry_4.csv", recording(1.5));
    await answered(page, /dry_4.csv was not stored: the study has another file/);
    await page.locator("#files").setInputFiles(join(study, "dry_4.csv"));
    await answered(page, /dry_4.csv is in the study already/);
    assert.deepEqual(listing(study), now);
  });
  const second = await open(server.address.href);
  await check("a file that appears on the disk is read, in a second browser too", async () => {
    put("dry_5.csv", recording(.995));
    await readings(page, 15);
    await readings(second, 15);
  });
  await check("a broken recording is a warning until it is mended", async () => {
    put("dry_6.csv", recording(1.002).replace("\n0.4,", "\n0.4x,"));
    for (const each of [page, second]) await warned(each, /dry_6\.csv:4:\d+: .*0\.4x/);
    assert.equal(await count(page), 15);
    if (screenshots) await page.screenshot({path: join(screenshots, "serve-broken.png")});
    put("dry_6.csv", recording(1.002));
    await readings(page, 18);
    await until(() => page.locator("#trouble").isHidden(), "end of the warning");
  });
  await check("a broken study.toml is a warning until it is mended", async () => {
    const text = readFileSync(join(study, "study.toml"), "utf8");
    put("study.toml", text.replace("density", "densty"));
    await warned(page, /study\.toml:\d+:\d+: .*densty/);
    put("study.toml", text);
    await until(() => page.locator("#trouble").isHidden(), "end of the warning");
    assert.equal(await count(page), 18);
  });
  await check("an effect is added as 'pendular add' does, and removed", async () => {
    const button = page.getByRole("button", {name: /^Add to the study: /}).first();
    const effect = await button.getAttribute("data-change"), copy = join(folder, "copy");
    cpSync(study, copy, {recursive: true});
    execFileSync(program, ["add", copy, effect, "--quiet"], {stdio: "ignore"});
    await button.click();
    await answered(page, new RegExp(`${effect} added: chi2/dof`));
    assert.equal(readFileSync(join(study, "study.toml"), "utf8"), readFileSync(join(copy, "study.toml"), "utf8"));
    const fit = path => JSON.parse(readFileSync(join(path, "out/fit.json"), "utf8"));
    assert.deepEqual(fit(study).parameters, fit(copy).parameters);
    assert.equal(fit(study).chi2, fit(copy).chi2);
    for (const each of [page, second]) await until(() => each.getByRole("button", {name: `Remove from the study: ${effect}`}).isVisible(), "button to remove it");
    await until(() => second.locator(`input[data-effect=${effect}]`).isChecked(), "switch of the effect");
    await second.getByRole("button", {name: `Remove from the study: ${effect}`}).click();
    await until(() => page.getByRole("button", {name: `Add to the study: ${effect}`}).isVisible(), "button to add it");
    assert.doesNotMatch(readFileSync(join(study, "study.toml"), "utf8"), new RegExp(`"${effect}"`));
  });
  await check("fits and is accessible", async () => {
    for (const width of [400, 1400]) {
      await page.setViewportSize({width, height: 900});
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth), `${width} px are enough`);
    }
    await page.evaluate(axe);
    const {violations} = await page.evaluate(() => window.axe.run(document));
    assert.deepEqual(violations.map(v => `${v.id}: ${v.nodes.length} x ${v.nodes[0].html.slice(0, 80)}`), []);
    if (screenshots) await page.screenshot({path: join(screenshots, "serve.png"), fullPage: true});
  });
  await check("other requests are refused", async () => {
    const {token} = server, own = `/${token}/`, wrong = `/${token.replace(/^./, c => c === "0" ? "1" : "0")}/`, now = listing(study);
    const status = async (path, more) => (await ask(server, path, more)).status;
    const secret = {"X-Pendular-Token": token};
    for (const path of ["/", "/state", "//", wrong, `${wrong}state`, "/study.toml"]) assert.equal(await status(path), 403, path);
    for (const path of [`${own}../study.toml`, "/../../etc/passwd", `${own}%2e%2e/study.toml`, `${own}..%2fx`]) assert.equal(await status(path), 400, path);
    for (const path of [`/${token}`, `${own}study.toml`, `${own}dry_1.csv`, `${own}recording`, `${own}change`]) assert.equal(await status(path), 404, path);
    for (const Host of ["evil.example", `evil.example:${server.address.port}`, "127.0.0.1", `127.0.0.1:${server.address.port}.evil.example`, "localhost"]) assert.equal(await status(own, {headers: {Host}}), 403, Host);
    assert.equal(await status(own, {headers: {Host: `localhost:${server.address.port}`}}), 200);
    for (const method of ["PUT", "DELETE", "OPTIONS", "HEAD"]) assert.equal(await status(own, {method}), 405, method);
    assert.equal(await status(`${own}change?action=add&effect=wall-friction`, {method: "POST"}), 403, "no token in the header");
    assert.equal(await status(`${own}change?action=add&effect=wall-friction`, {method: "POST", headers: {...secret, Origin: "http://evil.example"}}), 403, "another origin");
    assert.equal(await status(`${own}state`, {method: "POST", headers: secret}), 404);
    assert.equal(await status(`${own}change?action=calibrate&effect=x`, {method: "POST", headers: secret}), 400);
    for (const name of ["../dry_9.csv", "..", "/tmp/dry_9.csv", "a/dry_9.csv", ".dry_9.csv", "dry_9\n.csv", ""]) {
      assert.equal(await status(`${own}recording?name=${encodeURIComponent(name)}`, {method: "POST", headers: secret, body: recording(1)}), 400, name);
    }
    const large = Buffer.alloc((64 << 20) + 1);
    assert.equal(await status(`${own}recording?name=dry_9.csv`, {method: "POST", headers: secret, body: large}), 413);
    const {headers} = await ask(server, own);
    assert.match(headers["content-security-policy"], /default-src 'none'.*connect-src 'self'.*frame-ancestors 'none'/);
    assert.equal(headers["access-control-allow-origin"], undefined);
    assert.deepEqual(listing(study), now);
    assert.deepEqual(listing(outside, study), before);
  });
  await check("a port that is taken is an error of the user", async () => {
    const other = spawnSync(program, ["serve", study, "--port", server.address.port], {encoding: "utf8", timeout: 10000});
    assert.equal(other.status, 2);
    assert.match(other.stderr, /--port \d+: another program uses this port/);
  });
  await check("no other request, no error", async () => {
    assert.deepEqual(requests, []);
    assert.deepEqual(errors, []);
  });
  await check("SIGTERM ends it, and pages say so", async () => {
    server.wanted = true;
    server.child.kill("SIGTERM");
    assert.deepEqual(await server.ended, {code: 0, signal: null});
    await until(async () => /does not answer/.test(await page.locator("#status").innerText()), "text on the page");
    assert.ok(!readdirSync(study).some(name => name.startsWith(".pendular")), "no temporary files are left");
  });
  await check("a first page shows its progress; Ctrl-C ends the computation", async () => {
    const long = join(folder, "long");
    cpSync(join(examples, "hidden-effect"), long, {recursive: true});
    const busy = await serve(long, "--threads", "1", "--switches", "8"), first = await open(busy.address.href);
    await until(async () => /fits to do/.test(await first.locator("#status").innerText()) && await first.locator("#share").isVisible(), "progress");
    assert.match(await first.locator("h1").innerText(), /no results on this study yet/);
    assert.ok((await state(busy)).working);
    const {version} = await state(busy);
    busy.wanted = true;
    busy.child.kill("SIGINT");
    assert.deepEqual(await busy.ended, {code: 0, signal: null});
    assert.equal(version, 0, "it was ended before its first page");
    assert.doesNotMatch(busy.text, /\d readings\. |Missing/, "no page was finished after the signal");
  });
  await check("results that stand in the folder are shown at once, as of then", async () => {
    const long = join(folder, "long");
    execFileSync(program, ["report", long, "--quiet", "--switches", "1"], {stdio: "ignore"});
    const again = await serve(long, "--threads", "1", "--switches", "8"), first = await open(again.address.href);
    assert.match(await first.locator("h1").innerText(), /Missing: wall-friction/);
    assert.match(await first.locator("#as-of").innerText(), /^These are earlier results, of \d{4}-\d\d-\d\d \d\d:\d\d\. Pendular is computing new ones\.$/);
    assert.equal(await count(first), 24, "with figures");
    assert.equal((await state(again)).version, 0, "before the server has results of its own");
    again.wanted = true;
    again.child.kill("SIGINT");
    await again.ended;
    // A file that is no page of this program is not shown, and its markup never runs.
    const file = join(long, "out/report.html"), text = readFileSync(file, "utf8");
    writeFileSync(file, text.replace('<script type="application/json" id="texts">', `<script>window.hit = 1</script>$&`).replace(/Missing: wall-friction/g, "Missing: <img src=x onerror='window.hit=2'>"));
    const other = await serve(long, "--threads", "1", "--switches", "8"), page = await open(other.address.href);
    assert.match(await page.locator("h1").innerText(), /<img src=x/);
    assert.equal(await page.evaluate(() => window.hit), undefined);
    other.wanted = true;
    other.child.kill("SIGINT");
    await other.ended;
    writeFileSync(file, "<html>");
    const third = await serve(long, "--threads", "1", "--switches", "8"), plain = await open(third.address.href);
    assert.match(await plain.locator("h1").innerText(), /no results on this study yet/);
    third.wanted = true;
    third.child.kill("SIGINT");
    await third.ended;
  });
  await check("a study without recordings waits for the first ones", async () => {
    const empty = join(folder, "empty");
    mkdirSync(empty);
    cpSync(join(study, "study.toml"), join(empty, "study.toml"));
    const waiting = await serve(empty, "--switches", "0"), first = await open(waiting.address.href);
    await warned(first, /study\.toml:\d+:\d+: .*no file matches "dry_\*\.csv"/);
    assert.equal(await first.locator("p.study").innerText(), "empty");
    for (const k of [1, 2, 3]) await drop(first, `dry_${k}.csv`, readFileSync(join(examples, `dry-recordings/dry_${k}.csv`), "utf8"));
    await readings(first, 9);
    await until(() => first.locator("#trouble").isHidden(), "end of the warning");
    waiting.wanted = true;
    waiting.child.kill("SIGTERM");
    assert.equal((await waiting.ended).code, 0);
  });
} finally {
  await browser.close();
  for (const child of running) child.kill("SIGKILL");
  rmSync(folder, {recursive: true, force: true});
}
