/* Stage 5's assembly, step by step: recordings of the real routine, four lanes side by side. */

const LANES = 4;
/* The function of stage 4 that a macro of span.S does for four segments. */
const STAGE4_OF = { texel_at: "texel_at", line_setup: "line_setup", fetch: "draw_segment" };

class Lanes extends Part {
  constructor(recordings) {
    super("assembly", { at: whole(undefined, 0, 1e6),
      recording: oneOf(0, recordings.map(({ name }, i) => [i, name])) });
    this.recordings = recordings;
    this.stage4 = byId("source-4").textContent.split("\n");
    this.source = byId("source-5").textContent.split("\n");
    numberLines(byId("lanes-source"), this.source);
    let macro = ""; /* that a line is in */
    this.macros = this.source.map((text) => {
      const [, begins, ends] = /^ *\.(?:macro +(\w+)|(endm))/.exec(text) || [];
      const now = macro;
      macro = begins || (ends ? "" : macro);
      return now;
    });
    this.set({ recording: 0 });
  }

  /* Another recording begins where a lane changes first, but where a step is named. */
  set({ recording = this.state.recording, at }) {
    this.steps = this.recordings[recording].steps;
    const first = this.steps.findIndex((step) => step[2]);
    super.set({ recording, at: clamp(at ?? first, 0, this.steps.length - 1) });
  }

  go(at) {
    this.set({ at });
  }

  macro(i) {
    return this.macros[this.steps[i][0] - 1];
  }

  /* A macro's call counts as one line. */
  line() {
    let i = this.state.at + 1;
    while (i < this.steps.length - 1 && this.macro(i) && this.macro(i) === this.macro(i - 1) &&
           this.steps[i][0] > this.steps[i - 1][0]) {
      i++;
    }
    this.go(i);
  }

  /* To where all lanes have stored their next pixel. */
  pixel() {
    const i = this.steps.findIndex((step, k) => k > this.state.at && step[4] === LANES - 1);
    this.go(i < 0 ? this.steps.length - 1 : i);
  }

  /* What the registers hold after the step, and which texel each lane has stored where. */
  held() {
    const registers = new Map(), stored = Array.from({ length: LANES }, () => []);
    const done = this.steps.slice(0, this.state.at + 1);
    for (const [line, register, meaning, all, lane, pixel] of done) { /* cvtpd2ps makes two */
      const lanes = /cvtpd2ps/.test(this.source[line - 1]) ? all.slice(0, 2) : all;
      if (lane !== undefined) {
        stored[lane][pixel] = lanes[0];
      } else if (meaning || registers.has(register)) {
        registers.set(register, { meaning, lanes: meaning || register[0] === "x" ? lanes : [] });
      }
    }
    return { registers, stored };
  }

  showState() {
    byId("lanes-slider").max = this.steps.length - 1;
    super.showState();
  }

  draw() {
    const { registers, stored } = this.held(), step = this.steps[this.state.at];
    byId("lanes-count").textContent = `Instruction ${this.state.at + 1} of ${this.steps.length}` +
      (step[2] ? `: ${step[1]}, ${step[2]}` : "");
    this.drawPixels(stored, step);
    this.drawRegisters(registers, step);
    this.drawSources();
  }

  /* A row for each lane, with the texel's u in the pixels that are stored. */
  drawPixels(stored, [, , , , lane, pixel]) {
    const { segments } = this.recordings[this.state.recording];
    byId("lanes-pixels").replaceChildren(...segments.map(([x, y, count], own) => element("tr", {},
      element("th", { scope: "row" }, `lane ${own}: ${x}, ${y}`),
      ...Array.from({ length: count }, (_, i) => element("td",
        { class: own === lane && i === pixel ? "stored now" : stored[own][i] ? "stored" : "" },
        (stored[own][i] || "").slice(1).split(" ")[0])))));
  }

  drawRegisters(registers, [, changed]) {
    const rows = [...registers].sort(([a], [b]) => a.localeCompare(b, "en", { numeric: true }))
      .map(([name, { meaning, lanes }]) => element("tr",
        name === changed ? { class: "changed" } : {},
        element("th", { scope: "row" }, name), element("td", {}, meaning),
        ...Array.from({ length: LANES }, (_, i) => element("td", {},
          /^lane/.test(meaning) ? (meaning[5] === String(i) ? lanes[0] : "")
            : lanes[/2 and 3/.test(meaning) ? i - 2 : i] ?? ""))));
    byId("lanes-registers").replaceChildren(
      heads("register", "holds", "lane 0", "lane 1", "lane 2", "lane 3"),
      element("tbody", {}, ...rows));
  }

  drawSources() {
    markLines(byId("lanes-source"), [this.steps[this.state.at][0] - 1]);
    const name = STAGE4_OF[this.macro(this.state.at)] || "draw_span";
    const from = this.stage4.findIndex((text) => new RegExp(`^static .*\\b${name}\\(`).test(text));
    const to = this.stage4.findIndex((text, i) => i > from && text === "}");
    byId("lanes-stage4").textContent = this.stage4.slice(from, to + 1).join("\n");
  }
}
