/* index.html#selftest: uses the page as a reader would, and leaves what it showed as lines of text,
 * for tests/page/ to hold against the program's own output. */

function cellsOf(id) {
  return [...byId(id).tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.textContent));
}

/* The number that a table shows, with a minus that can be read back. */
function shown(cell) {
  return cell.replaceAll("\u2212", "-").replace("\u2013", "");
}

function press(id, key) {
  byId(id).dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
}

/* Steps through the triangle in every stage by key; a line for each pixel, as its table has it. */
function testStepper(stepper, say) {
  stepper.views[0].trace.given.forEach((v) => say("corner", v.x, v.y, v.z, v.u, v.v));
  stepper.views.forEach((view, i) => {
    stepper.buttons[i].click();
    press("step-figure", "Home");
    for (let count = 0; count < view.steps.length; count++, press("step-figure", "ArrowRight")) {
      const now = view.steps[stepper.step];
      if (stepper.step !== count) {
        throw new Error(`the stepper is at step ${stepper.step} in place of ${count}`);
      }
      if (now.kind === "pixel") {
        const cells = new Map(cellsOf("step-values").map(([name, stage, exact]) =>
          [name, [shown(stage), shown(exact)]]));
        const values = ["z", "u", "v", "texel u", "texel v"].flatMap((name) =>
          cells.get(name) ?? ["", ""]);
        say("step", i + 1, now.pixels[0].x, now.row.y, ...values);
      }
    }
    press("step-figure", "End");
    byId("step-back").click();
    byId("step-first").click();
    say("stepped", i + 1, view.steps.length, stepper.step);
  });
}

/* Moves the cursor by pointer and key; what the table then says of each stage. */
function testPanels(panels, say) {
  const { room } = panels;
  const box = byId("main-canvas").getBoundingClientRect();
  for (let i = 0; i < 60; i++) {
    const [x, y] = [(i * 37 + 11) % room.width, (i * 53 + 7) % room.height];
    byId("main-panel").dispatchEvent(new PointerEvent("pointermove", { bubbles: true,
      clientX: box.left + (x + 0.5) / room.width * box.width,
      clientY: box.top + (y + 0.5) / room.height * box.height }));
    for (const [stage, u, v] of cellsOf("pixel-table")) {
      say("pixel", stage, x, y, shown(u), shown(v));
    }
  }
  const { x, y } = panels;
  byId("zoom-in").click();
  press("main-panel", "ArrowRight");
  press("main-panel", "+");
  press("main-panel", "ArrowUp");
  say("cursor", x + 1, y - 1, panels.x, panels.y, panels.zoom);
  panels.views.forEach((view) => view.button.click());
}

/* How many pixels the page paints as wrong, in every stage. */
function testRoom(room, say) {
  room.stages.forEach((stage, i) => {
    let pixels = 0, wrong = 0, farthest = 0, other = 0;
    for (let pixel = 0; pixel < room.width * room.height; pixel++) {
      const [x, y] = [pixel % room.width, Math.floor(pixel / room.width)];
      const { texture, error } = room.pixel(i, x, y);
      const both = error !== OTHER_SURFACE && texture !== TEXTURE_NONE;
      pixels += both;
      other += error === OTHER_SURFACE;
      wrong += both && error > 0;
      farthest = Math.max(farthest, both ? error : 0);
    }
    say("room", stage.name, pixels, (100 * wrong / pixels).toFixed(6), farthest, other);
  });
}

/* Plays the swim for real, then goes through all its frames: a sum of what each window holds. */
async function testSwim(swim, say) {
  byId("swim-play").click();
  await new Promise((resolve) => setTimeout(resolve, 600));
  byId("swim-play").click();
  say("played", swim.frame > 0 && swim.timer === null ? 1 : 0);
  for (let frame = 0; frame < swim.frames; frame++) {
    swim.go(frame);
    swim.data.stages.forEach((stage, i) => {
      let pixels = 0, sum = 0;
      for (let pixel = 0; pixel < swim.side * swim.side; pixel++) {
        const texel = swim.texel(i, frame, pixel);
        pixels += texel !== null;
        sum += texel ? (pixel % 251) * (texel[0] + 256 * texel[1]) : 0;
      }
      say("swim", stage.name, frame, pixels, sum);
    });
  }
}

async function testCases(cases, say) {
  if (!cases.data) {
    return;
  }
  for (const [r, row] of cases.data.rows.entries()) {
    const buttons = byId("cases-table").tBodies[0].rows[r].querySelectorAll("button");
    for (const [i, button] of buttons.entries()) {
      button.click();
      const [, value] = byId("case-says").textContent.match(/: ([^ ]+) /);
      await cases.opened;
      say("case", row.name, row.what, cases.data.stages[i], shown(value),
        byId("case-views").querySelectorAll("canvas").length);
      byId("case").close();
    }
  }
}

async function selftest(page) {
  const lines = [];
  const say = (...fields) => lines.push(fields.join(","));
  try {
    testStepper(page.stepper, say);
    testPanels(page.panels, say);
    testRoom(page.panels.room, say);
    await testSwim(page.swim, say);
    await testCases(page.cases, say);
    page.chords.segments.forEach((s) => say("chord", s.x, s.count, s.bound, s.error));
    say("width", document.documentElement.scrollWidth, document.documentElement.clientWidth);
  } catch (error) {
    faults.push(String(error));
  }
  faults.forEach((text) => say("fault", text.replaceAll("\n", " ")));
  say("end", faults.length);
  document.body.append(element("pre", { id: "selftest" }, lines.join("\n")));
  parent.postMessage(lines.join("\n"), "*"); /* tests/page/ shows the page in a frame */
}
