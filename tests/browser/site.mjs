// The site of the manual, opened from the disk in a real browser: the start page shows its three pictures, and a search
// finds the page on an effect.
//   node site.mjs PROGRAM EXAMPLES
// Exit code 77: mkdocs is missing.
import {execFileSync, spawnSync} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {chromium} from "playwright-core";

const [program, examples] = process.argv.slice(2).map(path => resolve(path)), source = resolve(examples, "..");
if (spawnSync("mkdocs", ["--version"]).status !== 0) process.exit(77);
const work = mkdtempSync(join(tmpdir(), "pendular-site-"));
const failures = [];
const expect = (what, ok, found = "") => { if (!ok) failures.push(`${what} ${found}`); };
let browser;
try {
  execFileSync("bash", [join(source, "scripts/build_site.sh"), program, join(work, "site")], {cwd: source});
  browser = await chromium.launch({executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ["--no-sandbox"]});
  const page = await browser.newPage({viewport: {width: 400, height: 900}});
  page.on("pageerror", error => failures.push(`script: ${error}`));
  page.on("request", request => { if (!request.url().startsWith("file:") && !request.url().startsWith("data:")) failures.push(`a request: ${request.url()}`); });
  await page.goto(pathToFileURL(join(work, "site/index.html")).href);
  const pictures = await page.$$eval("[role=main] img", all => all.map(image => image.naturalWidth));
  expect("three pictures on the start page", pictures.length === 3 && pictures.every(width => width > 0), pictures);
  expect("no sideways scrolling at 400 px", await page.evaluate(() => document.documentElement.scrollWidth <= 400));
  await page.goto(pathToFileURL(join(work, "site/search.html")).href + "?q=" + encodeURIComponent("cross-talk"));
  await page.waitForSelector("#mkdocs-search-results article", {timeout: 60000});
  const found = await page.$$eval("#mkdocs-search-results a", links => links.map(link => link.getAttribute("href")));
  expect("a search that finds the effect", found.some(link => /effects/.test(link)), found);
} finally {
  if (browser) await browser.close();
  rmSync(work, {recursive: true, force: true});
}
console.log(failures.length === 0 ? "The site: start page and search as they should be." : failures.join("\n"));
process.exit(failures.length === 0 ? 0 : 1);
