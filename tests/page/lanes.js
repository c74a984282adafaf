/* Stage 5's assembly, step by step: recordings of the real routine, four lanes side by side. */

const LANES = 4, LANE_PIXELS = 16, LANE_HEIGHT = 26;
/* The function of stage 4 that a macro of span.S does for four segments. */
const STAGE4_OF = { interpolants: "draw_span", texel_at: "texel_at", line_setup: "line_setup",
  fetch: "draw_segment", segments: "draw_span", "": "draw_span" };

class Lanes {
  constructor() {
    this.data = JSON.parse(byId("lanes-data").textContent);
    byId("lanes").hidden = Boolean(this.data.missing);
    if (this.data.missing) {
      byId("lanes-missing").textContent = `There is no recording: ${this.data.missing}.`;
      return;
    }
    this.choice = new Choice("lanes-recording",
      this.data.recordings.map(({ name }, i) => [i, name]), (i) => this.open(i, 0));
    byId("lanes-source").append(...this.data.source.map(([text], i) =>
      element("span", { class: "source" }, `${String(i + 1).padStart(3)}   ${text}\n`)));
    this.stage4 = byId("source-4").textContent.split("\n");
    const go = (id, by) => byId(id).addEventListener("click", () => this.go(by()));
    go("lanes-back", () => this.at - 1);
    go("lanes-on", () => this.at + 1);
    go("lanes-line", () => this.nextLine());
    go("lanes-pixel", () => this.nextPixel());
    byId("lanes-slider").addEventListener("input", (event) => this.go(Number(event.target.value)));
    this.player = new Player("lanes-play", () => this.go(this.at + 1), () => 8);
    addEventListener("resize", () => this.draw());
    Address.part("assembly", () => ({ recording: this.recording, at: this.at }),
      ({ recording, at }) => this.open(Number(recording || 0), Number(at || 0)));
    this.open(0, 0);
  }

  open(recording, at) {
    this.recording = clamp(recording, 0, this.data.recordings.length - 1);
    this.choice.press(this.recording);
    this.steps = this.data.recordings[this.recording].steps;
    byId("lanes-slider").max = this.steps.length - 1;
    this.at = clamp(at, 0, this.steps.length - 1);
    this.draw();
  }

  /* False at the end, where playing stops. */
  go(at) {
    this.at = clamp(at, 0, this.steps.length - 1);
    Address.write("assembly");
    this.draw();
    return this.at < this.steps.length - 1;
  }

  macro(i) {
    return this.data.source[this.steps[i][0] - 1][1];
  }

  /* A macro's call counts as one line. */
  nextLine() {
    let i = this.at + 1;
    while (i < this.steps.length - 1 && this.macro(i) && this.macro(i) === this.macro(i - 1) &&
           this.steps[i][0] > this.steps[i - 1][0]) {
      i++;
    }
    return i;
  }

  /* To where all lanes have stored their next pixel. */
  nextPixel() {
    const i = this.steps.findIndex((step, k) => k > this.at && step[4] === LANES - 1);
    return i < 0 ? this.steps.length - 1 : i;
  }

  /* What the registers hold after the step, and which texel each lane has stored where. */
  state() {
    const registers = new Map(), stored = Array.from({ length: LANES }, () => []);
    for (const [, register, meaning, lanes, lane, pixel] of this.steps.slice(0, this.at + 1)) {
      if (lane !== undefined) {
        stored[lane][pixel] = lanes[0];
      } else if (register && meaning) {
        registers.set(register, { meaning, lanes });
      }
    }
    return { registers, stored };
  }

  draw() {
    const { registers, stored } = this.state(), step = this.steps[this.at];
    byId("lanes-slider").value = this.at;
    byId("lanes-count").textContent = `Instruction ${this.at + 1} of ${this.steps.length}` +
      (step[2] ? `: ${step[1]}, ${step[2]}` : "");
    this.drawPixels(stored, step);
    this.drawRegisters(registers, step);
    this.drawSources();
  }

  drawPixels(stored, step) {
    const { segments } = this.data.recordings[this.recording];
    const [c, width] = context(byId("lanes-pixels"), LANES * LANE_HEIGHT);
    const label = 118, cell = (width - label) / LANE_PIXELS;
    c.textBaseline = "middle";
    segments.forEach(([x, y, count], lane) => {
      const top = lane * LANE_HEIGHT;
      c.fillStyle = colour("ink");
      c.fillText(`lane ${lane}: ${x}, ${y}`, 0, top + LANE_HEIGHT / 2);
      for (let i = 0; i < LANE_PIXELS; i++) {
        const texel = stored[lane][i], now = step[4] === lane && step[5] === i;
        c.fillStyle = colour(texel === undefined || i >= count ? "raised"
          : i % 2 ? "texel-b" : "texel-a");
        c.fillRect(label + i * cell, top + 2, cell - 1, LANE_HEIGHT - 4);
        if (i < count) {
          c.strokeStyle = colour(now ? "now" : "soft");
          c.lineWidth = now ? 3 : 1;
          c.strokeRect(label + i * cell, top + 2, cell - 1, LANE_HEIGHT - 4);
        }
        if (texel !== undefined && i < count && cell > 26) {
          c.fillStyle = colour("ink");
          c.fillText(texel.replace(/[()]/g, "").split(" ")[0], label + i * cell + 3,
            top + LANE_HEIGHT / 2);
        }
      }
    });
  }

  drawRegisters(registers, [, changed]) {
    const rows = [...registers].sort(([a], [b]) => a.localeCompare(b, "en", { numeric: true }))
      .map(([name, { meaning, lanes }]) => element("tr", name === changed ? { class: "changed" } : {},
        element("th", { scope: "row" }, name), element("td", {}, meaning),
        ...Array.from({ length: LANES }, (_, i) => element("td", {},
          /^lane/.test(meaning) ? (meaning[5] === String(i) ? lanes[0] : "") : lanes[i] ?? ""))));
    byId("lanes-registers").replaceChildren(
      element("thead", {}, element("tr", {}, ...["register", "holds", "lane 0", "lane 1", "lane 2",
        "lane 3"].map((text) => element("th", { scope: "col" }, text)))),
      element("tbody", {}, ...rows));
  }

  drawSources() {
    const pre = byId("lanes-source"), line = this.steps[this.at][0];
    pre.querySelectorAll(".run").forEach((node) => node.classList.remove("run"));
    const node = pre.children[line - 1];
    node.classList.add("run");
    pre.scrollTop = node.offsetTop - pre.clientHeight / 2;
    const name = STAGE4_OF[this.macro(this.at)] || "draw_span";
    const from = this.stage4.findIndex((text) => new RegExp(`^static .*\\b${name}\\(`).test(text));
    const to = this.stage4.findIndex((text, i) => i > from && text === "}");
    byId("lanes-stage4").textContent = this.stage4.slice(from, to + 1).join("\n");
  }
}
