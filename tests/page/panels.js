/* Every stage's picture, error map and difference from the stage before: one cursor, one zoom. */

const OTHER_SURFACE = 255; /* than the exact answer shows */
const TEXTURE_NONE = 255;
const ZOOM_MAX = 32;
const MAIN_SCALE = 2; /* the large panel's pixels for each of the picture's, at zoom 1 */
const KINDS = ["picture", "error", "change"];

/* Colours by how many texels apart, doubling; as `texmap diff` has them. */
const DISTANCE_COLOURS = [[32, 96, 255], [0, 192, 255], [0, 255, 96], [255, 255, 0], [255, 144, 0],
  [255, 32, 0]];
const DISTANCE_NAMES = ["1", "2\u20133", "4\u20137", "8\u201315", "16\u201331", "32 or more"];
const OTHER_COLOUR = [255, 0, 255];

function distanceColour(distance) {
  return distance === OTHER_SURFACE ? OTHER_COLOUR
    : DISTANCE_COLOURS[Math.min(Math.floor(Math.log2(distance)), DISTANCE_COLOURS.length - 1)];
}

/* What the stages drew: the room's planes, asked by stage and pixel. The last "stage" is the exact
 * answer. */
class Room {
  constructor(data, planes, textures) {
    Object.assign(this, data, { planes, textures });
    this.exact = data.stages.length;
  }

  static async load() {
    const data = dataOf("room");
    return new Room(data, await unpack(data.planes), await unpack(data.textures));
  }

  value(plane, stage, x, y) {
    return this.planes[((y * 4 + plane) * (this.exact + 1) + stage) * this.width + x];
  }

  pixel(stage, x, y) {
    return { u: this.value(0, stage, x, y), v: this.value(1, stage, x, y),
      texture: this.value(2, stage, x, y), error: this.value(3, stage, x, y) };
  }

  colour(pixel) {
    if (pixel.texture === TEXTURE_NONE) {
      return [0, 0, 0];
    }
    const at = 3 * ((pixel.texture * this.side + pixel.v) * this.side + pixel.u);
    return this.textures.subarray(at, at + 3);
  }

  /* Texels between what two stages show in a pixel, on the axis where they differ more. */
  distance(a, b) {
    if (a.texture !== b.texture) {
      return OTHER_SURFACE;
    }
    return Math.max(Math.abs(wrapped(a.u, b.u, this.side)), Math.abs(wrapped(a.v, b.v, this.side)));
  }

  /* How far off one kind of panel says that a pixel is; null for pictures. */
  off(kind, stage, x, y) {
    if (kind === "picture") {
      return null;
    }
    const pixel = this.pixel(stage, x, y);
    return kind === "error" ? pixel.error : this.distance(this.pixel(stage - 1, x, y), pixel);
  }

  paint(kind, stage) {
    const canvas = element("canvas", { width: this.width, height: this.height });
    const context = canvas.getContext("2d");
    const image = context.createImageData(this.width, this.height);
    for (let y = 0, at = 0; y < this.height; y++) {
      for (let x = 0; x < this.width; x++, at += 4) {
        const off = this.off(kind, stage, x, y);
        const colour = off ? distanceColour(off) : this.colour(this.pixel(stage, x, y));
        const dim = off === 0 ? 4 : 1;
        for (let i = 0; i < 3; i++) {
          image.data[at + i] = colour[i] / dim;
        }
        image.data[at + 3] = 255;
      }
    }
    context.putImageData(image, 0, 0);
    return canvas;
  }
}

class Panels {
  constructor(room) {
    this.room = room;
    this.x = Math.floor(room.width * 0.62);
    this.y = Math.floor(room.height * 0.55);
    this.left = this.top = 0;
    this.zoom = 1;
    this.views = [];
    for (let stage = 0; stage <= room.exact; stage++) {
      for (const kind of stage === room.exact ? ["picture"] : KINDS) {
        this.addView(kind, stage);
      }
    }
    byId("thumbs").append(element("div", { class: "blank" }));
    this.main = byId("main-canvas");
    this.main.width = MAIN_SCALE * room.width;
    this.main.height = MAIN_SCALE * room.height;
    this.listen();
    this.showLegend();
    this.choose(this.views[0]);
  }

  addView(kind, stage) {
    if (kind === "change" && stage === 0) {
      byId("thumbs").append(element("div"));
      return;
    }
    const { room } = this;
    const digit = stage < room.exact ? room.stages[stage].digit : "";
    const name = stage === room.exact ? "exact answer" : kind === "picture" ? `stage ${digit}`
      : kind === "error" ? `${digit}: error` : `${digit} against ${room.stages[stage - 1].digit}`;
    const canvas = element("canvas", { width: room.width, height: room.height });
    const button = element("button", { "aria-pressed": "false" }, canvas, name);
    const view = { kind, stage, name, canvas, button, source: room.paint(kind, stage) };
    button.addEventListener("click", () => this.choose(view));
    byId("thumbs").append(button);
    this.views.push(view);
  }

  choose(view) {
    this.chosen = view;
    for (const other of this.views) {
      other.button.setAttribute("aria-pressed", String(other === view));
    }
    this.draw();
  }

  listen() {
    const panel = byId("main-panel");
    const point = (event) => this.point(event);
    panel.addEventListener("pointermove", point);
    panel.addEventListener("pointerdown", point);
    panel.addEventListener("keydown", (event) => this.key(event));
    byId("zoom-in").addEventListener("click", () => this.setZoom(this.zoom * 2));
    byId("zoom-out").addEventListener("click", () => this.setZoom(this.zoom / 2));
  }

  point(event) {
    const box = this.main.getBoundingClientRect();
    const across = (event.clientX - box.left) / box.width / this.zoom;
    const down = (event.clientY - box.top) / box.height / this.zoom;
    this.move(Math.floor(this.left + across * this.room.width),
      Math.floor(this.top + down * this.room.height));
  }

  key(event) {
    const step = event.shiftKey ? 10 : 1;
    const moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step],
      ArrowDown: [0, step] };
    if (event.key in moves) {
      this.move(this.x + moves[event.key][0], this.y + moves[event.key][1]);
    } else if (event.key === "+" || event.key === "=") {
      this.setZoom(this.zoom * 2);
    } else if (event.key === "-") {
      this.setZoom(this.zoom / 2);
    } else {
      return;
    }
    event.preventDefault();
  }

  /* Moves the cursor, and what is seen only where the cursor would leave it. */
  move(x, y) {
    const { width, height } = this.room;
    this.x = Math.max(0, Math.min(x, width - 1));
    this.y = Math.max(0, Math.min(y, height - 1));
    const [across, down] = [width / this.zoom, height / this.zoom];
    this.left = Math.max(this.x + 1 - across, Math.min(this.left, this.x));
    this.top = Math.max(this.y + 1 - down, Math.min(this.top, this.y));
    this.draw();
  }

  /* Zooms about the cursor. */
  setZoom(zoom) {
    const { width, height } = this.room;
    this.zoom = Math.max(1, Math.min(zoom, ZOOM_MAX));
    const [across, down] = [width / this.zoom, height / this.zoom];
    this.left = Math.max(0, Math.min(Math.round(this.x - across / 2), width - across));
    this.top = Math.max(0, Math.min(Math.round(this.y - down / 2), height - down));
    byId("zoom-says").textContent = `${this.zoom}\u00D7`;
    this.draw();
  }

  drawView(view, canvas) {
    const { width, height } = this.room;
    const context = canvas.getContext("2d");
    const scale = this.zoom * canvas.width / width;
    context.imageSmoothingEnabled = false;
    context.drawImage(view.source, this.left, this.top, width / this.zoom, height / this.zoom, 0, 0,
      canvas.width, canvas.height);
    const size = Math.max(scale, 5), grow = (size - scale) / 2;
    const x = (this.x - this.left) * scale - grow, y = (this.y - this.top) * scale - grow;
    context.lineWidth = 1;
    context.strokeStyle = "#000";
    context.strokeRect(x - 1.5, y - 1.5, size + 3, size + 3);
    context.strokeStyle = "#fff";
    context.strokeRect(x - 0.5, y - 0.5, size + 1, size + 1);
  }

  draw() {
    for (const view of this.views) {
      this.drawView(view, view.canvas);
    }
    this.drawView(this.chosen, this.main);
    byId("main-caption").textContent = `Shown large: ${this.chosen.name}.`;
    this.showPixel();
  }

  showPixel() {
    const { room, x, y } = this;
    const rows = room.stages.map((stage, i) => this.pixelRow(stage, room.pixel(i, x, y)));
    const exact = room.pixel(room.exact, x, y);
    rows.push(tableRow("exact", this.texel(exact).concat("", "")));
    byId("pixel-table").tBodies[0].replaceChildren(...rows);
    byId("pixel-says").textContent = exact.texture === TEXTURE_NONE
      ? `Pixel ${x}, ${y}: nothing is there.`
      : `Pixel ${x}, ${y}: the right texel is ${exact.u}, ${exact.v}.`;
  }

  texel(pixel) {
    return pixel.texture === TEXTURE_NONE ? ["\u2013", "\u2013"]
      : [String(pixel.u), String(pixel.v)];
  }

  pixelRow(stage, pixel) {
    const off = pixel.error === OTHER_SURFACE ? "other surface" : String(pixel.error);
    return tableRow(`${stage.digit}`, this.texel(pixel).concat(
      [[off, pixel.error ? "wrong" : ""], `${stage.wrong_texel_pct.toFixed(1)} %`]));
  }

  showLegend() {
    const colours = DISTANCE_COLOURS.concat([OTHER_COLOUR]);
    const names = DISTANCE_NAMES.concat(["another surface"]);
    const items = colours.map((colour, i) => element("li", {},
      element("span", { style: `background: rgb(${colour})` }), names[i]));
    byId("legend").append(element("li", {}, "Texels off:"), ...items,
      element("li", {}, "(dimmed: right, or the same)"));
  }
}
