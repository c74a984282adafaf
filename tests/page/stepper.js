/* The stepper: one triangle, any stage, step by step, and all stages beside each other. */

const FIRST = { size: [26, 12], v: [1.703125, 1.421875, 1, 0, 0, 24.296875, 3.234375, 4, 31, 3,
  8.640625, 10.703125, 2, 8, 20] };
const NEAR = 24; /* pixels across the view around a step */
const STEPPED = [1, 2, 3, 4];

class Stepper extends Part {
  constructor(stages, cases) {
    super("step", {
      stage: oneOf(2, STEPPED.map((n) => [n, `${n} ${stageOf(n).name}`])),
      at: whole(0, 0, EVENTS_MAX),
      length: { ...whole(16, 1, 4096), says: (n) => (n > 64 ? "span" : plural(n, "pixel")) },
      snap: oneOf(0, [[0, "nothing"], [16, "1/16 pixel"], [1, "whole pixels"]]),
      case: oneOf("", [["", "the first triangle"],
        ...Array.from(cases.all.keys(), (name) => [name, name.replace(/_/g, " ")])]),
      triangle: whole(0, 0, TRIANGLES_MAX - 1),
      before: whole(0, 0, 1),
      size: several(FIRST.size, "x", 1, 4096),
      v: several(FIRST.v, ",", -65536, 65536),
      view: oneOf("", [["", "automatic"], ["fit", "all of it"],
        ["near", "24 pixels around the step"]]),
    });
    Object.assign(this, { stages, cases });
    this.figure = new Figure(this);
    this.panels = new Panels((stage) => this.set({ stage }));
    byId("step-slider").addEventListener("wheel", (event) => {
      event.preventDefault();
      this.step(Math.sign(event.deltaY));
    }, { passive: false });
    for (let i = 0; i < 3; i++) {
      byId(`depth-${i}`).addEventListener("input",
        (event) => this.moveTo(5 * i + 2, [2 ** event.target.value]));
    }
    this.set({});
  }

  open(wanted) {
    super.open(wanted);
    if (wanted.pixel) {
      this.pick(...wanted.pixel.split(",").map(Number));
    }
  }

  /* A case says what size and v are. */
  address() {
    return super.address().filter(([key]) => !this.state.case || key !== "size" && key !== "v");
  }

  /* Another triangle, or stage: everything anew, and in another stage the same pixel. */
  set(change) {
    const { stages, state } = this, event = this.run && this.run.at(state.at);
    const chosen = change.v === undefined && (change.case ?? change.triangle) !== undefined;
    Object.assign(state, chosen ? { at: 0, triangle: 0, view: "", ...FIRST } : {}, change);
    if (change.snap && change.case === undefined) { /* chosen just now */
      const snapped = (c) => Math.round(c * state.snap) / state.snap;
      Object.assign(state, { case: "", v: state.v.map((c, k) => (k % 5 < 2 ? snapped(c) : c)) });
    }
    const found = this.cases.all.get(state.case);
    if (found) {
      state.triangle = Math.min(state.triangle, found.triangles.length - 1);
      Object.assign(state, { size: found.size, v: found.triangles[state.triangle] });
    }
    stages.open(state.size, state.length);
    this.list = stages.give([state.v]);
    this.run = this.trace(state.stage);
    this.earlier = state.stage > 1 && state.before ? this.trace(state.stage - 1) : null;
    this.results = stages.results();
    this.go(state.at);
    if (change.at === undefined && event && event.x !== undefined) {
      this.pick(event.x, event.y);
    }
  }

  moveTo(place, numbers) {
    const v = this.state.v.slice();
    v.splice(place, numbers.length, ...numbers);
    this.set({ v, case: "", at: this.state.at });
  }

  move(i, x, y) {
    const { snap, size } = this.state, grid = snap || 64; /* finer than any screen shows */
    this.moveTo(5 * i, [x, y].map((c, axis) =>
      clamp(Math.round(c * grid) / grid, -0.5, size[axis] - 0.5)));
  }

  /* To the step that draws this pixel. */
  pick(x, y) {
    this.go(this.run.order.get(y * this.state.size[0] + x) ?? this.state.at);
  }

  go(at) {
    super.set({ at: clamp(at, 0, Math.max(this.run.events.length - 1, 0)) });
  }

  /* To the next scanline's span, or the one before. */
  row(way) {
    const isSpan = (event) => !event || KINDS[event.kind] === "span";
    let at = this.state.at + way;
    while (!isSpan(this.run.at(at))) {
      at += way;
    }
    this.go(at);
  }

  key(event) {
    const [dx, dy] = arrow(event) || [0, 0];
    this.step(dx);
    if (dy) {
      this.row(dy);
    }
  }

  /* The way of the triangle through a stage; of all its parts, where clipping cut it. */
  trace(stage) {
    const run = new Run(stage, this.state.size[0]);
    this.list.forEach((triangle, k) =>
      run.add(this.stages.trace(stage, k), cornersOf(triangle, stageOf(stage).grid)));
    return run;
  }

  window() {
    const { state } = this, [width, height] = state.size;
    const event = this.run.at(state.at), small = state.case && thin(state.v);
    if (state.view === "near" || state.view === "" && small) {
      const [x, y] = (!event || event.y === undefined ? state.v /* vertex A */
        : [event.x ?? event.first ?? event.v.x, event.y]).map(Math.floor);
      const w = Math.min(NEAR, width), h = Math.min(NEAR * 3 / 4, height);
      return { x: clamp(x - w / 2, 0, width - w), y: clamp(y - h / 2, 0, height - h), w, h };
    }
    return width <= 32 ? { x: 0, y: 0, w: width, h: height } : fit([state.v], state.size);
  }

  draw() {
    const event = this.run.at(this.state.at);
    this.figure.draw(this, event);
    this.panels.draw(this, event);
  }

  showState() {
    const { state, run } = this, count = run.events.length;
    const found = this.cases.all.get(state.case), triangle = byId("step-triangle");
    triangle.max = found ? found.triangles.length - 1 : 0;
    triangle.parentNode.hidden = triangle.max < 1;
    byId("step-slider").max = Math.max(count - 1, 0);
    byId("step-before").disabled = state.stage === 1;
    super.showState();
    byId("step-count").textContent = `Step ${count ? state.at + 1 : 0} of ${count}` +
      (count < EVENTS_MAX ? "" : "; there are more, which are not kept");
    for (let i = 0; i < 3; i++) {
      const z = state.v[5 * i + 2], slider = byId(`depth-${i}`);
      slider.value = Math.log2(z);
      slider.nextElementSibling.textContent = `z = ${show(z, 3)}`;
    }
  }
}
