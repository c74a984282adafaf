/* What stands around the stepper's figure: why, values, sources, all stages, costs, chords. */

const LINES_SHOWN = 16; /* of source */
const CHORDS_HEIGHT = 300;

class Panels {
  constructor(choose) {
    this.choose = choose;
    this.thumbs = new Map();
    for (const stage of STAGES.filter((one) => one.number !== 6)) {
      const canvas = element("canvas", { "aria-hidden": "true" }), says = element("span");
      const name = stage.number === EXACT ? "Exact" : `Stage ${stage.number}: ${stage.name}`;
      const thumb = element(STEPPED.includes(stage.number) ? "button" : "div",
        { class: "thumb", ...(STEPPED.includes(stage.number) ? { type: "button" } : {}) },
        element("b", {}, name), canvas, says);
      if (STEPPED.includes(stage.number)) {
        thumb.addEventListener("click", () => choose(stage.number));
      }
      byId("thumbs").append(thumb);
      this.thumbs.set(stage.number, { thumb, canvas, says });
    }
    this.sources = STEPPED.map((n) => byId(`source-${n}`).textContent.split("\n"));
  }

  draw(stepper, event) {
    this.drawThumbs(stepper); /* canvases before texts: reading a size after that is slow */
    new Chords(stepper, event).draw(event);
    this.drawWhy(stepper, event);
    clearTimeout(this.waiting); /* every stage is traced for it: not while a vertex is dragged */
    this.waiting = setTimeout(() => this.drawCosts(stepper), 80);
  }

  drawWhy({ run, state, stages, earlier }, event) {
    const why = event ? explain(run, state.at, exactOf(stages, event))
      : { title: "Nothing to draw", formulas: [],
        text: "The triangle has no area, once its vertices are rounded." };
    byId("why-title").textContent = why.title;
    byId("why-text").textContent = why.text;
    byId("why-formulas").replaceChildren(...why.formulas.map((text) =>
      element("p", { class: "formula" }, text)));
    drawValues(byId("why-values"), event, event && run.at(event.before));
    this.drawSource(byId("source-now"), state.stage, event);
    const same = event && earlier && sameStep(run, event, earlier);
    byId("source-before").hidden = !earlier;
    if (earlier) {
      this.drawSource(byId("source-before"), state.stage - 1, earlier.at(same));
      byId("source-before").querySelector(".formulas").replaceChildren(...(same === undefined
        ? [element("p", {}, "Stage " + (state.stage - 1) + " has no such step.")]
        : explain(earlier, same, exactOf(stages, earlier.at(same))).formulas.map((text) =>
          element("p", { class: "formula" }, text))));
    }
  }

  /* The stage's file, the line that was run in sight and marked. */
  drawSource(place, stage, event) {
    const lines = this.sources[stage - 1], pre = place.querySelector("pre");
    if (pre.dataset.stage !== String(stage)) {
      pre.dataset.stage = stage;
      pre.replaceChildren(...lines.map((text, i) => element("span",
        { class: `source${/^ *TRACE_/.test(text) ? " trace" : ""}` },
        `${String(i + 1).padStart(3)}   ${text}\n`)));
    }
    if (pre.dataset.shown === `${stage} ${event && event.line}`) {
      return;
    }
    pre.dataset.shown = `${stage} ${event && event.line}`;
    pre.querySelectorAll(".run").forEach((node) => node.classList.remove("run"));
    const block = event ? statementsOf(lines, event) : [];
    block.forEach((i) => pre.children[i].classList.add("run"));
    if (block.length) {
      const first = pre.children[block[0]], height = first.offsetHeight;
      pre.scrollTop = first.offsetTop - Math.max(LINES_SHOWN - block.length, 1) / 2 * height;
    }
    place.querySelector("figcaption").textContent = `${stageOf(stage).folder}/rasterize.c` +
      (event ? `: the line that reports this step is ${event.line}` : "");
  }

  drawThumbs({ results, state, list, measured }) {
    for (const [n, { canvas }] of this.thumbs) {
      const result = results.get(standIn(n));
      const window = fit([state.v], state.size);
      const cell = Math.min((canvas.clientWidth || 180) / window.w, 160 / window.h);
      const [c] = context(canvas, Math.ceil(cell * window.h));
      drawSmall(c, result, window, cell, state.size[0]);
    }
    for (const [n, { thumb, says }] of this.thumbs) {
      if (STEPPED.includes(n)) {
        thumb.setAttribute("aria-pressed", String(n === state.stage));
      }
      says.textContent = n === EXACT ? "what every stage is held against"
        : n === 5 ? "stage 4's frame, bit for bit"
          : measured && list.length ? verdict(results.get(n)) : "";
    }
  }

  drawCosts(stepper) {
    const table = byId("costs"), { state, run } = stepper;
    const head = heads("", "divides", "float to int", "multiplications", "additions");
    const row = (name, counts, now) => element("tr", now ? { class: "now" } : {},
      element("th", { scope: "row" }, name), ...counts.map((n) => element("td", {}, String(n))));
    const rows = STEPPED.map((n) => row(`Stage ${n}, in all`,
      costs(n === state.stage ? run : stepper.trace(n), Infinity), n === state.stage));
    table.replaceChildren(head, element("tbody", {},
      row(`Stage ${state.stage}, so far`, costs(run, state.at), true), ...rows));
  }
}

/* The lines that computed what the trace call in an event's line reports: those above it, to the
 * last blank line, comment or brace; of a pixel the store and the step below it, too. */
function statementsOf(lines, event) {
  let first = event.line - 1, end = event.line;
  while (first > 0 && /[^\s{}/]\s*(\/\*.*\*\/)?$/.test(lines[first - 1])) {
    first -= 1;
  }
  while (KINDS[event.kind] === "pixel" && !/^\s*}/.test(lines[end])) {
    end += 1;
  }
  return Array.from({ length: end - first }, (_, i) => first + i);
}

function exactOf(stages, event) {
  return event.x === undefined ? null : stages.exactAt(event.piece, event.x, event.y);
}

/* The number of the step in the stage before that does the same; undefined where none does. */
function sameStep(run, event, earlier) {
  const name = KINDS[event.kind];
  if (name === "pixel" || name === "segment") {
    return earlier.order.get(event.pixel);
  }
  const same = (other) => other.kind === event.kind && other.side === event.side &&
    (other.y === event.y || name === "gradients");
  const found = earlier.events.findIndex(same);
  return found < 0 ? undefined : found;
}

/* What the step left in the stage's variables, and what was there before; the changed marked. */
function drawValues(table, event, before) {
  const all = Object.entries(event ? event.v : {}).filter(([name]) => !/^y$|short/.test(name));
  const rows = all.map(([name, value]) => {
    const was = before ? before.v[name] : undefined, changed = before && was !== value;
    return element("tr", changed ? { class: "changed" } : {},
      element("th", { scope: "row" }, (changed ? "\u25cf " : "") + name),
      element("td", {}, before ? show(was) : ""), element("td", {}, show(value)));
  });
  table.replaceChildren(heads("variable", "before", "now"), element("tbody", {}, ...rows));
}

const heads = (...names) => element("thead", {}, element("tr", {},
  ...names.map((name) => element("th", { scope: "col" }, name))));

const drawSmall = (c, result, window, cell, width) =>
  drawFrame(c, result, window, cell, width, 0, () => 255);

/* Errors by lightness, so that everyone can order them. */
const ERROR_CLASSES = [["error-1", "1 texel"], ["error-2", "2 or 3 texels"],
  ["error-4", "4 texels or more"], ["error-other", "missing, or too many"]];
function errorClass(error) {
  return error === OTHER_SURFACE ? "error-other" : error >= 4 ? "error-4"
    : error >= 2 ? "error-2" : "error-1";
}

/* One scanline: the curve u(x), what the stage has for it, and the difference, enlarged. */
class Chords {
  constructor(stepper, event) {
    const { run } = stepper;
    this.run = run;
    this.span = event && event.span !== undefined ? run.at(event.span) : run.events
      .find((one) => one.end > one.first);
    if (this.span) {
      const v = this.span.v, at = (p, key) => v[key] + p * v[`${key}_dx`];
      this.first = this.span.first;
      this.count = this.span.end - this.span.first;
      this.curve = (p) => at(p, "u_over_z") / at(p, "one_over_z");
      const from = run.events.indexOf(this.span), row = run.events.slice(from + 1);
      const end = row.findIndex((one) => !["pixel", "segment"].includes(KINDS[one.kind]));
      row.length = end < 0 ? row.length : end;
      this.pixels = row.filter((one) => KINDS[one.kind] === "pixel");
      this.segments = row.filter((one) => KINDS[one.kind] === "segment");
    }
  }

  /* What the stage's u is along the span: [p, u] points. */
  chord() {
    return this.segments.length
      ? this.segments.flatMap(({ x, v }) => [[x - this.first, v.u],
        [x - this.first + v.length, v.u_end]])
      : this.pixels.map(({ x, v }) => [x - this.first, v.u]);
  }

  draw(event) {
    const [c, width] = context(byId("chords"), CHORDS_HEIGHT);
    const says = byId("chords-text");
    if (!this.curve || this.count < 1) {
      says.textContent = "Step to a scanline with pixels on it.";
      return;
    }
    const chord = this.chord();
    const off = (p) => between(chord, p) - this.curve(p);
    const step = this.count > 600 ? Math.ceil(this.count / 600) /* more than can be seen */
      : this.segments.length ? 1 / 4 : 1;                       /* nothing is between two pixels */
    const fine = Array.from({ length: Math.floor((this.count - 1) / step) + 1 },
      (_, i) => i * step);
    const worst = Math.max(...fine.map((p) => Math.abs(off(p))));
    const bound = Math.max(0, ...this.segments.map((one) => chordOf(this.run, one).bound));
    says.textContent = `Scanline ${this.span.y}, ${plural(this.count, "pixel")}. Above: u, the ` +
      "curve, and what the stage has for it. Below: the difference" + (this.segments.length
      ? `, at most ${show(worst, 3)} texel; the bound |du| (\u221ar \u2212 1)/(\u221ar + 1) is ` +
        `${show(bound, 3)} for the steepest segment.`
      : ": this stage divides at every pixel, so nothing but rounding is left.");
    const values = fine.map(this.curve);
    const upper = plot(c, [44, 12, width - 54, 150], [0, Math.max(this.count - 1, 1)],
      [Math.min(...values), Math.max(...values)], "u");
    if (event && event.x !== undefined) {
      const [now] = upper.at([event.x - this.first, 0]);
      line(c, now, 12, now, 276, colour("now"), 2);
    }
    upper.path(fine.map((p) => [p, this.curve(p)]), "accent", 2.5, []);
    if (this.segments.length) {
      upper.path(chord, "warn", 2, [7, 4]);
    }
    chord.forEach((point) => upper.dot(point, "warn"));
    const high = Math.max(worst, bound, 0.01);
    const lower = plot(c, [44, 196, width - 54, 80], [0, Math.max(this.count - 1, 1)],
      [-high, high], "error");
    if (this.segments.length) {
      lower.path(fine.map((p) => [p, off(p)]), "wrong", 2, []);
    } else {
      fine.forEach((p) => lower.dot([p, off(p)], "wrong"));
    }
    for (const segment of this.segments) {
      const own = chordOf(this.run, segment).bound, p = segment.x - this.first, v = segment.v;
      for (const sign of [-1, 1]) {
        lower.path([[p, sign * own], [p + v.length, sign * own]], "ink", 1.2, [2, 4]);
      }
    }
    c.fillStyle = colour("soft");
    c.textAlign = "left";
    c.fillText(`x = ${this.first}`, 44, 290);
    c.textAlign = "right";
    c.fillText(`${this.first + this.count - 1}`, width - 10, 290);
  }
}

/* The line through points, at p. */
function between(points, p) {
  const i = Math.max(points.findIndex(([x]) => x >= p), 0);
  if (i === 0 || points[i][0] === p) {
    return points[i][1];
  }
  const [x0, y0] = points[i - 1], [x1, y1] = points[i];
  return y0 + (y1 - y0) * (p - x0) / (x1 - x0);
}

/* A frame with a vertical scale, and how to draw into it. */
function plot(c, [left, top, width, height], [x0, x1], [y0, y1], name) {
  const at = ([x, y]) => [left + width * (x - x0) / (x1 - x0),
    top + height * (1 - (y - y0) / (y1 - y0 || 1))];
  c.strokeStyle = colour("line");
  c.strokeRect(left, top, width, height);
  c.fillStyle = colour("soft");
  c.textAlign = "right";
  c.textBaseline = "middle";
  c.fillText(show(y1, 3), left - 4, top + 6);
  c.fillText(show(y0, 3), left - 4, top + height - 6);
  c.fillText(name, left - 4, top + height / 2);
  if (y0 < 0 && y1 > 0) {
    line(c, left, at([x0, 0])[1], left + width, at([x0, 0])[1], colour("line"));
  }
  return {
    at,
    path(points, stroke, size, dash) {
      c.beginPath();
      points.forEach((point) => c.lineTo(...at(point)));
      c.strokeStyle = colour(stroke);
      c.lineWidth = size;
      c.setLineDash(dash);
      c.stroke();
      c.setLineDash([]);
    },
    dot(point, fill) {
      c.beginPath();
      c.arc(...at(point), 3, 0, 7);
      c.fillStyle = colour(fill);
      c.fill();
    },
  };
}
