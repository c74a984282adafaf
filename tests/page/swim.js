/* Stages 2 and 3 while a triangle moves by 1/64 pixel a frame. */

const FRAMES_PER_SECOND = 16;
const CHECKS = 16; /* texels a square of the checker */
const CHECK_COLOURS = [[232, 226, 208], [44, 88, 136]];
const PLOT = { width: 760, left: 66, right: 748, height: 116 }; /* of one stage */

class Swim {
  static async load() {
    const data = dataOf("swim");
    return new Swim(data, await unpack(data.texels));
  }

  constructor(data, texels) {
    Object.assign(this, data, { data, texels, frame: 0, timer: null });
    this.canvases = data.stages.map((stage) => {
      const name = `Stage ${stage.name[5]}`;
      const canvas = element("canvas", { width: this.side, height: this.side, role: "img",
        "aria-label": `${name}: a checkered triangle that moves` });
      const says = `${name}: jitter ${show(stage.jitter_rms, 3)} texel (RMS over 128 frames)`;
      byId("swim-views").append(element("figure", {}, canvas, element("figcaption", {}, says)));
      return canvas;
    });
    this.jitterMax = Math.max(...data.stages.flatMap((stage) => stage.jitter));
    this.bars = data.stages.map((stage, i) => this.plot(stage, i));
    const height = PLOT.height * data.stages.length + 20;
    byId("swim-plot").append(svg("svg", { viewBox: `0 0 ${PLOT.width} ${height}`, role: "img" },
      svg("title", {}, "How far the texture jumped from frame to frame: in stage 2 a few large "
        + "jumps, in stage 3 many small ones"), ...this.bars.map((bars) => bars.group),
      text(PLOT.right, height - 5, "frame", "end", "soft")));
    byId("swim-slider").max = this.frames - 1;
    byId("swim-slider").addEventListener("input", (event) => {
      this.pause();
      this.go(Number(event.target.value));
    });
    byId("swim-play").addEventListener("click", () => (this.timer ? this.pause() : this.play()));
    this.go(0);
  }

  plot(stage, index) {
    const top = index * PLOT.height, bottom = top + PLOT.height - 8;
    const width = (PLOT.right - PLOT.left) / this.frames;
    const bars = stage.jitter.map((jitter, frame) => {
      const height = (jitter ?? 0) / this.jitterMax * (PLOT.height - 36);
      return svg("rect", { x: round(PLOT.left + frame * width + 1), width: round(width - 2),
        y: round(bottom - height), height: round(height), class: "bar" });
    });
    const label = `Stage ${stage.name[5]}: texels jumped since the frame before, RMS`;
    const group = svg("g", {}, line(PLOT.left, bottom, PLOT.right, bottom, "grid"),
      text(PLOT.left, top + 18, label),
      text(PLOT.left - 6, bottom - PLOT.height + 40, show(this.jitterMax, 2), "end", "soft"),
      text(PLOT.left - 6, bottom + 4, "0", "end", "soft"), ...bars);
    return { group, bars };
  }

  /* The texel in the window's pixel, or null where the triangle is not. */
  texel(stage, frame, pixel) {
    const size = this.side * this.side;
    const [u, v] = [0, 1].map((axis) =>
      this.texels[((stage * 2 + axis) * this.frames + frame) * size + pixel]);
    return u === this.no_texel && v === this.no_texel ? null : [u, v];
  }

  draw(stage) {
    const context = this.canvases[stage].getContext("2d");
    const image = context.createImageData(this.side, this.side);
    for (let pixel = 0; pixel < this.side * this.side; pixel++) {
      const texel = this.texel(stage, this.frame, pixel);
      if (texel) {
        const parity = (Math.floor(texel[0] / CHECKS) + Math.floor(texel[1] / CHECKS)) & 1;
        image.data.set([...CHECK_COLOURS[parity], 255], 4 * pixel);
      }
    }
    context.putImageData(image, 0, 0);
  }

  go(frame) {
    this.frame = frame;
    byId("swim-slider").value = frame;
    byId("swim-slider").setAttribute("aria-valuetext", `frame ${frame} of ${this.frames}`);
    byId("swim-says").textContent = `${frame}/64 pixel`;
    this.data.stages.forEach((_, stage) => {
      this.draw(stage);
      this.bars[stage].bars.forEach((bar, i) => bar.classList.toggle("now", i === frame));
    });
  }

  play() {
    this.timer = setInterval(() => this.go((this.frame + 1) % this.frames),
      1000 / FRAMES_PER_SECOND);
    byId("swim-play").textContent = "Pause";
  }

  pause() {
    clearInterval(this.timer);
    this.timer = null;
    byId("swim-play").textContent = "Play";
  }
}
