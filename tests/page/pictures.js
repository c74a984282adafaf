/* Pictures of the room: any two of seven, under one zoom and one cursor. Stages 1 to 4 and the
 * exact answer are drawn here; stage 5 and the coda cannot run in a browser: the page has them. */

const MODES = [["one", "one"], ["blink", "blink"], ["swipe", "swipe"]];

class Pictures {
  constructor(stages) {
    this.stages = stages;
    this.state = { stage: 2, with: EXACT, mode: "one", show: "picture", zoom: 1, at: [160, 120] };
    this.canvas = byId("picture");
    this.split = 0.5; /* of the canvas, in swipe */
    this.drawSoon = later(() => this.draw());
  }

  /* Draws and measures everything: 50 ms. */
  async load() {
    const { stages } = this;
    const recorded = new Map();
    for (const n of [5, 6]) {
      if (byId(`picture-${n}`)) {
        recorded.set(n, await Promise.all([pixelsOf(byId(`picture-${n}`)),
          pixelsOf(byId(`coord-${n}`))]));
      }
    }
    stages.open(...ROOM_SIZE);
    stages.segmentLength(16);
    stages.room(ROOM_FRAME, 0, 0);
    stages.measurable();
    this.rooms = new Map();
    for (const { number } of STAGES) {
      if (recorded.has(number)) {
        const [pixels, coord] = recorded.get(number);
        this.rooms.set(number, { ...stages.compare(number, coord), picture: pixels });
      } else if (number !== 5 && number !== 6) {
        this.rooms.set(number, { ...stages.measure(number),
          picture: stages.draw(number, TEXTURE_OWN) });
      }
    }
    this.listen();
    this.draw();
  }

  name(n) {
    return `${n} ${stageOf(n).name}`;
  }

  listen() {
    const numbers = Array.from(this.rooms.keys());
    this.choice = new Choice("picture-stage", numbers.map((n) => [n, this.name(n)]),
      (stage) => this.set({ stage }));
    this.modes = new Choice("picture-mode", MODES, (mode) => this.set({ mode }));
    this.shows = new Choice("picture-show", [["picture", "picture"], ["error", "error"]],
      (show) => this.set({ show }));
    byId("picture-with").append(...numbers.map((n) =>
      element("option", { value: n }, this.name(n))));
    byId("picture-with").addEventListener("change",
      (event) => this.set({ with: Number(event.target.value) }));
    byId("picture-zoom").addEventListener("input",
      (event) => this.set({ zoom: 2 ** Number(event.target.value) }));
    byId("error-legend").append(...ERROR_CLASSES.map(([name, text]) => element("li", {},
      element("i", { class: "key", style: `background: var(--${name})` }), text)));
    this.canvas.addEventListener("pointermove", (event) => this.point(event));
    this.canvas.addEventListener("pointerdown", (event) => this.point(event, true));
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    addEventListener("keydown", (event) => this.digit(event));
    addEventListener("resize", this.drawSoon);
    setInterval(() => {
      if (this.state.mode === "blink") {
        this.second = !this.second;
        this.drawSoon();
      }
    }, 600);
    const number = (text, or) => (this.rooms.has(Number(text)) ? Number(text) : or);
    Address.part("pictures", () => ({ ...this.state, at: this.state.at.join(",") }), (wanted) => {
      const at = (wanted.at || "").split(",").map(Number);
      this.set({ stage: number(wanted.stage, 2), with: number(wanted.with, EXACT),
        mode: this.modes.buttons.has(wanted.mode) ? wanted.mode : "one",
        show: wanted.show === "error" ? "error" : "picture",
        zoom: clamp(2 ** Math.round(Math.log2(Number(wanted.zoom) || 1)), 1, 16),
        at: at.length === 2 && at.every(Number.isFinite)
          ? at.map((c, i) => clamp(Math.round(c), 0, ROOM_SIZE[i] - 1)) : [160, 120] });
    });
  }

  set(change) {
    Object.assign(this.state, change);
    this.second = false;
    Address.write("pictures");
    this.drawSoon();
  }

  /* Keys 1 to 7 wherever the picture is in sight and no field has the keyboard. */
  digit(event) {
    const box = this.canvas.getBoundingClientRect(), n = Number(event.code.replace("Digit", ""));
    const busy = event.target.matches("input[type=number], select");
    if (!busy && !event.ctrlKey && !event.altKey && !event.metaKey && this.rooms.has(n) &&
        box.top < innerHeight && box.bottom > 0) {
      this.set(event.shiftKey ? { with: n } : { stage: n });
    }
  }

  key(event) {
    const [dx, dy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1],
      ArrowDown: [0, 1] }[event.key] || [0, 0];
    if (dx || dy) {
      event.preventDefault();
      this.moveTo(this.state.at[0] + dx, this.state.at[1] + dy);
    }
  }

  moveTo(x, y) {
    this.set({ at: [clamp(x, 0, ROOM_SIZE[0] - 1), clamp(y, 0, ROOM_SIZE[1] - 1)] });
  }

  /* The window of the frame that the zoom shows: the cursor stays where it is on the canvas. */
  view() {
    const [width, height] = ROOM_SIZE, { zoom, at: [x, y] } = this.state;
    const w = width / zoom, h = height / zoom;
    return { w, h, x: Math.floor(clamp(x - w / 2, 0, width - w)),
      y: Math.floor(clamp(y - h / 2, 0, height - h)) };
  }

  point(event, pressed = false) {
    const box = this.canvas.getBoundingClientRect();
    const fx = (event.clientX - box.left) / box.width, fy = (event.clientY - box.top) / box.height;
    if (this.state.mode === "swipe" && !pressed) {
      this.split = fx;
      this.drawSoon();
    }
    const { x, y, w, h } = this.view();
    this.hover = [Math.floor(x + fx * w), Math.floor(y + fy * h)];
    if (pressed) {
      this.moveTo(...this.hover);
    } else {
      this.drawSoon();
    }
  }

  paint(c, n, width, height) {
    const { x, y, w, h } = this.view(), room = this.rooms.get(n);
    const at = (i, j) => (y + j) * ROOM_SIZE[0] + x + i;
    drawPixels(c, (i, j) => {
      const error = this.state.show === "error" ? errorAt(room.errors, at(i, j)) : -1;
      return error < 0 ? room.picture[at(i, j)]
        : pixelOf(error === 0 ? "raised" : errorClass(error));
    }, w, h, width / w);
    const [cx, cy] = this.hover || this.state.at;
    c.strokeStyle = colour("now");
    c.lineWidth = 2;
    c.strokeRect((cx - x) * width / w - 1, (cy - y) * height / h - 1, width / w + 2,
      height / h + 2);
    c.fillStyle = colour("paper");
    c.globalAlpha = 0.85;
    c.fillRect(0, 0, c.measureText(this.name(n)).width + 12, 20);
    c.globalAlpha = 1;
    c.fillStyle = colour("ink");
    c.textBaseline = "middle";
    c.fillText(this.name(n), 6, 10);
  }

  draw() {
    const { state } = this, width = this.canvas.clientWidth || 640, height = width * 3 / 4;
    const [c] = context(this.canvas, height);
    this.paint(c, state.mode === "blink" && this.second ? state.with : state.stage, width, height);
    if (state.mode === "swipe") {
      const left = this.split * width;
      c.save();
      c.beginPath();
      c.rect(left, 0, width, height);
      c.clip();
      c.clearRect(0, 0, width, height);
      this.paint(c, state.with, width, height);
      c.restore();
      line(c, left, 0, left, height, colour("now"), 3);
    }
    this.choice.press(state.stage);
    this.modes.press(state.mode);
    this.shows.press(state.show);
    byId("picture-with").value = state.with;
    byId("picture-zoom").value = Math.log2(state.zoom);
    byId("error-legend").hidden = state.show !== "error";
    this.say();
  }

  /* What all of them have in the cursor's pixel. */
  say() {
    const [x, y] = this.hover || this.state.at, i = y * ROOM_SIZE[0] + x;
    const parts = Array.from(this.rooms).map(([n, { frame, errors }]) => {
      const error = errorAt(errors, i);
      return `${this.name(n)}: ` +
        (frame[i] ? `${texelU(frame[i])}, ${texelV(frame[i])}` : "nothing") +
        (error === OTHER_SURFACE ? " (another surface)" : error ? ` (off by ${error})` : "");
    });
    byId("picture-says").textContent = `Pixel ${x}, ${y}, texel u, v in ${parts.join("; ")}.`;
  }
}

/* A picture of the page as pixels 0xAARRGGBB; black is background. */
async function pixelsOf(image) {
  await image.decode();
  const canvas = element("canvas", { width: image.naturalWidth, height: image.naturalHeight });
  const c = canvas.getContext("2d");
  c.drawImage(image, 0, 0);
  const bytes = c.getImageData(0, 0, canvas.width, canvas.height).data;
  return new Uint32Array(bytes.buffer).map((pixel) => (pixel & 0xFFFFFF ? swapped(pixel) : 0));
}

/* A colour of page.css, #rrggbb there, as 0xAARRGGBB. */
const pixelOf = (name) =>
  (colours[`${name} pixel`] ||= (0xFF000000 | parseInt(colour(name).slice(1), 16)) >>> 0);
