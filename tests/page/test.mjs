/* node test.mjs BUILD BROWSER [FIREFOX]: see tests/page/test.sh. A check that fails prints what it
 * expected, and what it got. */
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { resolve } from "node:path";

const [build, browserPath, firefox] = process.argv.slice(2);
const require = createRequire(resolve(build, "npm/package.json"));
const { chromium } = require("playwright-core");
const texmap = (...words) => execFileSync(`${build}/texmap`, words, { maxBuffer: 1 << 28 });
const address = `file://${resolve(build)}/report/index.html`;
const STAGES = [1, 2, 3, 4];
const SEGMENTS = { segment_4: 4, segment_8: 8, segment_32: 32, segment_64: 64, segment_span: 4096 };
let passed = 0, failed = 0;

function check(holds, name, ...details) {
  passed += holds ? 1 : 0;
  failed += holds ? 0 : 1;
  if (!holds) {
    console.log(`FAIL ${name}:`, ...details.map((one) => `${JSON.stringify(one)}`.slice(0, 400)));
  }
}

function same(got, expected, name) {
  const [a, b] = [got, expected].map((value) => JSON.stringify(value));
  check(a === b, name, `expected ${b.slice(0, 300)}, got ${a.slice(0, 300)}`);
}

/* What a stage draws: 0xRRGGBB of each pixel. */
function render(stage, size, ...source) {
  texmap("render", "--stage", String(stage), "--size", size.join("x"), ...source,
    "-o", `${build}/page.ppm`);
  const bytes = readFileSync(`${build}/page.ppm`);
  const pixels = bytes.subarray(bytes.length - 3 * size[0] * size[1]);
  return Array.from({ length: size[0] * size[1] },
    (_, i) => (pixels[3 * i] << 16 | pixels[3 * i + 1] << 8 | pixels[3 * i + 2]));
}

/* The words that name a triangle to the program. */
function triangle(v) {
  const rows = [0, 5, 10].map((i) => v.slice(i, i + 5).join(" "));
  writeFileSync(`${build}/page.tri`, rows.join("\n") + "\n");
  return ["--triangles", `${build}/page.tri`];
}

const renderTriangle = (stage, size, v) =>
  render(stage, size, ...triangle(v), "--texture", "coord");

/* The module, from its base64 text, draws all scenes as the program does. */
async function testModule(base64, what) {
  const { instance } = await WebAssembly.instantiate(Buffer.from(base64, "base64"), {});
  const wasm = instance.exports, size = [320, 240];
  for (const [scene, name] of ["room", "wall", "floor", "mesh"].entries()) {
    for (const stage of [...STAGES, ...Object.keys(SEGMENTS), "exact"]) {
      wasm.page_open(...size);
      wasm.page_scene(scene, 40, 0, 0, -1);
      wasm.page_segment_length(SEGMENTS[stage] || 16);
      const pixels = wasm.page_draw(SEGMENTS[stage] ? 4 : stage === "exact" ? 7 : stage, -1);
      same(Array.from(new Uint32Array(wasm.memory.buffer, pixels, size[0] * size[1]),
        (pixel) => pixel & 0xFFFFFF), render(stage, size, "--scene", name, "--frame", "40"),
        `${what} draws ${name} in ${stage} as texmap render does`);
    }
  }
}

async function open(browser, hash = "", options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, ...options });
  page.on("console", (message) => check(!["error", "warning"].includes(message.type()),
    "the console stays empty", message.text()));
  page.on("pageerror", (error) => check(false, "no error in the page", error.stack));
  await page.goto(address + hash);
  if (options.javaScriptEnabled !== false) {
    await page.waitForFunction(() => window.page && window.page.loaded);
  }
  return page;
}

/* What is drawn is drawn before the next frame. */
const settled = (page) => page.evaluate(() => new Promise((done) =>
  requestAnimationFrame(() => requestAnimationFrame(done))));

const state = (page) => page.evaluate("page.stepper.state");

async function testDrag(page) {
  const handle = page.locator(".handle").first(), before = await state(page);
  await handle.dragTo(page.locator("#figure-canvas"), { targetPosition: { x: 100, y: 100 } });
  const after = await state(page);
  check(after.v[0] > before.v[0] && after.v[1] > before.v[1], "dragging A moves it", after.v);
  await handle.press("ArrowRight");
  same((await state(page)).v[0], after.v[0] + 1 / 16, "a key moves it by 1/16 pixel");
  await testFrames(page, "the dragged triangle");
  for (const [name, length] of Object.entries(SEGMENTS)) {
    await page.locator("#step-length").fill(String(Math.log2(length)));
    const { v, size } = await state(page);
    same(await drawnBy(page, 4), renderTriangle(name, size, v), name);
  }
  await page.locator("#step-length").fill("4");
}

const drawnBy = (page, n) => page.evaluate((stage) =>
  Array.from(window.page.stepper.results.get(stage).frame, (pixel) => pixel & 0xFFFFFF), n);

async function testFrames(page, what) {
  const { v, size } = await state(page);
  for (const stage of [...STAGES, 7]) {
    same(await drawnBy(page, stage), renderTriangle(stage === 7 ? "exact" : stage, size, v),
      `${what} in stage ${stage} is what texmap render draws`);
  }
}

/* The page's events against `texmap trace`: every value of every event, and the source lines. */
async function testTrace(page) {
  const { v, size } = await state(page);
  for (const stage of STAGES) {
    await page.locator("#step [data-state=stage] button").nth(stage - 1).click();
    const events = await page.evaluate(() => window.page.stepper.run.events.map((event) =>
      ({ kind: KINDS[event.kind], side: event.side, line: event.line, x: event.x, y: event.y,
        v: event.v })));
    texmap("trace", "--stage", `${stage}`, ...triangle(v), "--size", size.join("x"),
      "--csv", `${build}/page.csv`);
    compareTrace(events, readFileSync(`${build}/page.csv`, "utf8"), stage);
    const count = (kind) => events.filter((event) => event.kind === kind).length;
    const [divides] = await page.evaluate("page.stages.costs(page.stepper.run, Infinity)");
    same(divides, [0, count("pixel"), count("pixel"), count("pixel") + count("span"),
      count("span") + count("segment")][stage], `stage ${stage} divides so often`);
  }
}

/* The rows of a trace are the page's events, in their order, with the same numbers. The page has
 * more: the gradients, and a last step of an edge, which leads nowhere. */
function compareTrace(events, csv, stage) {
  const [head, ...rows] = csv.trim().split("\n").filter((text) => !text.startsWith("#"))
    .map((text) => text.split(","));
  let next = 0, pixels = 0;
  for (const row of rows) {
    const named = Object.fromEntries(head.map((name, k) => [name, row[k]]));
    const isRow = ({ kind, side, line, y, x = named.x }) => [side || kind, line, y, x].join() ===
      [named.record, named.line, named.row, named.x].join();
    next = events.findIndex((event, i) => i >= next && isRow(event));
    const { y, left_short, ...values } = next < 0 ? { none: 0 } : events[next].v; /* y: the row */
    check(Object.entries(values).every(([name, value]) =>
      Math.abs(value - Number(named[name])) <= 1e-8 * Math.abs(value)),
    `stage ${stage}: a step has the numbers of texmap trace`, named, events[next]);
    pixels += named.record === "pixel" ? 1 : 0;
  }
  check(pixels > 20, "pixels are stepped through", pixels);
  same(events.filter(({ kind }) => kind === "pixel").length, pixels, "all of them, and no more");
}

/* Title, formulas and marked source of the step that the page shows. */
async function shown(page) {
  await settled(page);
  return page.evaluate(() => ({
    title: byId("why-title").textContent,
    formulas: Array.from(document.querySelectorAll("#why-formulas p"), (p) => p.textContent),
    marked: Array.from(document.querySelectorAll("#source-now .run"),
      (p) => p.textContent).join(""),
  }));
}

/* One step of each kind, worked out by hand for A (2, 1), B (12, 3), C (5, 11); `higher`: A lies
 * half a pixel higher. At pixel 4, 2: 1/z = 81/94, u/z = 170/94. */
const TRIANGLE = "size=16x12&v=2,1,1,0,0,12,3,2,20,0,5,11,4,0,32";
const HIGHER = TRIANGLE.replace("v=2,1,", "v=2,0.5,");
const WORKED = [
  [2, 0, TRIANGLE, "Gradients", "area = x1 y2 - x2 y1 = 10 * 10 - 3 * 2 = 94", "x1 * y2 - x2 * y1"],
  [2, 1, TRIANGLE, "Edge setup", "x_step = floor(dx / dy) = floor(3 / 10) = 0", "= floor_div("],
  [2, 4, TRIANGLE, "Edge step: left edge to scanline 2: carry",
    "error: 9 + 3 = 12 \u2265 10: carry, error = 12 - 10 = 2", "error += edge->numerator"],
  [2, 4, TRIANGLE, "Edge step", "x = 2 + 0 + 1 = 3", "edge->x += edge->x_step + carry"],
  [3, 1, HIGHER, "Edge setup", "n = x0 dy + prestep dx + D - 1 = 0 * 168 + 8 * 48 + 2688 - 1 = " +
    "3071  (x0 counted from pixel 2 on; D - 1 makes the division a ceiling)", "prestep_y * dx"],
  [3, 1, HIGHER, "Edge setup", "x = 2 + floor(n / D) = 2 + floor(3071 / 2688) = 3", "floor_div(n,"],
  [1, 6, TRIANGLE, "Span: scanline 2", "first = ceil(2.3) = 3,  end = ceil(7) = 7", "ceil_to_int("],
  [3, 7, TRIANGLE, "Pixel: pixel 4, 2", "u rises: floor(2.0988 + 1/2) = 2", "1 / at.one_over_z"],
  [4, 6, TRIANGLE, "Segment", "u rises: floor(u + 1/2), in lo .. hi = floor(0 + 1/2) .. " +
    "ceil(20 - 1/2) = 0 .. 20", "line_setup(start.u"],
];

async function testWhy(page) {
  for (const [stage, at, triangle, title, formula, source] of WORKED) {
    await page.evaluate((hash) => { location.hash = hash; },
      `#step?stage=${stage}&at=${at}&${triangle}`);
    const now = await shown(page), what = `stage ${stage}, step ${at}:`;
    check(now.title.startsWith(title), `${what} the title`, now.title);
    check(now.formulas.includes(formula.replace(/ - /g, " \u2212 ").replace(/ \* /g, " \u00b7 ")),
      `${what} ${formula}`, now.formulas);
    check(now.marked.includes(source), `${what} the source is marked`, now.marked);
  }
}

async function testPick(page) {
  const canvas = page.locator("#figure-canvas");
  const [x, y] = await page.evaluate("page.stepper.figure.toCanvas(6, 5)");
  await canvas.click({ position: { x, y } });
  same((await shown(page)).title, "Pixel: pixel 6, 5", "a click goes to the pixel's step");
  const { at } = await state(page);
  await page.locator("#step [data-go=step]").last().click();
  await canvas.press("ArrowLeft");
  await canvas.press("ArrowLeft");
  same((await state(page)).at, at - 1, "buttons and keys step");
  await page.locator("#step-slider").hover();
  await page.mouse.wheel(0, 100);
  await settled(page);
  same((await state(page)).at, at, "the wheel steps");
  await page.locator("#step [data-go=play]").click();
  await page.waitForFunction(`page.stepper.state.at > ${at}`);
  await page.locator("#step [data-go=play]").click();
}

async function testAddresses(browser) {
  let page = await open(browser, "#step?stage=3&case=turning_point&pixel=31,48&before=1");
  const now = await state(page);
  check(now.stage === 3 && now.case === "turning_point" && now.before, "a lesson's address", now);
  same((await shown(page)).title, "Pixel: pixel 31, 48", "its pixel");
  check(await page.locator("#source-before").isVisible(), "the stage before stands beside it");
  await page.waitForTimeout(500);
  check((await page.evaluate(() => location.hash)).includes("case=turning_point"),
    "the address says what is shown", page.url());
  await page.close();
  page = await open(browser, "#step?stage=9&at=-5&v=1,2&size=0x0&case=none&length=x");
  check((await state(page)).stage === 2 && !(await page.locator("#broken").isVisible()),
    "nonsense in an address does no harm", await state(page));
  await page.close();
}

async function testPictures(page) {
  await page.locator("#pictures").scrollIntoViewIfNeeded();
  const picture = page.locator("#picture");
  async function looks(count, next) { /* how many there are among those that come next */
    const seen = new Set();
    for (let i = 0; i < count; i++) {
      await next(i);
      await settled(page);
      seen.add(await page.evaluate(() => byId("picture").toDataURL()));
    }
    return seen.size;
  }
  const press = (part, text) =>
    page.locator(`#pictures [data-state=${part}] button`, { hasText: text }).click();
  same(await looks(4, (i) => picture.press("1247"[i])), 4, "keys choose the picture");
  await press("mode", "blink");
  await picture.press("2");
  same(await looks(12, () => page.waitForTimeout(150)), 2, "blink shows two pictures in turn");
  const ways = [["mode", "one"], ["mode", "swipe"], ["show", "error"]];
  same(await looks(3, (i) => press(...ways[i])), 3, "swipe and errors look otherwise");
  /* The table is the program's; the counts beside it the module's. */
  const rows = await page.evaluate(() => Array.from(document.querySelectorAll(
    "#pictures table tbody tr"), (row) => parseFloat(row.children[1].textContent)));
  const live = await page.evaluate(() => Array.from(window.page.pictures.rooms.values(),
    ({ wrong, pixels }) => 100 * wrong / pixels));
  rows.forEach((row, i) => check(i === 5 || Math.abs(row - live[i]) <= 0.006 * row,
    "wrong texels in the page are the program's", i + 1, row, live[i]));
}

async function testSwim(page) {
  await page.locator("#swim").scrollIntoViewIfNeeded();
  await page.waitForFunction("page.swim.changes.right?.length === 128", null, { timeout: 60000 });
  const all = await page.evaluate("page.swim.changes.right");
  const jumps = all.filter(([one]) => one.jumps), rest = all.filter(([one]) => !one.jumps);
  const mean = (list, row) => list.reduce((sum, one) => sum + one[row].rms, 0) / list.length;
  check(jumps.length >= 4 && mean(jumps, 0) > 4 * mean(rest, 0), "stage 2 swims in its jumps",
    jumps.length, mean(jumps, 0), mean(rest, 0));
  check(mean(jumps, 0) > 4 * mean(all, 1), "stage 3 swims less", mean(all, 1));
  await page.locator("#swim [data-go=play]").click();
  await page.waitForFunction("page.swim.state.frame > 2");
  await page.locator("#swim [data-go=play]").click();
}

async function testCases(page) {
  const count = await page.locator(".case").count();
  check(count > 20, "the cases are there", count);
  const article = page.locator("#case-steep_segment");
  await article.locator("summary").click();
  await article.locator("canvas").nth(4).waitFor();
  check(await article.locator("canvas").count() === 5, "a case is drawn in all stages");
  check(await page.evaluate("page.stages.width === page.stepper.state.size[0]"),
    "and the stepper has its own frame still");
  await article.getByRole("link").click();
  await page.waitForFunction("page.stepper.state.case === 'steep_segment'");
  await testFrames(page, "a case's triangle");
}

/* The recorded lanes hold the pixels that stage 5 draws; a click goes on to their next store. */
async function testLanes(page) {
  if (await page.evaluate("!page.lanes")) {
    check(await page.textContent("#lanes-missing"), "without stage 5 the page says why");
    return;
  }
  await page.evaluate("page.lanes.set({ recording: 0, at: 1e6 })");
  const stored = await page.evaluate("page.lanes.held().stored");
  const segments = await page.evaluate("page.lanes.recordings[0].segments");
  const pixels = renderTriangle(5, [80, 48],
    [0, 0, 1, 0, 0, 40, 0, 3, 160, 0, 0, 40, 2, 0, 160]);
  segments.forEach(([x, y, count], lane) => {
    same(stored[lane].slice(0, count), Array.from({ length: count }, (_, i) => {
      const pixel = pixels[80 * y + x + i];
      return `(${pixel >> 16} ${pixel >> 8 & 255})`;
    }), `lane ${lane} stores what stage 5 draws`);
  });
  await page.evaluate("page.lanes.set({ recording: 0 })");
  await page.click("#lanes [data-go=pixel]");
  await settled(page);
  check((await page.textContent("#lanes-source .run")).includes("mov     [r15"),
    "a click goes on to the last lane's store");
}

async function testAccess(page, what) {
  await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
  const { violations } = await page.evaluate(() => window.axe.run());
  const bad = violations.filter(({ impact }) => ["serious", "critical"].includes(impact));
  check(bad.length === 0, `axe finds nothing serious, ${what}`,
    bad.map(({ id, nodes }) => `${id}: ${nodes[0].html} ${nodes[0].failureSummary}`));
}

async function testLooks(browser) {
  for (const [width, scheme] of [[390, "light"], [768, "dark"], [900, "light"], [1440, "dark"]]) {
    const page = await open(browser, "", { viewport: { width, height: 900 }, colorScheme: scheme });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    check(wide <= width, `nothing sticks out at ${width} pixels`, wide);
    await testAccess(page, `${width} pixels, ${scheme}`);
    await page.screenshot({ path: `${build}/report/${width}.png`, fullPage: true });
    await page.close();
  }
  const page = await open(browser, "", { javaScriptEnabled: false });
  check(await page.locator("noscript p").isVisible() &&
    await page.locator("#picture-files img").first().isVisible() &&
    !(await page.locator("#step .live").isVisible()) &&
    await page.locator("#case-swim summary").isVisible(), "without JavaScript it can be read");
  await page.pdf({ path: `${build}/report/page.pdf` });
  await page.close();
}

async function testSpeed(page) {
  const [ready, drag] = await page.evaluate(() => {
    const { stepper } = window.page, times = [];
    for (let i = 0; i < 40; i++) {
      const started = performance.now();
      stepper.move(0, 2 + i / 16, 1.5);
      stepper.draw();
      times.push(performance.now() - started);
    }
    return [window.page.ready, times.sort((a, b) => a - b)[20]];
  });
  console.log(`ready after ${Math.round(ready)} ms, a drag redraws in ${drag.toFixed(1)} ms`);
  check(ready < 2000 && drag < 64, "ready in .5 s, a drag in 16 ms, on a machine that is busy",
    ready, drag);
}

/* In another engine, the page tells this program what it holds. */
const HOLDS = `[byId("broken").textContent, window.page?.stepper.run.events.map(({ v }) => v),
  window.page?.pictures.rooms.size]`;
const TELLS = `<script>setInterval(() => (window.page || !byId("broken").hidden) &&
  fetch("/said", { method: "POST", body: JSON.stringify(${HOLDS}) }), 200);</script>`;

async function testFirefox(page) {
  let server, running;
  const said = await new Promise((done) => {
    server = createServer(async (request, response) => {
      const body = (await request.toArray()).join("");
      response.setHeader("Content-Type", "text/html");
      response.end(html + TELLS);
      return body && done(JSON.parse(body));
    }).listen(0, "127.0.0.1", () => {
      running = spawn(firefox, ["--headless", "--profile", mkdtempSync(`${tmpdir()}/firefox`),
        `http://127.0.0.1:${server.address().port}/`], { stdio: "ignore" });
      setTimeout(() => done("nothing in a minute"), 60000).unref();
    });
  });
  running.kill();
  server.close();
  server.closeAllConnections();
  same(said, await page.evaluate(HOLDS), "Firefox steps through the same");
}

const html = readFileSync(`${build}/report/index.html`, "utf8");
check(html.length < 5e6, "the page is under 5 MB", html.length);
await testModule(/id="module">\s*([^<]*)/.exec(html)[1], "the page's module");
const fresh = String(execFileSync("sh", ["tests/page/wasm/build.sh", "check"]));
await (fresh.startsWith("ok") ? testModule(readFileSync("tests/page/stages.wasm.base64", "utf8"),
  "the module in the repository") : console.log(fresh));

const browser = await chromium.launch({ executablePath: browserPath, args: ["--no-sandbox"] });
const page = await open(browser);
await testSpeed(page);
await page.reload();
await page.waitForFunction(() => window.page && window.page.loaded);
await (firefox ? testFirefox(page) : console.log("not in Firefox: Debian package firefox-esr"));
await testFrames(page, "the first triangle");
await testTrace(page);
await testPick(page);
await testDrag(page);
await testWhy(page);
await testPictures(page);
await testSwim(page);
await testCases(page);
await testLanes(page);
await page.close();
await testAddresses(browser);
await testLooks(browser);
await browser.close();
console.log(`page: ${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
