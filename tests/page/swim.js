/* Swim: the room's brick wall while it moves by 1/64 pixel a frame, in stages 2 and 3 and as it
 * should be. */

const SWIM_FRAMES = 128;
const SWIM_WINDOW = { x: 163, y: 39, w: 72, h: 54 }; /* of the frame: the wall's far end */
const SWIM_STAGES = [2, 3, EXACT];
const SWIM_CHANGE = 2; /* texels: a change of 1 is what rounding to whole texels makes */
const letterOf = (n) => String.fromCharCode(65 + n);
const DIRECTIONS = { right: [1, 0], down: [0, 1], both: [1, 1] };

class Swim {
  constructor(stages) {
    this.stages = stages;
    this.state = { frame: 0, direction: "right", speed: 12 };
    this.changes = {}; /* direction: for each frame the change in stages 2 and 3, and who jumped */
    this.player = new Player("swim-play", () => this.go((this.state.frame + 1) % SWIM_FRAMES),
      () => this.state.speed);
    this.choice = new Choice("swim-direction",
      [["right", "to the right"], ["down", "down"], ["both", "both ways"]],
      (direction) => this.set({ direction }));
    this.views = SWIM_STAGES.map((n) => {
      const canvas = element("canvas", { role: "img", "aria-label":
        n === EXACT ? "The wall, exact" : `The wall, stage ${n}` });
      const says = element("figcaption");
      byId("swim-views").append(element("figure", {}, canvas, says));
      return { n, canvas, says };
    });
    this.drawSoon = later(() => this.draw());
    byId("swim-frame").addEventListener("input", (event) => this.go(Number(event.target.value)));
    byId("swim-speed").addEventListener("input",
      (event) => this.set({ speed: Number(event.target.value) }));
    byId("swim-mark").addEventListener("change", this.drawSoon);
    byId("swim-bars").addEventListener("click", (event) => {
      const box = event.target.getBoundingClientRect();
      this.go(clamp(Math.floor((event.clientX - box.left - 44) / (box.width - 54) * SWIM_FRAMES), 0,
        SWIM_FRAMES - 1));
    });
    addEventListener("resize", this.drawSoon);
    Address.part("swim", () => this.state, ({ frame, direction, speed }) => this.set({
      frame: clamp(Math.round(Number(frame) || 0), 0, SWIM_FRAMES - 1),
      direction: DIRECTIONS[direction] ? direction : "right",
      speed: clamp(Number(speed) || 12, 1, 60),
    }));
    new IntersectionObserver((entries, observer) => {
      if (entries.some((entry) => entry.isIntersecting)) {
        observer.disconnect();
        this.drawSoon();
      }
    }).observe(byId("swim-views"));
  }

  set(change) {
    Object.assign(this.state, change);
    Address.write("swim");
    this.drawSoon();
  }

  go(frame) {
    this.set({ frame });
    return true;
  }

  /* The wall in a frame: its triangles, and each stage's errors and pixels. */
  wall(frame, drawn) {
    const { stages } = this, [dx, dy] = DIRECTIONS[this.state.direction];
    stages.open(...ROOM_SIZE);
    const list = stages.room(ROOM_FRAME, dx * frame / 64, dy * frame / 64, TEXTURE_BRICKS);
    stages.measurable();
    const results = new Map(SWIM_STAGES.map((n) => {
      const result = n === EXACT ? { errors: null } : stages.measure(n);
      return [n, drawn ? { ...result, picture: stages.draw(n, TEXTURE_OWN) } : result];
    }));
    const rounded = (grid) => list.map((_, k) =>
      [0, 1, 2].map((i) => stages.rounded(k, i, grid)));
    const given = rounded(0).flat(), keys = given.map(String);
    const letters = given.map((p, i) => /* the same in all triangles that share the vertex */
      [letterOf(new Set(keys.slice(0, keys.indexOf(keys[i]))).size), p]);
    return { results, letters, rounded: new Map([[2, rounded(1)], [3, rounded(16)],
      [EXACT, rounded(0)]]) };
  }

  draw() {
    const { frame } = this.state, now = this.wall(frame, true);
    const before = frame > 0 ? this.wall(frame - 1, false) : now;
    for (const view of this.views) {
      this.drawView(view, now, before);
    }
    this.choice.press(this.state.direction);
    byId("swim-frame").value = frame;
    byId("swim-speed").value = this.state.speed;
    byId("swim-speed-says").textContent = this.state.speed;
    byId("swim-says").textContent = `${frame}: moved by ${frame}/64 pixel`;
    this.measureMore();
    this.drawBars();
  }

  drawView({ n, canvas, says }, now, before) {
    const { x, y, w, h } = SWIM_WINDOW, cell = (canvas.clientWidth || 300) / w;
    const [c] = context(canvas, Math.ceil(cell * h));
    const { picture, errors } = now.results.get(n), old = before.results.get(n).errors;
    drawPixels(c, (i, j) => picture[(y + j) * ROOM_SIZE[0] + x + i], w, h, cell);
    const changed = errors ? this.drawChanged(c, errors, old, cell) : 0;
    const at = ([px, py]) => [(px - x + 0.5) * cell, (py - y + 0.5) * cell];
    const outline = (points, name, dash) => points.forEach((p, i) =>
      line(c, ...at(p), ...at(points[(i + 1) % 3]), colour(name), 2, dash));
    now.rounded.get(n).forEach((triangle) => outline(triangle, "now", []));
    now.rounded.get(EXACT).forEach((triangle) => outline(triangle, "accent", [5, 4]));
    for (const [letter, p] of now.letters) {
      const [px, py] = at(p);
      if (px > 0 && py > 0 && px < w * cell && py < h * cell) {
        const jump = n !== EXACT && jumped(before, now, n).includes(letter);
        c.fillStyle = colour(jump ? "now" : "paper");
        c.beginPath();
        c.arc(px + 14, py, 10, 0, 7);
        c.fill();
        c.fillStyle = colour(jump ? "paper" : "ink");
        c.textAlign = "center";
        c.textBaseline = "middle";
        c.fillText(letter, px + 14, py);
      }
    }
    says.textContent = (n === EXACT ? "Exact" : `Stage ${n}: ${stageOf(n).name}`) + ". " +
      (n === EXACT ? "The texture goes along with the wall."
        : `${plural(changed, "pixel")} here changed by ${SWIM_CHANGE} texels or more` +
          `${jumped(before, now, n) ? `; vertex ${jumped(before, now, n)} jumped` : ""}.`);
  }

  drawChanged(c, errors, old, cell) {
    const { x, y, w, h } = SWIM_WINDOW, mark = byId("swim-mark").checked;
    let changed = 0;
    c.fillStyle = colour("changed");
    c.globalAlpha = 0.6;
    for (let i = 0; i < w * h; i++) {
      const px = x + i % w, py = y + Math.floor(i / w), at = py * ROOM_SIZE[0] + px;
      if (Math.abs(errors[2 * at] - old[2 * at]) >= SWIM_CHANGE ||
          Math.abs(errors[2 * at + 1] - old[2 * at + 1]) >= SWIM_CHANGE) {
        changed += 1;
        if (mark) {
          c.fillRect((px - x) * cell, (py - y) * cell, cell, cell);
        }
      }
    }
    c.globalAlpha = 1;
    return changed;
  }

  /* The frames are measured a few at a time, so that the page goes on meanwhile. */
  measureMore() {
    const all = this.changes[this.state.direction] ||= [];
    if (this.measuring || all.length >= SWIM_FRAMES) {
      return;
    }
    this.measuring = true;
    setTimeout(() => {
      this.measuring = false;
      const started = performance.now();
      this.last = all.length ? this.last : this.wall(0, false);
      while (all.length < SWIM_FRAMES && performance.now() - started < 12) {
        const now = this.wall(all.length, false);
        all.push(swimChange(this.last, now));
        this.last = now;
      }
      this.drawBars();
      this.measureMore();
    }, 0);
  }

  drawBars() {
    const all = this.changes[this.state.direction] || [], height = 110;
    const [c, width] = context(byId("swim-bars"), 2 * height + 50);
    const most = Math.max(0.01, ...all.flatMap((one) => [one[2], one[3]]));
    const step = (width - 54) / SWIM_FRAMES;
    [2, 3].forEach((n, row) => {
      const top = 20 + row * (height + 14);
      const area = plot(c, [44, top, width - 54, height - 20], [0, SWIM_FRAMES], [0, most], "");
      c.textAlign = "left";
      c.fillStyle = colour("ink");
      c.fillText(`Stage ${n}`, 48, top + 10);
      all.forEach((one, t) => {
        const [left, y] = area.at([t, one[n]]), [, bottom] = area.at([t, 0]);
        c.fillStyle = colour(t === this.state.frame ? "now" : one.jumps[n] ? "warn" : "soft");
        c.fillRect(left, y, Math.max(step - 1, 1), bottom - y);
        if (n === 2 && one.jumps[n]) {
          c.textAlign = "center";
          c.fillText(one.jumps[n], left + step / 2, Math.max(y - 7, top - 8));
        }
      });
    });
  }
}

/* From one frame to the next: the RMS of the change of error in stages 2 and 3, and the vertices
 * that were rounded to another place than before. */
function swimChange(before, now) {
  const change = { jumps: {} };
  for (const n of [2, 3]) {
    const a = before.results.get(n).errors, b = now.results.get(n).errors;
    let sum = 0;
    for (let i = 0; i < a.length; i++) {
      if (a[i] !== OTHER_SURFACE && b[i] !== OTHER_SURFACE) {
        sum += (a[i] - b[i]) ** 2;
      }
    }
    change[n] = Math.sqrt(sum / Math.max(now.results.get(n).pixels, 1));
    change.jumps[n] = jumped(before, now, n);
  }
  return change;
}

/* The letters of the vertices that a stage rounds to another place than before. */
function jumped(before, now, n) {
  const was = before.rounded.get(n).flat(), found = now.rounded.get(n).flat()
    .map((p, i) => (was[i] && (was[i][0] !== p[0] || was[i][1] !== p[1]) ? now.letters[i][0] : ""));
  return Array.from(new Set(found)).sort().join("");
}

/* Pixels 0xAARRGGBB, one by one, so that each is sharp. */
function drawPixels(c, pixelAt, w, h, cell) {
  const image = new ImageData(w, h), bytes = new Uint32Array(image.data.buffer);
  for (let i = 0; i < w * h; i++) {
    bytes[i] = swapped(pixelAt(i % w, Math.floor(i / w)));
  }
  const canvas = drawPixels.canvas ||= document.createElement("canvas");
  canvas.width = w;
  canvas.height = h;
  canvas.getContext("2d").putImageData(image, 0, 0);
  c.imageSmoothingEnabled = false;
  c.drawImage(canvas, 0, 0, w * cell, h * cell);
}

/* From 0xAARRGGBB to the order of a canvas's bytes: R first. */
const swapped = (pixel) => pixel & 0xFF00FF00 | (pixel & 0xFF) << 16 | pixel >>> 16 & 0xFF;
