/* Pictures of the room: any two of seven, under one zoom and one cursor. The page has them; their
 * errors are measured here. Stage 5 and the coda cannot run in a browser: of these the page has the
 * frame with the texture `coord`, too. */

class Pictures extends Part {
  static async load(stages) {
    const rooms = new Map();
    stages.open(ROOM_SIZE);
    stages.room(ROOM_FRAME, 0, 0);
    stages.measurable();
    for (const { number } of STAGES) {
      const picture = byId(`picture-${number}`), coord = byId(`coord-${number}`);
      if (picture) {
        await picture.decode();
        rooms.set(number, { picture, ...(coord ? stages.compare(number, await pixelsOf(coord))
          : stages.measure(number)) });
      }
    }
    return new Pictures(rooms);
  }

  /* rooms: by number, a stage's picture, and how it errs there. */
  constructor(rooms) {
    const labels = Array.from(rooms.keys(), (n) => [n, `${n} ${stageOf(n).name}`]);
    super("pictures", {
      stage: oneOf(2, labels),
      with: oneOf(EXACT, labels),
      mode: oneOf("one", ["one", "blink", "swipe"].map((mode) => [mode, mode])),
      show: oneOf("picture", [["picture", "picture"], ["error", "error"]]),
      zoom: { ...whole(1, 1, 16), says: (n) => `${n}\u00d7` },
      at: several([160, 120], ",", 0, ROOM_SIZE[0] - 1),
    });
    Object.assign(this, { rooms, names: new Map(labels), canvas: byId("picture"), split: 0.5 });
    this.canvas.addEventListener("pointermove", (event) => this.point(event, false));
    this.canvas.addEventListener("pointerdown", (event) => this.point(event, true));
    this.canvas.addEventListener("keydown", (event) => {
      const way = arrow(event);
      if (way) {
        this.moveTo(this.state.at.map((c, axis) => c + way[axis]));
      }
    });
    addEventListener("keydown", (event) => this.digit(event));
    setInterval(() => {
      this.second = this.state.mode === "blink" && !this.second;
      if (this.state.mode === "blink") {
        this.drawSoon();
      }
    }, 600);
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

  moveTo(at) {
    this.hover = null;
    this.set({ at: at.map((c, axis) => clamp(c, 0, ROOM_SIZE[axis] - 1)) });
  }

  /* The window of the frame that the zoom shows, the cursor in its middle where that can be. */
  view() {
    const [w, h] = ROOM_SIZE.map((side) => side / this.state.zoom);
    const [x, y] = this.state.at.map((c, axis) =>
      Math.floor(clamp(c - [w, h][axis] / 2, 0, ROOM_SIZE[axis] - [w, h][axis])));
    return { x, y, w, h };
  }

  point(event, pressed) {
    const fx = event.offsetX / this.canvas.clientWidth, { x, y, w, h } = this.view();
    const fy = event.offsetY / this.canvas.clientHeight;
    const at = [Math.floor(x + fx * w), Math.floor(y + fy * h)];
    if (pressed) {
      this.moveTo(at);
    } else {
      this.hover = at;
      this.split = fx;
      this.drawSoon();
    }
  }

  paint(c, n, width, height, atRight) {
    const { x, y, w, h } = this.view(), { picture, errors } = this.rooms.get(n);
    if (this.state.show === "error") {
      drawPixels(c, (i, j) => {
        const error = errorAt(errors, (y + j) * ROOM_SIZE[0] + x + i);
        return pixelOf(error === 0 ? "raised" : errorClass(error));
      }, w, h, width / w);
    } else {
      c.imageSmoothingEnabled = false;
      c.drawImage(picture, x, y, w, h, 0, 0, width, height);
    }
    const [cx, cy] = this.hover || this.state.at;
    border(c, (cx - x) * width / w - 1, (cy - y) * height / h - 1, width / w + 2, height / h + 2,
      "now", 2);
    const name = this.names.get(n), wide = c.measureText(name).width + 12;
    const from = atRight ? width - wide : 0;
    c.fillStyle = colour("paper");
    c.fillRect(from, 0, wide, 20);
    label(c, name, from + 6, 10, "ink", "left");
  }

  draw() {
    const { state } = this, width = this.canvas.clientWidth || 640, height = width * 3 / 4;
    const [c] = context(this.canvas, height);
    this.paint(c, this.second ? state.with : state.stage, width, height);
    if (state.mode === "swipe") {
      const left = this.split * width;
      c.save();
      c.beginPath();
      c.rect(left, 0, width, height);
      c.clip();
      c.clearRect(0, 0, width, height);
      this.paint(c, state.with, width, height, true);
      c.restore();
      path(c, [[left, 0], [left, height]], "now", 3);
    }
    byId("error-legend").hidden = state.show !== "error";
    this.say();
  }

  /* What all of them have in the cursor's pixel. */
  say() {
    const [x, y] = this.hover || this.state.at, i = y * ROOM_SIZE[0] + x;
    const parts = Array.from(this.rooms).map(([n, { frame, errors }]) => {
      const error = errorAt(errors, i);
      return `${this.names.get(n)}: ` +
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
