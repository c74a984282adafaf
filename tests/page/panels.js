/* What stands around the stepper's figure: why, values, sources, all stages, costs, chords. */

class Panels {
  constructor(choose) {
    this.thumbs = STAGES.filter(({ number }) => number !== 6).map(({ number: n, name }) => {
      const canvas = element("canvas", { "aria-hidden": "true" }), says = element("span");
      const thumb = element(...(STEPPED.includes(n) ? ["button", { class: "thumb", type: "button" }]
        : ["div", { class: "thumb" }]),
      element("b", {}, n === EXACT ? "Exact" : `Stage ${n}: ${name}`), canvas, says);
      thumb.addEventListener("click", () => STEPPED.includes(n) && choose(n));
      byId("thumbs").append(thumb);
      return { n, thumb, canvas, says };
    });
    document.querySelectorAll(".errors").forEach((list) =>
      list.append(...ERROR_CLASSES.map(([name, text]) => element("li", {},
        element("i", { class: "key", style: `background: var(--${name})` }), text))));
  }

  draw(stepper, event) {
    this.drawThumbs(stepper); /* canvases before texts: reading a size after that is slow */
    drawChords(stepper.run, event);
    this.drawWhy(stepper, event);
    clearTimeout(this.waiting); /* every stage is traced for it: not while a vertex is dragged */
    this.waiting = setTimeout(() => this.drawCosts(stepper), 80);
  }

  drawWhy(stepper, event) {
    const { run, state, earlier } = stepper;
    const lines = ({ formulas }) =>
      formulas.map((text) => element("p", { class: "formula" }, text));
    const why = event ? explain(run, state.at, exactOf(stepper, event))
      : { title: "Nothing to draw", formulas: [],
        text: "The triangle has no area, once its vertices are rounded." };
    byId("why-title").textContent = why.title;
    byId("why-text").textContent = why.text;
    byId("why-formulas").replaceChildren(...lines(why));
    drawValues(byId("why-values"), event, event && run.at(event.before));
    this.drawSource(byId("source-now"), state.stage, event);
    byId("source-before").hidden = !earlier;
    if (earlier) {
      const same = event && sameStep(event, earlier), there = earlier.at(same);
      this.drawSource(byId("source-before"), state.stage - 1, there);
      byId("source-before").querySelector(".formulas").replaceChildren(...(there
        ? lines(explain(earlier, same, exactOf(stepper, there)))
        : [element("p", {}, `Stage ${state.stage - 1} has no such step.`)]));
    }
  }

  /* The stage's file, the lines that were run in sight and marked. */
  drawSource(place, stage, event) {
    const lines = sourceOf(stage), pre = place.querySelector("pre");
    if (pre.dataset.stage !== String(stage)) {
      pre.dataset.stage = stage;
      numberLines(pre, lines);
    }
    markLines(pre, event ? statementsOf(lines, event) : []);
    place.querySelector("figcaption").textContent = `${stageOf(stage).folder}/rasterize.c` +
      (event ? `: the line that reports this step is ${event.line}` : "");
  }

  drawThumbs({ results, state, list }) {
    for (const { n, thumb, canvas, says } of this.thumbs) {
      const result = results.get(standIn(n));
      drawSmall(canvas, result, [state.v], state.size, 160);
      if (STEPPED.includes(n)) {
        thumb.setAttribute("aria-pressed", String(n === state.stage));
      }
      says.textContent = n === EXACT ? "what every stage is compared with"
        : n === 5 ? "stage 4's frame, bit for bit"
          : !result.errors || !list.length ? "" : verdict(result) +
            (n < 3 && result.largest === 1 ? ": truncated, off by one" : "");
    }
  }

  drawCosts(stepper) {
    const { state: { stage, at }, run, stages } = stepper;
    const row = (name, counts, now) => element("tr", now ? { class: "now" } : {},
      element("th", { scope: "row" }, name), ...counts.map((n) => element("td", {}, String(n))));
    byId("costs").replaceChildren(
      heads("", "divides", "float to int", "multiplications", "additions"),
      element("tbody", {}, row(`Stage ${stage}, so far`, stages.costs(run, at), true),
        ...STEPPED.map((n) => row(`Stage ${n}, in all`,
          stages.costs(n === stage ? run : stepper.trace(n), Infinity), n === stage))));
  }
}

/* A stage's source, as the page has it: its lines; with their numbers, each an element; and some of
 * them marked and in sight. */
const sourceOf = (stage) => byId(`source-${stage}`).textContent.split("\n");

function numberLines(pre, lines) {
  delete pre.dataset.marked;
  pre.replaceChildren(...lines.map((text, i) => element("span",
    { class: `source${/^ *TRACE_/.test(text) ? " trace" : ""}` },
    `${String(i + 1).padStart(3)}   ${text}\n`)));
}

function markLines(pre, marked) {
  if (pre.dataset.marked === String(marked)) {
    return;
  }
  pre.dataset.marked = marked;
  pre.querySelectorAll(".run").forEach((node) => node.classList.remove("run"));
  marked.forEach((i) => pre.children[i].classList.add("run"));
  if (marked.length) {
    const { offsetTop, offsetHeight } = pre.children[marked[0]];
    pre.scrollTop = offsetTop - (pre.clientHeight - marked.length * offsetHeight) / 2;
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

/* The exact answer at a step's pixel; null where that is not covered, or was not measured. */
function exactOf({ stages, results }, event) {
  const drawn = event.x !== undefined && results.get(1).errors &&
    results.get(EXACT).frame[event.pixel];
  return drawn ? stages.exactAt(event.x, event.y) : null;
}

/* The number of the step in the stage before that does the same; undefined where none does. */
function sameStep(event, earlier) {
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
    const was = before ? before.v[name] : undefined, changed = before && show(was) !== show(value);
    return element("tr", changed ? { class: "changed" } : {},
      element("th", { scope: "row" }, (changed ? "\u25cf " : "") + name),
      element("td", {}, before ? show(was) : ""), element("td", {}, show(value)));
  });
  table.replaceChildren(heads("variable", "before", "now"), element("tbody", {}, ...rows));
}

const heads = (...names) => element("thead", {}, element("tr", {},
  ...names.map((name) => element("th", { scope: "col" }, name))));

/* A frame, or the part of it that fits the triangles, in a small canvas. */
function drawSmall(canvas, result, triangles, size, height) {
  const window = fit(triangles, size);
  const cell = Math.min((canvas.clientWidth || 180) / window.w, height / window.h, 24);
  const [c] = context(canvas, Math.ceil(cell * window.h));
  drawFrame(c, result, window, cell, size[0], 0, () => 255);
}

/* Errors by lightness, so that everyone can order them. */
const ERROR_CLASSES = [["error-1", "1 texel"], ["error-2", "2 or 3 texels"],
  ["error-4", "4 texels or more"], ["error-other", "missing, or too many"]];
function errorClass(error) {
  return error === OTHER_SURFACE ? "error-other" : error >= 4 ? "error-4"
    : error >= 2 ? "error-2" : "error-1";
}

/* One scanline: the curve u(x), what the stage has for it, and the difference, enlarged. */
function drawChords(run, event) {
  const [c, width] = context(byId("chords"), 300), says = byId("chords-text");
  const span = event && run.at(event.span) || run.events.find((one) => one.end > one.first);
  if (!span || span.end <= span.first) {
    says.textContent = "Step to a scanline with pixels on it.";
    return;
  }
  const from = run.events.indexOf(span) + 1, { first } = span, count = span.end - first;
  const inside = run.events.slice(from).findIndex((one) => one.x === undefined);
  const row = run.events.slice(from, inside < 0 ? Infinity : from + inside);
  const segments = row.filter((one) => KINDS[one.kind] === "segment");
  const chord = (segments.length ? segments : row).flatMap(({ x, v }) => (segments.length
    ? [[x - first, v.u], [x - first + v.length, v.u_end]] : [[x - first, v.u]]));
  const curve = (p) => truth(run, row[0], first + p).u, off = (p) => between(chord, p) - curve(p);
  const step = count > 600 ? Math.ceil(count / 600) /* more than can be seen */
    : segments.length ? 1 / 4 : 1;                  /* nothing is between two pixels */
  const fine = Array.from({ length: Math.floor((count - 1) / step) + 1 }, (_, i) => i * step);
  const worst = Math.max(...fine.map((p) => Math.abs(off(p)))), values = fine.map(curve);
  const bounds = segments.map((one) => chordOf(run, one).bound), bound = Math.max(0, ...bounds);
  says.textContent = `Scanline ${span.y}, ${plural(count, "pixel")}. ` + (segments.length
    ? `The difference is at most ${show(worst, 3)} texel; its bound |du| |\u221ar \u2212 1| / ` +
      `(\u221ar + 1) is ${show(bound, 3)} for the steepest segment.`
    : "This stage divides at every pixel, so nothing but rounding is left.");
  const along = [0, Math.max(count - 1, 1)], high = Math.max(worst, bound, 0.01);
  const upper = plot(c, [44, 12, width - 54, 150], along,
    [Math.min(...values), Math.max(...values)], "u");
  const lower = plot(c, [44, 196, width - 54, 80], along, [-high, high], "error");
  if (event && event.x !== undefined) {
    const [now] = upper([event.x - first, 0]);
    path(c, [[now, 12], [now, 276]], "now", 2);
  }
  path(c, fine.map((p) => upper([p, curve(p)])), "accent", 2.5);
  chord.forEach((point) => dot(c, upper(point), 3, "warn"));
  if (segments.length) {
    path(c, chord.map(upper), "warn", 2, [7, 4]);
    path(c, fine.map((p) => lower([p, off(p)])), "wrong", 2);
  } else {
    fine.forEach((p) => dot(c, lower([p, off(p)]), 3, "wrong"));
  }
  segments.forEach(({ x, v }, i) => [-bounds[i], bounds[i]].forEach((y) =>
    path(c, [[x - first, y], [x - first + v.length, y]].map(lower), "ink", 1.2, [2, 4])));
  label(c, `x = ${first}`, 44, 290, "soft", "left");
  label(c, String(span.end - 1), width - 10, 290, "soft", "right");
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

/* A box with a vertical scale; returns where a point lies in it. */
function plot(c, [left, top, width, height], [x0, x1], [y0, y1], name) {
  const at = ([x, y]) => [left + width * (x - x0) / (x1 - x0),
    top + height * (1 - (y - y0) / (y1 - y0 || 1))];
  border(c, left, top, width, height, "line");
  for (const [text, y] of [[show(y1, 3), 6], [name, height / 2], [show(y0, 3), height - 6]]) {
    label(c, text, left - 4, top + y, "soft", "right");
  }
  if (y0 < 0 && y1 > 0) {
    path(c, [at([x0, 0]), at([x1, 0])], "line");
  }
  return at;
}
