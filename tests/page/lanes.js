/* Stage 5's assembly, step by step: recordings of the real routine, four lanes side by side. */

const LANES = 4, LANE_NUMBERS = "0123";
/* The function of stage 4 that a macro of span.S does for four segments. */
const STAGE4_OF = { texel_at: "texel_at", line_setup: "line_setup", fetch: "draw_segment" };

/* The lanes that a register belongs to, by what it holds: "end 2 and 3", "lane 0 goes to". */
const ownersOf = (meaning) =>
  (/^lane \d|\d and \d$/.exec(meaning) || [LANE_NUMBERS])[0].replace(/\D/g, "");

class Lanes extends Part {
  constructor(recordings) {
    super("assembly", { at: whole(undefined, 0, 1e6),
      recording: oneOf(0, recordings.map(({ name }, i) => [i, name])) });
    this.recordings = recordings;
    numberLines(byId("lanes-source"), sourceOf(5));
    this.set({ recording: 0 });
  }

  /* Another recording begins where a lane changes first, but where a step is named. */
  set({ recording = this.state.recording, at }) {
    this.steps = this.recordings[recording].steps;
    const first = this.steps.findIndex(({ meaning }) => meaning);
    super.set({ recording, at: clamp(at ?? first, 0, this.steps.length - 1) });
  }

  go(at) {
    this.set({ at });
  }

  /* A macro's call counts as one line. */
  line() {
    const goesOn = ({ macro, line }, last) => macro && macro === last.macro && line > last.line;
    let i = this.state.at + 1;
    while (i < this.steps.length - 1 && goesOn(this.steps[i], this.steps[i - 1])) {
      i++;
    }
    this.go(i);
  }

  /* To where all lanes have stored their next pixel. */
  pixel() {
    const i = this.steps.findIndex(({ lane }, k) => k > this.state.at && lane === LANES - 1);
    this.go(i < 0 ? this.steps.length - 1 : i);
  }

  /* What the registers hold after the step, and which texel each lane has stored where. */
  held() {
    const registers = new Map(), stored = Array.from({ length: LANES }, () => []);
    const done = this.steps.slice(0, this.state.at + 1);
    for (const { register, meaning, lanes, lane, pixel } of done) {
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
      (step.meaning ? `: ${step.register}, ${step.meaning}` : "");
    this.drawPixels(stored, step);
    this.drawRegisters(registers, step);
    this.drawSources(step);
  }

  /* A row for each lane, with the texel's u in the pixels that are stored. */
  drawPixels(stored, { lane, pixel }) {
    const { segments } = this.recordings[this.state.recording];
    byId("lanes-pixels").replaceChildren(...segments.map(([x, y, count], own) => element("tr", {},
      element("th", { scope: "row" }, `lane ${own}: from ${x}, ${y}`),
      ...Array.from({ length: count }, (_, i) => element("td",
        { class: own === lane && i === pixel ? "stored now" : stored[own][i] ? "stored" : "" },
        (stored[own][i] || "").slice(1).split(" ")[0])))));
  }

  drawRegisters(registers, { register: changed }) {
    const rows = [...registers].sort(([a], [b]) => a.localeCompare(b, "en", { numeric: true }))
      .map(([name, { meaning, lanes }]) => element("tr",
        name === changed ? { class: "changed" } : {},
        element("th", { scope: "row" }, name), element("td", {}, meaning),
        ...Array.from(LANE_NUMBERS, (i) => element("td", {},
          lanes[ownersOf(meaning).indexOf(i)] ?? ""))));
    byId("lanes-registers").replaceChildren(
      heads("register", "holds", "lane 0", "lane 1", "lane 2", "lane 3"),
      element("tbody", {}, ...rows));
  }

  drawSources({ line, macro }) {
    markLines(byId("lanes-source"), [line - 1]);
    const begins = new RegExp(`^static .*\\b${STAGE4_OF[macro] || "draw_span"}\\(`);
    const stage4 = sourceOf(4), from = stage4.findIndex((text) => begins.test(text));
    byId("lanes-stage4").textContent =
      stage4.slice(from, stage4.indexOf("}", from) + 1).join("\n");
  }
}
