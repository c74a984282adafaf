/* Why: what a step of a stage computes, as a title, a sentence, and formulas with the numbers in
 * them. All results are the stage's own, from its trace; nothing is computed here but the operands
 * that a stage leaves unnamed, from the same vertices. */

const SCALE = { 1: 1, 2: 1, 3: 16, 4: 16 }; /* a stage's units of x and y in a pixel */
const FIXED = 65536;                        /* 16.16 */
const KINDS = ["gradients", "edge", "edge step", "span", "segment", "pixel"];
const QUANTITIES = [["one_over_z", "1/z"], ["u_over_z", "u/z"], ["v_over_z", "v/z"]];

const s = (value) => show(value, 5);
const factor = (value) => (value < 0 ? `(${s(value)})` : s(value));
const by = (a, b) => `${factor(a)} \u00b7 ${factor(b)}`;

/* A triangle's way through a stage. An event's `v` has what the stage computed, by its own names;
 * added here are: an edge's side and corners, the scanline y, pixel x, a span's first pixel and
 * end, and `before`, the number of the event that computed the same things last. `piece` counts
 * what clipping leaves of a triangle. */
class Run {
  constructor(stage, events, vertices, width, piece = 0) {
    Object.assign(this, { stage, events, width, piece, order: new Map(), last: {} });
    this.corners = vertices.map((c) => ({ ...c, one_over_z: 1 / c.z, u_over_z: c.u / c.z,
      v_over_z: c.v / c.z, row: Math.ceil(c.y) })).sort((a, b) => a.y - b.y || a.x - b.x);
    events.forEach((event, i) => this.place(event, i));
  }

  at(i) {
    return this.events[i];
  }

  place(event, i) {
    const name = KINDS[event.kind];
    event.points = this.corners;
    event.piece = this.piece;
    if (name === "gradients") {
      Object.assign(this, { longLeft: event.v.area > 0, row: {}, x: {}, corner: {} });
    } else if (name === "edge" || name === "edge step") {
      this.placeEdge(event, name === "edge");
    } else if (name === "span") {
      event.y = event.v.y;
      event.first = Math.ceil(this.x.left); /* whole already in stages 2 to 4 */
      event.end = Math.max(Math.ceil(this.x.right), event.first);
      event.left = this.x.left;
      event.right = this.x.right;
    } else {
      event.y = Math.floor(event.pixel / this.width);
      event.x = event.pixel % this.width;
      event.count = name === "segment" ? event.v.count : 1;
    }
    if (name === "pixel" && !this.order.has(event.pixel)) {
      this.order.set(event.pixel, i);
    }
    const group = event.side || name;
    event.before = this.last[group];
    this.last[group] = i;
    event.span = this.last.span;
    event.segment = this.last.segment;
    event.gradients = this.last.gradients;
  }

  /* The long edge runs from corner 0 to 2; the short ones from 0 to 1 and from 1 to 2, of which one
   * that crosses no scanline is left out. */
  placeEdge(event, first) {
    const { v } = event, side = Boolean(v.short) === this.longLeft ? "right" : "left";
    if (first) {
      this.corner[side] = !v.short ? [0, 2]
        : this.corner[side] || this.corners[0].row === this.corners[1].row ? [1, 2] : [0, 1];
      this.row[side] = this.corners[this.corner[side][0]].row;
    } else {
      this.row[side] += 1;
    }
    const y = this.row[side], top = this.corners[this.corner[side][0]], was = this.x[side];
    event.path = first /* the prestep: down, then right; a step: down, then the carry */
      ? [[top.x, top.y], [this.stage > 1 ? top.x : v.x, y], [v.x, y]]
      : [[was, y - 1], [this.stage > 1 ? was + v.x_step : v.x, y], [v.x, y]];
    this.x[side] = v.x;
    Object.assign(event, { side, y: this.row[side], corners: this.corner[side],
      edge: this.corner[side].map((k) => [this.corners[k].x, this.corners[k].y]) });
  }
}

/* Title, sentence and formulas of step i. */
function explain(run, i, exact) {
  const event = run.at(i), was = event.before === undefined ? null : run.at(event.before).v;
  const own = Object.assign(Object.create(run), { corners: event.points });
  const result = [explainGradients, explainEdge, explainEdgeStep, explainSpan, explainSegment,
    explainPixel][event.kind](own, event, was, exact);
  return { ...result, formulas: result.formulas.flat().filter(Boolean) };
}

function explainGradients(run, { v }) {
  const [a, b, c] = run.corners, unit = SCALE[run.stage];
  const [x1, y1, x2, y2] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y].map((d) => d * unit);
  const corners = { 1: "", 2: ", from corners rounded to whole pixels: where rounding moves a " +
    "corner, the plane tilts" }[run.stage] ?? ", from corners in sixteenths of a pixel";
  return {
    title: "Gradients: the plane of 1/z, u/z and v/z",
    text: "Seen in perspective u is not linear on the screen, but 1/z, u/z and v/z are: each " +
      "changes by the same amount for every pixel to the right, and for every pixel down. These " +
      `amounts are found once for the triangle${corners}.`,
    formulas: [
      `area = x1 y2 \u2212 x2 y1 = ${by(x1, y2)} \u2212 ${by(x2, y1)} = ${s(v.area)}`,
      QUANTITIES.map(([key, label]) => `d(${label})/dx = ((f1 \u2212 f0) y2 \u2212 ` +
        `(f2 \u2212 f0) y1) / area = (${by(b[key] - a[key], y2)} \u2212 ` +
        `${by(c[key] - a[key], y1)})${unit > 1 ? ` \u00b7 ${unit}` : ""} / ${factor(v.area)} = ` +
        s(v[`${key}_dx`])),
      QUANTITIES.map(([key, label]) => `d(${label})/dy = ${s(v[`${key}_dy`])}`).join(",  "),
    ],
  };
}

/* How u/z changes a scanline down and so many pixels to the right. */
const stepOf = (g, pixels) => g.u_over_z_dy + pixels * g.u_over_z_dx;

function explainEdge(run, event) {
  const [top, bottom] = event.corners.map((k) => run.corners[k]), v = event.v;
  const unit = SCALE[run.stage], g = run.at(event.gradients).v;
  const dx = (bottom.x - top.x) * unit, dy = (bottom.y - top.y) * unit;
  const title = `Edge setup: ${event.side} edge, the ${v.short ? "short" : "long"} one`;
  const prestep = top.row * unit - top.y * unit;
  if (run.stage === 1) {
    return { title,
      text: "Where does the edge cross the first scanline below its top corner? The way down to " +
        "that scanline is the prestep.",
      formulas: [
        `x_step = dx / dy = ${factor(dx)} / ${factor(dy)} = ${s(v.x_step)}`,
        `prestep = ${top.row} \u2212 ${factor(top.y)} = ${s(prestep)}`,
        `x = ${s(top.x)} + ${by(prestep, v.x_step)} = ${s(v.x)}`,
        `u/z = ${s(top.u_over_z)} + ${by(prestep, stepOf(g, v.x_step))} = ${s(v.u_over_z)}`,
      ] };
  }
  const times = unit > 1 ? `${unit} \u00b7 ` : "", x0 = top.x * unit, whole = Math.floor(top.x);
  const steps = [
    `x_step = floor(dx / dy) = floor(${s(dx)} / ${s(dy)}) = ${s(v.x_step)}`,
    `numerator = ${times}(${s(dx)} \u2212 ${by(v.x_step, dy)}) = ${s(v.numerator)},  denominator ` +
      `D = ${times}dy = ${s(v.denominator)}`,
  ];
  if (run.stage === 2) {
    return { title,
      text: "The slope dx/dy as a whole number and a fraction numerator/D, in integers: nothing " +
        "is ever rounded. The corner is a whole pixel, so the edge begins on it, and the error " +
        "term at D \u2212 1: the least fraction more leads to the next pixel, which is ceil.",
      formulas: [steps, `x = ${s(v.x)},  error = D \u2212 1 = ${s(v.error)}`] };
  }
  const n = (x0 - unit * whole) * dy + prestep * dx + v.denominator - 1;
  return { title,
    text: `The top corner lies ${s(prestep)}/16 pixel above its first scanline: the prestep. ` +
      "Integers take the edge there, and the gradients take 1/z, u/z and v/z from the corner to " +
      "the centre of the first pixel.",
    formulas: [steps,
      `N = x0 dy + prestep dx + D \u2212 1 = ${by(x0 - unit * whole, dy)} + ${by(prestep, dx)} + ` +
        `${s(v.denominator)} \u2212 1 = ${s(n)}  (sixteenths; x0 from pixel ${whole} on)`,
      `x = ${whole} + floor(N / D) = ${whole} + floor(${s(n)} / ${s(v.denominator)}) = ${s(v.x)}`,
      `error = N \u2212 ${factor(v.x - whole)} D = ${s(v.error)}`,
      `prestep_x = ${s(v.x)} \u2212 ${factor(top.x)} = ${s(v.x - top.x)},  prestep_y = ` +
        `${s(prestep)}/16 = ${s(prestep / unit)}`,
      "u/z = u0/z0 + prestep_x d(u/z)/dx + prestep_y d(u/z)/dy = " +
        `${s(top.u_over_z)} + ${by(v.x - top.x, g.u_over_z_dx)} + ` +
        `${by(prestep / unit, g.u_over_z_dy)} = ${s(v.u_over_z)}`,
    ] };
}

function explainEdgeStep(run, event, was) {
  const v = event.v, g = run.at(event.gradients).v, top = run.corners[event.corners[0]];
  const title = `Edge step: ${event.side} edge to scanline ${event.y}`;
  const carried = (pixels) => event.side === "left" && `u/z = ${s(was.u_over_z)} + d(u/z)/dy + ` +
    `${factor(pixels)} d(u/z)/dx = ${s(was.u_over_z)} + ${factor(stepOf(g, pixels))} = ` +
    s(v.u_over_z);
  if (run.stage === 1) {
    return { title,
      text: "x is found anew from the corner, so that float additions cannot add up an error; " +
        "1/z, u/z and v/z are stepped.",
      formulas: [`x = x0 + (y \u2212 y0) x_step = ${s(top.x)} + (${event.y} \u2212 ` +
        `${factor(top.y)}) \u00b7 ${factor(v.x_step)} = ${s(v.x)}`, carried(v.x_step)] };
  }
  const sum = was.error + was.numerator, carry = sum >= was.denominator ? 1 : 0;
  return { title: title + (carry ? ": carry" : ""),
    text: carry
      ? "The fractions have added up to a whole pixel: the carry. x moves one pixel more, and " +
        "the error gives D back."
      : "The fraction of the slope goes to the error term. It stays below D, so x moves by " +
        "x_step alone: no carry.",
    formulas: [
      `error: ${s(was.error)} + ${s(was.numerator)} = ${s(sum)} ${carry ? "\u2265" : "<"} ` +
        `${s(was.denominator)}: ${carry ? "carry" : "no carry"}, error = ` +
        (carry ? `${s(sum)} \u2212 ${s(was.denominator)} = ` : "") + s(v.error),
      `x = ${s(was.x)} + ${factor(was.x_step)} + ${carry} = ${s(v.x)}`,
      carried(v.x_step + carry),
    ] };
}

/* Does u rise to the right, where a span has `v`? */
const rises = (v, key) => v[`${key}_dx`] * v.one_over_z >= v[key] * v.one_over_z_dx;

/* The rounding choice in words, and the texels that may show: those of the triangle's range. */
function choice(run, name, up) {
  const all = run.corners.map((corner) => corner[name]), min = Math.min(...all);
  const max = Math.max(...all), lo = Math.floor(min + 0.5), hi = Math.ceil(max - 0.5);
  const constant = hi < lo ? `, on a border everywhere: ${s(hi === SIDE - 1 ? hi : lo)}` : "";
  return `${name} ${up ? `rises: floor(${name} + 1/2)` : `falls: ceil(${name} \u2212 1/2)`}, in ` +
    `lo .. hi = floor(${s(min)} + 1/2) .. ceil(${s(max)} \u2212 1/2) = ` +
    `${s(lo)} .. ${s(hi)}${constant}`;
}
const ROUNDED = " On the border between two texels the one that lies ahead is taken: so a " +
  "texture that begins at its border, u = \u22121/2, begins with texel 0, not the one before.";

function explainSpan(run, { v, y, first, end, left, right }) {
  const list = end > first ? `pixels ${first} .. ${end - 1}: ${end - first}` : "no pixel";
  return {
    title: `Span: scanline ${y}`,
    text: "A pixel belongs to the triangle when its centre lies between the edges. A centre on " +
      "the left edge is in, one on the right edge is out: so two triangles that share an edge " +
      `share no pixel.${run.stage === 3 ? ` One rule for the span rounds texels.${ROUNDED}` : ""}`,
    formulas: [
      run.stage === 1
        ? [`first = ceil(${s(left)}) = ${first},  end = ceil(${s(right)}) = ${end}`, list,
          `u/z at the first centre = left + (${first} \u2212 ${factor(left)}) \u00b7 ` +
            `${factor(v.u_over_z_dx)} = ${s(v.u_over_z)}`]
        : [`${list}  (the error term holds the ceil)`,
          `u/z at the first centre = ${s(v.u_over_z)}, carried along the left edge`],
      run.stage === 3 && ["u", "v"].map((n) => choice(run, n, rises(v, `${n}_over_z`))),
    ],
  };
}

/* What a span's planes of 1/z and u/z say at pixel x: the depth, and the true u. */
function truth(run, event, x) {
  const { v, first } = run.at(event.span), p = x - first;
  const z = 1 / (v.one_over_z + p * v.one_over_z_dx);
  return { z, u: (v.u_over_z + p * v.u_over_z_dx) * z };
}

/* What bounds a segment's chord: over du texels between depths in the ratio r it errs by at most
 * |du| (sqrt r - 1)/(sqrt r + 1). */
function chordOf(run, event) {
  const du = event.v.u_end - event.v.u, { z } = truth(run, event, event.x);
  const end = truth(run, event, event.x + event.v.length).z;
  const root = Math.sqrt(Math.max(end / z, z / end));
  return { du, z, end, bound: Math.abs(du) * (root - 1) / (root + 1) };
}

function explainSegment(run, event) {
  const v = event.v, { du, z, end, bound } = chordOf(run, event);
  return {
    title: `Segment: ${plural(v.count, "pixel")} from x = ${event.x}`,
    text: "A divide at each end only. Between them u is taken for a straight line, the chord, " +
      `though it is a curve: it bends where depth changes. Texels are rounded.${ROUNDED}`,
    formulas: [
      `u = (u/z) / (1/z) = ${s(v.u)} here, ${s(v.u_end)} at the end, ` +
        `${plural(v.length, "pixel")} on`,
      `du = ${s(v.u_end)} \u2212 ${factor(v.u)} = ${s(du)},  step = du / ${v.length} = ` +
        `${s(v.u_step_16_16 / FIXED)} texel a pixel`,
      `r = z_end / z = ${s(end)} / ${s(z)} = ${s(end / z)},  bound = |du| (\u221ar \u2212 1)/` +
        `(\u221ar + 1) = ${s(bound)} texel`,
      ["u", "v"].map((n) => choice(run, n, v[`${n}_end`] >= v[n])),
    ],
  };
}

/* The exact answer in a pixel: its coordinate, and the texel. */
function exactLine(name, value, got) {
  const right = Math.floor(value + 0.5), same = (texel) => ((got - texel) & SIDE - 1) === 0;
  const border = Math.abs(value + 0.5 - Math.round(value + 0.5)) < 1e-6;
  return `exact ${name} = ${s(value)}: texel ${border ? `${s(right - 1)} or ` : ""}${s(right)}, ` +
    (same(right) || border && same(right - 1) ? "the same" : `not ${got}`);
}

function explainPixel(run, event, was, exact) {
  const v = event.v, title = `Pixel: pixel ${event.x}, ${event.y}`, both = ["u", "v"];
  const compared = exact && exact[3]
    ? both.map((n, i) => exactLine(n, exact[i], v[`texel_${n}`]))
    : "the exact answer does not cover this pixel";
  const z = `z = 1 / (1/z) = 1 / ${s(v.one_over_z)} = ${s(v.z)}`;
  if (run.stage === 4) {
    const segment = run.at(event.segment), p = event.x - segment.x;
    const { u } = truth(run, event, event.x);
    return { title,
      text: "No divide: one addition each for u and v, in 16.16 fixed point. The half that " +
        "rounds was added at the segment's start, so a shift by 16 leaves the texel.",
      formulas: [
        both.map((n) => `${n} = start + ${p} step = ${s(segment.v[`${n}_16_16`] / FIXED)} + ` +
          `${by(p, segment.v[`${n}_step_16_16`] / FIXED)} = ${s(v[`${n}_16_16`] / FIXED)}, ` +
          `>> 16: texel ${v[`texel_${n}`]}`),
        `u without the half = ${s(v.u)}, the curve (u/z)/(1/z) = ${s(u)}: error here ` +
          `${s(v.u - u)}, bound ${s(chordOf(run, segment).bound)}`,
        compared,
      ] };
  }
  if (run.stage === 3) {
    const span = run.at(event.span).v;
    return { title,
      text: "The divide gives z back, and z gives u and v. They are rounded to the nearest " +
        "texel. Which way a half goes was chosen for the span: step back to it for the reason.",
      formulas: [z, both.map((n) => (rises(span, `${n}_over_z`)
        ? `${n} rises: floor(${s(v[n])} + 1/2) = ${v[`texel_${n}`]}`
        : `${n} falls: ceil(${s(v[n])} \u2212 1/2) = ${v[`texel_${n}`]}`)), compared] };
  }
  return { title,
    text: "The divide gives z back, and z gives u and v. The cast to int truncates: 12.7 becomes " +
      "texel 12, though the centre of texel 13 is nearer.",
    formulas: [z, both.map((n) => `${n} = (int)(${n}/z \u00b7 z) = (int)(` +
      `${by(v[`${n}_over_z`], v.z)}) = (int)${factor(v[n])} = ${v[`texel_${n}`]}`), compared] };
}

/* What a step costs in stages 1 to 4, counted in their sources: divides, conversions from float to
 * int, multiplications, additions and subtractions; of the setup of edges and gradients, which
 * comes once a triangle, nothing. */
const NOTHING = [0, 0, 0, 0];
const COSTS = {
  "edge step": [[0, 0, 1, 6], [0, 0, 0, 7], [0, 0, 0, 7], [0, 0, 0, 7]],
  span: [[0, 2, 3, 4], NOTHING, [1, 0, 17, 9], [1, 0, 2, 2]], /* stage 4: the divide at its start */
  segment: [NOTHING, NOTHING, NOTHING, [1, 4, 9, 9]],         /* and at each segment's end */
  pixel: [[1, 2, 3, 4], [1, 2, 3, 4], [1, 2, 3, 6], [0, 0, 0, 3]],
};

/* The sum of it up to step `last`. */
function costs(run, last) {
  const sum = [0, 0, 0, 0];
  run.events.slice(0, last + 1).forEach((event) => {
    const cost = (COSTS[KINDS[event.kind]] || [])[run.stage - 1] || NOTHING;
    cost.forEach((n, i) => { sum[i] += n; });
  });
  return sum;
}
