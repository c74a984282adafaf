/* The stepper: one triangle, any stage, step by step, and all stages beside each other. */

const FIRST = { size: [26, 12], v: [1.703125, 1.421875, 1, 0, 0, 24.296875, 3.234375, 4, 31, 3,
  8.640625, 10.703125, 2, 8, 20] };
const NEAR = 24; /* pixels across the view around a step */
const STEPPED = [1, 2, 3, 4];

class Stepper {
  constructor(stages, cases) {
    this.stages = stages;
    this.cases = cases;
    this.state = { stage: 2, at: 0, length: 16, snap: 0, case: "", triangle: 0, before: false,
      size: FIRST.size, v: FIRST.v.slice(), view: "fit" };
    this.figure = new Figure((i, x, y) => this.move(i, x, y), (x, y) => this.pick(x, y),
      (event) => this.key(event));
    this.stageChoice = new Choice("step-stage",
      STEPPED.map((n) => [n, `${n} ${stageOf(n).name}`]), (n) => this.setStage(n));
    this.player = new Player("step-play", () => this.go(this.state.at + 1), () => 8);
    this.drawAll = later(() => this.draw());
    this.panels = new Panels((n) => this.setStage(n));
    this.listen();
    Address.part("step", () => this.address(), (wanted) => this.openAddress(wanted));
    addEventListener("resize", this.drawAll);
    this.change();
  }

  listen() {
    const on = (id, name, action) => byId(id).addEventListener(name, action);
    on("step-back", "click", () => this.go(this.state.at - 1));
    on("step-on", "click", () => this.go(this.state.at + 1));
    on("row-back", "click", () => this.goRow(-1));
    on("row-on", "click", () => this.goRow(1));
    on("step-slider", "input", (event) => this.go(Number(event.target.value)));
    byId("transport").addEventListener("wheel", (event) => {
      event.preventDefault();
      this.go(this.state.at + Math.sign(event.deltaY));
    }, { passive: false });
    on("step-snap", "change", (event) => this.set({ snap: Number(event.target.value) }));
    on("step-view", "change", (event) => this.set({ view: event.target.value }));
    on("step-before", "change", (event) => this.set({ before: event.target.checked }));
    on("step-length", "input", (event) => this.set({ length: lengthOf(event.target.value) }));
    for (let i = 0; i < 3; i++) {
      on(`depth-${i}`, "input", (event) => {
        this.state.v[5 * i + 2] = 2 ** Number(event.target.value);
        this.set({ case: "" });
      });
    }
    for (const name of this.cases.names()) {
      byId("step-case").append(element("option", { value: name }, name.replace(/_/g, " ")));
    }
    on("step-case", "change", (event) => this.openCase(event.target.value, 0));
  }

  /* What goes wrong when a state from outside is not one: it is said, and left. */
  openAddress(wanted) {
    const number = (key, or) => (Number.isFinite(Number(wanted[key] ?? NaN)) ? +wanted[key] : or);
    if (wanted.case !== undefined) {
      this.takeCase(wanted.case, number("triangle", 0));
    }
    if (wanted.v) {
      const v = wanted.v.split(",").map(Number), size = String(wanted.size).split("x").map(Number);
      if (v.length === FLOATS && v.every(Number.isFinite) && size.length === 2 &&
          size.every((n) => n >= 1 && n <= 4096)) {
        Object.assign(this.state, { v, size, case: "" });
      }
    }
    Object.assign(this.state, {
      stage: clamp(Math.round(number("stage", 2)), 1, 4),
      length: clamp(Math.round(number("length", 16)), 1, 4096),
      snap: [0, 1, 16].includes(number("snap", 0)) ? number("snap", 0) : 0,
      before: wanted.before === "1",
      view: wanted.view === "near" ? "near" : "fit",
      at: number("at", 0),
    });
    this.change();
    if (wanted.pixel) {
      this.pick(...wanted.pixel.split(",").map(Number));
    }
  }

  address() {
    const { stage, at, length, snap, before, size, v, view } = this.state;
    return { stage, at, ...(length === 16 ? {} : { length }), ...(snap ? { snap } : {}),
      ...(before ? { before: 1 } : {}), ...(view === "near" ? { view } : {}),
      ...(this.state.case ? { case: this.state.case, triangle: this.state.triangle }
        : { size: size.join("x"), v: v.join(",") }) };
  }

  takeCase(name, triangle) {
    const found = this.cases.get(name);
    const list = found ? found.triangles : [FIRST.v], k = clamp(triangle, 0, list.length - 1);
    Object.assign(this.state, { case: found ? name : "", triangle: k, at: 0, v: list[k].slice(),
      size: found ? found.size : FIRST.size });
  }

  openCase(name, triangle) {
    this.takeCase(name, triangle);
    this.change();
  }

  set(change) {
    Object.assign(this.state, change);
    this.change();
  }

  setStage(stage) {
    const event = this.run && this.run.at(this.state.at);
    this.state.stage = stage;
    this.change();
    if (event && KINDS[event.kind] === "pixel") {
      this.pick(event.x, event.y);
    }
  }

  move(i, x, y) {
    const { snap, size, v } = this.state;
    const to = (c, side) => {
      const grid = snap || 64; /* finer than any screen shows */
      return clamp(Math.round(c * grid) / grid, -0.5, side - 0.5);
    };
    v[5 * i] = to(x, size[0]);
    v[5 * i + 1] = to(y, size[1]);
    this.set({ case: "" });
  }

  /* To the step that draws this pixel. */
  pick(x, y) {
    const at = this.run.order.get(y * this.state.size[0] + x);
    if (at !== undefined) {
      this.go(at);
    }
  }

  go(at) {
    const last = this.run.events.length - 1;
    this.state.at = clamp(at, 0, Math.max(last, 0));
    this.drawAll();
    Address.write("step");
    return at < last;
  }

  /* To the next scanline's span, or the one before. */
  goRow(way) {
    const isSpan = (event) => event && KINDS[event.kind] === "span";
    let at = this.state.at + way;
    while (this.run.at(at) && !isSpan(this.run.at(at))) {
      at += way;
    }
    this.go(at);
  }

  key(event) {
    const action = { ArrowLeft: () => this.go(this.state.at - 1),
      ArrowRight: () => this.go(this.state.at + 1), ArrowUp: () => this.goRow(-1),
      ArrowDown: () => this.goRow(1) }[event.key];
    if (action) {
      event.preventDefault();
      action();
    }
  }

  /* The triangle is another, or the stage: everything anew. */
  change() {
    const { stages, state } = this;
    stages.open(...state.size);
    stages.segmentLength(state.length);
    this.list = stages.give([state.v]);
    this.measured = stages.measurable();
    this.run = this.trace(state.stage);
    this.earlier = state.stage > 1 && state.before ? this.trace(state.stage - 1) : null;
    this.results = new Map();
    for (const n of [...STEPPED, EXACT]) {
      this.results.set(n, this.measured && n !== EXACT ? stages.measure(n)
        : { frame: stages.draw(n), errors: null });
    }
    state.at = clamp(state.at, 0, Math.max(this.run.events.length - 1, 0));
    this.drawAll();
    Address.write("step");
  }

  /* The way of the triangle through a stage; of all its parts, where clipping cut it. */
  trace(stage) {
    const grid = stageOf(stage).grid;
    const runs = this.list.map((triangle, k) => {
      const corners = [0, 1, 2].map((i) => {
        const [x, y] = this.stages.rounded(k, i, grid);
        return { x, y, z: triangle[5 * i + 2], u: triangle[5 * i + 3], v: triangle[5 * i + 4] };
      });
      return new Run(stage, this.stages.trace(stage, k), corners, this.state.size[0], k);
    });
    return runs.length ? joinRuns(runs) : new Run(stage, [], [], this.state.size[0]);
  }

  window() {
    const { state } = this, [width, height] = state.size;
    const event = this.run.at(state.at);
    if (state.view === "near" && event && event.y !== undefined) {
      const x = Math.floor(event.x !== undefined ? event.x : event.v.x || 0);
      const w = Math.min(NEAR, width), h = Math.min(NEAR * 3 / 4, height);
      return { x: clamp(x - w / 2, 0, width - w), y: clamp(event.y - h / 2, 0, height - h), w, h };
    }
    return width <= 32 ? { x: 0, y: 0, w: width, h: height } : fit([state.v], state.size);
  }

  draw() {
    const { state, run } = this, event = run.at(state.at), result = this.results.get(state.stage);
    const spread = Math.max(...[3, 4].map((k) => Math.abs(state.v[k] - state.v[k + 5]) +
      Math.abs(state.v[k] - state.v[k + 10])));
    this.shift = spread > 128 ? 4 : 0;
    this.figure.draw({ window: this.window(), width: state.size[0], frame: result.frame,
      errors: result.errors, given: state.v, order: run.order, at: state.at, step: event,
      snap: state.snap, shift: this.shift,
      rounded: this.list.map((_, k) =>
        [0, 1, 2].map((i) => this.stages.rounded(k, i, stageOf(state.stage).grid))) });
    this.drawControls();
    this.panels.draw(this, event);
  }

  drawControls() {
    const { state, run } = this, count = run.events.length;
    this.stageChoice.press(state.stage);
    byId("step-slider").max = Math.max(count - 1, 0);
    byId("step-slider").value = state.at;
    byId("step-count").textContent = `Step ${count ? state.at + 1 : 0} of ${count}` +
      (count < EVENTS_MAX ? "" : "; there are more, which are not kept");
    byId("step-case").value = state.case;
    byId("step-snap").value = state.snap;
    byId("step-view").value = state.view;
    byId("step-before").checked = state.before;
    byId("step-before").disabled = state.stage === 1;
    for (let i = 0; i < 3; i++) {
      const z = state.v[5 * i + 2], slider = byId(`depth-${i}`);
      slider.value = Math.log2(z);
      slider.nextElementSibling.textContent = `z = ${show(z, 3)}`;
    }
    byId("step-length").value = Math.log2(state.length) > 6 ? 7 : Math.log2(state.length);
    byId("step-length").nextElementSibling.textContent =
      state.length > 64 ? "span" : plural(state.length, "pixel");
    this.drawTriangles();
  }

  /* Which of a case's triangles. */
  drawTriangles() {
    const { state } = this, found = this.cases.get(state.case), place = byId("step-triangles");
    const count = found ? found.triangles.length : 1;
    if (place.dataset.shown !== `${state.case} ${count}`) {
      place.dataset.shown = `${state.case} ${count}`;
      place.replaceChildren();
      if (count > 1) {
        const input = element("input", { type: "number", min: 0, max: count - 1, size: 4 });
        input.addEventListener("change", () =>
          this.openCase(state.case, Math.round(Number(input.value))));
        place.append(element("label", {}, `triangle of 0 to ${count - 1} `, input));
      }
    }
    if (count > 1) {
      place.querySelector("input").value = state.triangle;
    }
  }
}

const lengthOf = (slider) => (Number(slider) === 7 ? 4096 : 2 ** Number(slider));

/* The runs of the parts of a clipped triangle, one after the other. */
function joinRuns(runs) {
  const all = runs[0];
  for (const run of runs.slice(1)) {
    const from = all.events.length;
    for (const event of run.events) {
      for (const key of ["before", "span", "segment", "gradients"]) {
        event[key] = event[key] === undefined ? undefined : event[key] + from;
      }
      all.events.push(event);
    }
    run.order.forEach((i, pixel) => all.order.set(pixel, i + from));
  }
  return all;
}
