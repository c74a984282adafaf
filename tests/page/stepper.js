/* One triangle, step by step, from the traces of stages 1 to 4. */

function isWrong(pixel) {
  return pixel.texel_u !== pixel.exact_texel_u || pixel.texel_v !== pixel.exact_texel_v;
}

/* The steps of a trace, in drawing order: a row's edges; in stage 4 a segment; each pixel. `drawn`
 * counts the pixels that are there after the step. */
function stepsOf(trace) {
  const steps = [];
  let drawn = 0;
  for (const row of trace.rows) {
    steps.push({ kind: "row", row, drawn, pixels: [] });
    for (const pixel of row.pixels) {
      const segment = row.segments.find((s) => s.x === pixel.x);
      if (segment) {
        const pixels = row.pixels.filter((p) => p.x >= segment.x &&
          p.x < segment.x + segment.count);
        steps.push({ kind: "segment", row, segment, drawn, pixels });
      }
      steps.push({ kind: "pixel", row, drawn: ++drawn, pixels: [pixel] });
    }
  }
  return steps;
}

/* What a table shows of each kind of step: [label, field, field of the exact answer]. */
const EDGE_ROWS = [["x", "x"], ["x step", "x_step"], ["error", "error"],
  ["+ numerator", "numerator"], ["of denominator", "denominator"], ["1/z", "one_over_z"],
  ["u/z", "u_over_z"], ["v/z", "v_over_z"]];
const VALUE_ROWS = {
  row: [["1/z", "one_over_z"], ["u/z", "u_over_z"], ["v/z", "v_over_z"],
    ["d(1/z)/dx", "one_over_z_dx"], ["d(u/z)/dx", "u_over_z_dx"], ["d(v/z)/dx", "v_over_z_dx"]],
  segment: [["u at its start", "u"], ["v at its start", "v"], ["u at its end", "u_end"],
    ["v at its end", "v_end"], ["u step, 16.16", "u_step_16_16"],
    ["v step, 16.16", "v_step_16_16"]],
  pixel: [["1/z", "one_over_z"], ["u/z", "u_over_z"], ["v/z", "v_over_z"], ["z", "z", "exact_z"],
    ["u", "u", "exact_u"], ["v", "v", "exact_v"], ["u 16.16 + half", "u_16_16"],
    ["v 16.16 + half", "v_16_16"], ["texel u", "texel_u", "exact_texel_u"],
    ["texel v", "texel_v", "exact_texel_v"]],
};

class Stepper {
  constructor() {
    const { width, height, traces } = dataOf("steps");
    this.views = traces.map((trace) => ({ trace, steps: stepsOf(trace),
      figure: new TriangleFigure(width, height, trace) }));
    this.buttons = this.views.map((view, i) => {
      const button = element("button", {}, `Stage ${i + 1}`);
      button.addEventListener("click", () => this.choose(i));
      return button;
    });
    byId("step-stages").append(...this.buttons);
    this.view = this.views[0];
    this.step = Math.floor(this.view.steps.length * 0.4); /* begins where there is much to see */
    this.listen();
    this.choose(0);
  }

  listen() {
    byId("step-first").addEventListener("click", () => this.go(0));
    byId("step-back").addEventListener("click", () => this.go(this.step - 1));
    byId("step-on").addEventListener("click", () => this.go(this.step + 1));
    byId("step-last").addEventListener("click", () => this.go(this.view.steps.length - 1));
    byId("step-slider").addEventListener("input", (event) => this.go(Number(event.target.value)));
    byId("step-figure").addEventListener("keydown", (event) => this.key(event));
  }

  key(event) {
    const last = this.view.steps.length - 1;
    const targets = { ArrowLeft: this.step - 1, ArrowRight: this.step + 1, Home: 0, End: last,
      ArrowUp: this.rowFrom(-1), ArrowDown: this.rowFrom(1) };
    if (event.key in targets) {
      this.go(targets[event.key]);
      event.preventDefault();
    }
  }

  /* The nearest step before or after this one that begins a row. */
  rowFrom(direction) {
    const { steps } = this.view;
    let step = this.step + direction;
    while (step > 0 && step < steps.length && steps[step].kind !== "row") {
      step += direction;
    }
    return step;
  }

  /* Another stage, at the same pixel if it draws that, else at the same row. */
  choose(index) {
    const now = this.view.steps[this.step];
    this.view = this.views[index];
    this.buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === index)));
    byId("step-figure").replaceChildren(this.view.figure.svg);
    byId("step-slider").max = this.view.steps.length - 1;
    const same = (kind) => this.view.steps.findIndex((step) => step.kind === kind &&
      step.row.y === now.row.y && (kind === "row" || step.pixels[0].x === now.pixels[0].x));
    const step = same(now.kind === "pixel" ? "pixel" : "row");
    this.go(step >= 0 ? step : same("row"));
  }

  go(step) {
    const { steps, figure } = this.view;
    this.step = Math.max(0, Math.min(step, steps.length - 1));
    const now = steps[this.step];
    figure.show(now.drawn, now.row, now.kind === "row" ? [] : now.pixels);
    const slider = byId("step-slider");
    slider.value = this.step;
    slider.setAttribute("aria-valuetext", `step ${this.step + 1} of ${steps.length}`);
    this.showEdges(now.row);
    this.showValues(now);
    byId("step-says").textContent = `Step ${this.step + 1} of ${steps.length}. ${this.words(now)}`;
  }

  showEdges(row) {
    const rows = EDGE_ROWS.filter(([, field]) => row.left[field] !== null)
      .map(([label, field]) => tableRow(label, [show(row.left[field]), show(row.right[field])]));
    byId("step-edges").tBodies[0].replaceChildren(...rows);
  }

  showValues(now) {
    const values = { row: now.row.span, segment: now.segment, pixel: now.pixels[0] }[now.kind];
    const table = byId("step-values");
    const rows = VALUE_ROWS[now.kind].filter(([, field]) => values[field] !== null)
      .map(([label, field, exact]) => {
        const wrong = field.startsWith("texel") && values[field] !== values[exact];
        return tableRow(label, [[show(values[field]), wrong ? "wrong" : ""],
          exact ? show(values[exact]) : ""]);
      });
    table.caption.textContent = { row: "Along this scanline, at its first pixel",
      segment: "The segment", pixel: "The pixel" }[now.kind];
    table.tBodies[0].replaceChildren(...rows);
  }

  words({ kind, row, segment, pixels }) {
    if (kind === "row") {
      const { x, count } = row.span;
      return count > 0 ? `Scanline ${row.y}: pixels ${x} to ${x + count - 1}.`
        : `Scanline ${row.y}: no pixel between its edges.`;
    }
    if (kind === "segment") {
      return `Scanline ${row.y}: a segment of ${segment.count} pixels, with a divide at each end.`;
    }
    const [pixel] = pixels;
    const texel = `Pixel ${pixel.x}, ${row.y} gets texel ${pixel.texel_u}, ${pixel.texel_v}`;
    return pixel.exact_texel_u === null ? `${texel}; the triangle as given does not cover it.`
      : isWrong(pixel) ? `${texel}; right is ${pixel.exact_texel_u}, ${pixel.exact_texel_v}.`
        : `${texel}, the right one.`;
  }
}
