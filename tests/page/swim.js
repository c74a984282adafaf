/* Swim: the room's brick wall while it moves by 1/64 pixel a frame, in stages 2 and 3 and as it
 * should be. */

const SWIM_FRAMES = 128;
const SWIM_WINDOW = { x: 163, y: 39, w: 72, h: 54 }; /* of the frame: the wall's far end */
const SWIM_STAGES = [2, 3, EXACT];
const SWIM_CHANGE = 2; /* texels: a change of 1 is what rounding to whole texels makes */
const SWIM_BARS = 110; /* CSS pixels high */
const DIRECTIONS = { right: [1, 0], down: [0, 1], both: [1, 1] };

class Swim extends Part {
  constructor(stages) {
    super("swim", {
      frame: { ...whole(0, 0, SWIM_FRAMES - 1), says: (n) => `${n}: moved by ${n}/64 pixel` },
      direction: oneOf("right", [["right", "to the right"], ["down", "down"],
        ["both", "both ways"]]),
      speed: { ...whole(12, 1, 60), says: String },
    });
    this.stages = stages;
    this.changes = {}; /* direction: for each frame the change in stages 2 and 3, and who jumped */
    this.views = SWIM_STAGES.map((n) => {
      const canvas = element("canvas", { role: "img", "aria-label":
        n === EXACT ? "The wall, exact" : `The wall, stage ${n}` });
      const says = element("figcaption");
      byId("swim-views").append(element("figure", {}, canvas, says));
      return { n, canvas, says };
    });
    byId("swim-bars").addEventListener("click", ({ offsetX, target }) => this.set({ frame:
      clamp(Math.floor((offsetX - 44) / (target.clientWidth - 54) * SWIM_FRAMES), 0,
        SWIM_FRAMES - 1) }));
    new IntersectionObserver((entries, observer) => {
      if (entries.some((entry) => entry.isIntersecting)) {
        observer.disconnect();
        this.drawSoon();
      }
    }).observe(byId("swim-views"));
  }

  next() {
    this.set({ frame: (this.state.frame + 1) % SWIM_FRAMES });
  }

  /* The wall in a frame: its triangles' vertices, and each stage's errors and, drawn, pixels. */
  wall(frame, drawn = false) {
    const { stages } = this, [dx, dy] = DIRECTIONS[this.state.direction];
    stages.open(ROOM_SIZE);
    const list = stages.room(ROOM_FRAME, dx * frame / 64, dy * frame / 64, TEXTURE_BRICKS);
    stages.measurable();
    return new Map(SWIM_STAGES.map((n) => [n, {
      ...(n === EXACT ? {} : stages.measure(n)),
      triangles: list.map((triangle) => cornersOf(triangle, stageOf(n).grid)),
      picture: drawn && stages.draw(n, TEXTURE_OWN),
    }]));
  }

  draw() {
    const { frame } = this.state, now = this.wall(frame, true);
    const before = frame > 0 ? this.wall(frame - 1) : now;
    for (const view of this.views) {
      this.drawView(view, now, before);
    }
    this.measureMore();
    this.drawBars();
  }

  drawView({ n, canvas, says }, now, before) {
    const { x, y, w, h } = SWIM_WINDOW, cell = (canvas.clientWidth || 300) / w;
    const [c] = context(canvas, Math.ceil(cell * h)), { picture, triangles } = now.get(n);
    drawPixels(c, (i, j) => picture[(y + j) * ROOM_SIZE[0] + x + i], w, h, cell);
    const changed = n === EXACT ? 0 : drawChanged(c, now.get(n).errors, before.get(n).errors, cell);
    const at = (px, py) => [(px - x + 0.5) * cell, (py - y + 0.5) * cell];
    const given = now.get(EXACT).triangles, jumps = n === EXACT ? "" : jumped(before, now, n);
    triangles.forEach((points) => outline(c, points, at, "now", 2));
    given.forEach((points) => outline(c, points, at, "accent", 2, [5, 4]));
    for (const [letter, vertex] of lettersOf(given)) {
      const [px, py] = at(vertex.x, vertex.y), jump = jumps.includes(letter);
      dot(c, [px + 14, py], 10, jump ? "now" : "paper");
      label(c, letter, px + 14, py, jump ? "paper" : "ink");
    }
    says.textContent = n === EXACT ? "Exact. The texture goes along with the wall."
      : `Stage ${n}: ${stageOf(n).name}. ${plural(changed, "pixel")} here changed by ` +
        `${SWIM_CHANGE} texels or more` +
        (jumps ? `; ${jumps.length > 1 ? "vertices" : "vertex"} ${[...jumps].join(", ")} jumped.`
          : ".");
  }

  /* The frames are measured one by one, so that the page goes on meanwhile. */
  measureMore() {
    const all = this.changes[this.state.direction] ||= [];
    clearTimeout(this.measuring);
    if (all.length < SWIM_FRAMES) {
      this.measuring = setTimeout(() => {
        const last = this.wall(Math.max(all.length - 1, 0)), now = this.wall(all.length);
        all.push([2, 3].map((n) => ({ rms: swimChange(last.get(n), now.get(n)),
          jumps: jumped(last, now, n) })));
        this.drawBars();
        this.measureMore();
      }, 0);
    }
  }

  drawBars() {
    const all = this.changes[this.state.direction], height = SWIM_BARS;
    const [c, width] = context(byId("swim-bars"), 2 * height + 50);
    const most = Math.max(0.01, ...all.flat().map(({ rms }) => rms));
    const step = (width - 54) / SWIM_FRAMES;
    [2, 3].forEach((n, row) => {
      const top = 20 + row * (height + 14);
      const at = plot(c, [44, top, width - 54, height - 20], [0, SWIM_FRAMES], [0, most], "");
      label(c, `Stage ${n}`, 48, top + 10, "ink", "left");
      all.forEach((one, t) => {
        const { rms, jumps } = one[row], [left, y] = at([t, rms]), [, bottom] = at([t, 0]);
        const fill = t === this.state.frame ? "now" : jumps ? "warn" : "soft";
        label(c, n === 2 ? jumps : "", left + step / 2, Math.max(y - 7, top - 8), fill);
        c.fillRect(left, y, Math.max(step - 1, 1), bottom - y);
      });
    });
  }
}

/* Marks the pixels whose error is another by SWIM_CHANGE texels or more; returns how many. */
function drawChanged(c, errors, old, cell) {
  const { x, y, w, h } = SWIM_WINDOW;
  let changed = 0;
  c.fillStyle = colour("changed");
  c.globalAlpha = 0.6;
  for (let i = 0; i < w * h; i++) {
    const px = i % w, py = Math.floor(i / w), at = 2 * ((y + py) * ROOM_SIZE[0] + x + px);
    if ([at, at + 1].some((axis) => Math.abs(errors[axis] - old[axis]) >= SWIM_CHANGE)) {
      changed += 1;
      c.fillRect(px * cell, py * cell, cell, cell);
    }
  }
  c.globalAlpha = 1;
  return changed;
}

/* From one frame to the next: the RMS of the change of a stage's error. */
function swimChange({ errors: a }, { errors: b, pixels }) {
  let sum = 0;
  for (let i = 0; i < a.length; i++) {
    if (a[i] !== OTHER_SURFACE && b[i] !== OTHER_SURFACE) {
      sum += (a[i] - b[i]) ** 2;
    }
  }
  return Math.sqrt(sum / Math.max(pixels, 1));
}

/* By letter, the vertices; one that triangles share has one letter. */
function lettersOf(triangles) {
  const all = new Map(triangles.flat().map((vertex) => [`${vertex.x} ${vertex.y}`, vertex]));
  return new Map(Array.from(all.values(), (vertex, i) => [String.fromCharCode(65 + i), vertex]));
}

/* The letters of the vertices that a stage rounds to another place than before. */
function jumped(before, now, n) {
  const was = lettersOf(before.get(EXACT).triangles), place = placeOn(stageOf(n).grid);
  return Array.from(lettersOf(now.get(EXACT).triangles)).filter(([letter, { x, y }]) => {
    const old = was.get(letter);
    return old && (place(x) !== place(old.x) || place(y) !== place(old.y));
  }).map(([letter]) => letter).join("");
}
