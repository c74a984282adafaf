/* Why: what a step of a stage computes, as a title, a sentence, and formulas with the numbers in
 * them. All results are the stage's own, from its trace; nothing is computed here but the operands
 * that a stage leaves unnamed, from the same vertices. */

const SCALE = { 1: 1, 2: 1, 3: 16, 4: 16 }; /* a stage's units of x and y in a pixel */
const FIXED = 65536;                        /* 16.16 */
const KINDS = ["gradients", "edge", "edge step", "span", "segment", "pixel"];
const QUANTITIES = [["one_over_z", "1/z"], ["u_over_z", "u/z"], ["v_over_z", "v/z"]];

const s = (value) => show(value, 5);

/* A template's numbers for people, a negative one behind an operator in parentheses. */
const f = (texts, ...values) => texts.reduce((all, text, i) => {
  const value = values[i - 1], given = typeof value === "string" ? value : s(value);
  return all + (value < 0 && /[\u00b7+\u2212/] $/.test(all) ? `(${given})` : given) + text;
});

/* A triangle's way through a stage. An event's `v` has what the stage computed, by its own names;
 * added here are: an edge's side and corners, the scanline y, pixel x, a span's first pixel and
 * end, and `before`, the number of the event that computed the same things last. `order` has the
 * step of each pixel. */
class Run {
  constructor(stage, width) {
    Object.assign(this, { stage, width, events: [], order: new Map() });
  }

  /* The triangle's vertices as the stage has them, or those of a piece that clipping leaves. */
  add(events, vertices) {
    this.last = {};
    this.corners = vertices.map((c) => ({ ...c, one_over_z: 1 / c.z, u_over_z: c.u / c.z,
      v_over_z: c.v / c.z, row: Math.ceil(c.y) })).sort((a, b) => a.y - b.y || a.x - b.x);
    for (const event of events) {
      this.place(Object.assign(event, { points: this.corners }), this.events.length);
      this.events.push(event);
    }
  }

  at(i) {
    return this.events[i];
  }

  place(event, i) {
    const name = KINDS[event.kind];
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

/* Title, sentence and formulas of step i; `exact`: the exact answer there. */
function explain(run, i, exact) {
  const event = run.at(i), g = run.at(event.gradients).v, was = run.at(event.before);
  const [title, text, ...formulas] = [explainGradients, explainEdge, explainEdgeStep, explainSpan,
    explainSegment, explainPixel][event.kind](run, event, g, was && was.v, exact);
  return { title, text, formulas: formulas.flat().filter(Boolean) };
}

function explainGradients(run, { v, points: [a, b, c] }) {
  const unit = SCALE[run.stage], times = unit > 1 ? ` \u00b7 ${unit}` : "";
  const [x1, y1, x2, y2] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y].map((d) => d * unit);
  return ["Gradients: the plane of 1/z, u/z and v/z",
    "Seen in perspective u is not linear on the screen, but 1/z, u/z and v/z are: each changes " +
    "by the same amount for every pixel to the right, and for every pixel down. These amounts " +
    "are found once for the triangle" + ({ 1: "", 2: ", from corners rounded to whole pixels: " +
    "where rounding moves a corner, the plane tilts" }[run.stage] ??
    ", from corners in sixteenths of a pixel") + ".",
    f`area = x1 y2 \u2212 x2 y1 = ${x1} \u00b7 ${y2} \u2212 ${x2} \u00b7 ${y1} = ${v.area}`,
    QUANTITIES.map(([key, label]) => `d(${label})/dx = ((f1 \u2212 f0) y2 \u2212 (f2 \u2212 f0) ` +
      f`y1) / area = (${b[key] - a[key]} \u00b7 ${y2} \u2212 ${c[key] - a[key]} \u00b7 ${y1})` +
      f`${times} / ${v.area} = ${v[`${key}_dx`]}`),
    QUANTITIES.map(([key, label]) => f`d(${label})/dy = ${v[`${key}_dy`]}`).join(",  ")];
}

/* How u/z changes a scanline down and so many pixels to the right. */
const stepOf = (g, pixels) => g.u_over_z_dy + pixels * g.u_over_z_dx;

function explainEdge(run, { v, side, corners, points }, g) {
  const [top, bottom] = corners.map((k) => points[k]), unit = SCALE[run.stage];
  const dx = (bottom.x - top.x) * unit, dy = (bottom.y - top.y) * unit;
  const prestep = top.row * unit - top.y * unit, first = Math.floor(top.x);
  const title = `Edge setup: ${side} edge, the ${v.short ? "short" : "long"} one`;
  const times = unit > 1 ? `${unit} \u00b7 ` : "", x0 = (top.x - first) * unit;
  const slope = [f`x_step = floor(dx / dy) = floor(${dx} / ${dy}) = ${v.x_step}`,
    f`numerator = ${times}(${dx} \u2212 ${v.x_step} \u00b7 ${dy}) = ${v.numerator},  ` +
      f`denominator D = ${times}dy = ${v.denominator}`];
  const n = x0 * dy + prestep * dx + v.denominator - 1;
  return [null,
    [title, "Where does the edge cross the first scanline below its top corner? The way down to " +
      "that scanline is the prestep.",
    f`x_step = dx / dy = ${dx} / ${dy} = ${v.x_step}`,
    f`prestep = ${top.row} \u2212 ${top.y} = ${prestep}`,
    f`x = ${top.x} + ${prestep} \u00b7 ${v.x_step} = ${v.x}`,
    f`u/z = ${top.u_over_z} + ${prestep} \u00b7 ${stepOf(g, v.x_step)} = ${v.u_over_z}`],
    [title, "The slope dx/dy as a whole number and a fraction numerator/D, in integers: nothing " +
      "is ever rounded. The corner is a whole pixel, so the edge begins on it, and the error " +
      "term at D \u2212 1: the least fraction more leads to the next pixel, which is ceil.",
    slope, f`x = ${v.x},  error = D \u2212 1 = ${v.error}`],
    [title, `The top corner lies ${s(prestep)}/16 pixel above its first scanline: the prestep. ` +
      "Integers take the edge there, and the gradients take 1/z, u/z and v/z from the corner to " +
      "the centre of the first pixel.",
    slope,
    f`n = x0 dy + prestep dx + D \u2212 1 = ${x0} \u00b7 ${dy} + ${prestep} \u00b7 ${dx} + ` +
      f`${v.denominator} \u2212 1 = ${n}  (x0 counted from pixel ${first} on; ` +
      "D \u2212 1 makes the division a ceiling)",
    f`x = ${first} + floor(n / D) = ${first} + floor(${n} / ${v.denominator}) = ${v.x}`,
    f`error = n \u2212 ${v.x - first} D = ${v.error}`,
    f`prestep_x = ${v.x} \u2212 ${top.x} = ${v.x - top.x},  prestep_y = ${prestep}/16 = ` +
      s(prestep / unit),
    "u/z = u0/z0 + prestep_x d(u/z)/dx + prestep_y d(u/z)/dy = " +
      f`${top.u_over_z} + ${v.x - top.x} \u00b7 ${g.u_over_z_dx} + ` +
      f`${prestep / unit} \u00b7 ${g.u_over_z_dy} = ${v.u_over_z}`],
  ][Math.min(run.stage, 3)];
}

function explainEdgeStep(run, { v, y, side, corners, points }, g, was) {
  const top = points[corners[0]], title = `Edge step: ${side} edge to scanline ${y}`;
  const carried = (pixels) => side === "left" && f`u/z = ${was.u_over_z} + d(u/z)/dy + ` +
    f`${pixels} d(u/z)/dx = ${was.u_over_z} + ${stepOf(g, pixels)} = ${v.u_over_z}`;
  if (run.stage === 1) {
    return [title, "x is found anew from the corner, so that float additions cannot add up an " +
      "error; 1/z, u/z and v/z are stepped.",
    f`x = x0 + (y \u2212 y0) x_step = ${top.x} + (${y} \u2212 ${top.y}) \u00b7 ${v.x_step} = ` +
      s(v.x),
    carried(v.x_step)];
  }
  const sum = was.error + was.numerator, D = was.denominator, carry = sum >= D ? 1 : 0;
  return [title + (carry ? ": carry" : ""), carry
    ? "The fractions have added up to a whole pixel: the carry. x moves one pixel more, and D " +
      "is subtracted from the error."
    : "The fraction of the slope is added to the error term. It stays below D, so x moves by " +
      "x_step alone: no carry.",
  f`error: ${was.error} + ${was.numerator} = ${sum} ` + (carry
    ? f`\u2265 ${D}: carry, error = ${sum} \u2212 ${D} = ${v.error}`
    : f`< ${D}: no carry, error = ${v.error}`),
  f`x = ${was.x} + ${was.x_step} + ${carry} = ${v.x}`,
  carried(v.x_step + carry)];
}

/* Does u rise to the right, where a span has `v`? */
const rises = (v, key) => v[`${key}_dx`] * v.one_over_z >= v[key] * v.one_over_z_dx;

/* The rounding choice in words, and the texels that may show: those of the triangle's range. */
function choice(points, name, up) {
  const all = points.map((corner) => corner[name]), min = Math.min(...all), max = Math.max(...all);
  const lo = Math.floor(min + 0.5), hi = Math.ceil(max - 0.5);
  return `${name} ${up ? `rises: floor(${name} + 1/2)` : `falls: ceil(${name} \u2212 1/2)`}, in ` +
    f`lo .. hi = floor(${min} + 1/2) .. ceil(${max} \u2212 1/2) = ${lo} .. ${hi}` +
    (hi < lo ? `, on a border everywhere: ${s(hi === SIDE - 1 ? hi : lo)}` : "");
}
const ROUNDED = " On the border between two texels the one that lies ahead is taken: so a " +
  "texture that begins at its border, u = \u22121/2, begins with texel 0. lo .. hi: the texels " +
  "between the smallest and the largest corner u; a span's ends are clamped to them.";

function explainSpan(run, { v, y, first, end, left, right, points }) {
  const list = end > first ? `pixels ${first} .. ${end - 1}: ${end - first}` : "no pixel";
  return [`Span: scanline ${y}`,
    "A pixel belongs to the triangle when its centre lies between the edges. A centre on the " +
    "left edge is in, one on the right edge is out: so two triangles that share an edge share no " +
    `pixel.${run.stage === 3 ? ` One rule for the span rounds texels.${ROUNDED}` : ""}`,
    run.stage === 1
      ? [f`first = ceil(${left}) = ${first},  end = ceil(${right}) = ${end}`, list,
        f`u/z at the first centre = left + (${first} \u2212 ${left}) \u00b7 ${v.u_over_z_dx} = ` +
          s(v.u_over_z)]
      : [`${list}  (the error term has rounded x up)`,
        f`u/z at the first centre = ${v.u_over_z}, carried along the left edge`],
    run.stage === 3 && ["u", "v"].map((n) => choice(points, n, rises(v, `${n}_over_z`)))];
}

/* What a span's planes of 1/z and u/z say at pixel x: the depth, and the true u. */
function truth(run, event, x) {
  const { v, first } = run.at(event.span), p = x - first;
  const z = 1 / (v.one_over_z + p * v.one_over_z_dx);
  return { z, u: (v.u_over_z + p * v.u_over_z_dx) * z };
}

/* What bounds a segment's chord: over du texels between depths in the ratio r it errs by at most
 * |du| |sqrt r - 1| / (sqrt r + 1). */
function chordOf(run, event) {
  const du = event.v.u_end - event.v.u, { z } = truth(run, event, event.x);
  const end = truth(run, event, event.x + event.v.length).z;
  const root = Math.sqrt(Math.max(end / z, z / end));
  return { du, z, end, bound: Math.abs(du) * (root - 1) / (root + 1) };
}

function explainSegment(run, event) {
  const { v, points } = event, { du, z, end, bound } = chordOf(run, event);
  return [`Segment: ${plural(v.count, "pixel")} from x = ${event.x}`,
    "A divide at each end only. Between them u is taken for a straight line, the chord, though " +
    `it is a curve: it bends where depth changes. Texels are rounded.${ROUNDED}`,
    f`u = (u/z) / (1/z) = ${v.u} here, ${v.u_end} at the end, ${plural(v.length, "pixel")} on`,
    f`du = ${v.u_end} \u2212 ${v.u} = ${du},  step = du / ${v.length} = ` +
      f`${v.u_step_16_16 / FIXED} texel a pixel`,
    f`r = z_end / z = ${end} / ${z} = ${end / z},  bound = |du| |\u221ar \u2212 1| / ` +
      f`(\u221ar + 1) = ${bound} texel`,
    ["u", "v"].map((n) => choice(points, n, v[`${n}_end`] >= v[n]))];
}

/* The exact answer in a pixel, and whether that texel was got. */
function exactLine(name, { at, texel, other }, got) {
  const same = [texel, texel + other].some((right) => ((got - right) & SIDE - 1) === 0);
  return f`exact ${name} = ${at}: texel ${texel}${other ? f` or ${texel + other}` : ""}, ` +
    (same ? "the same" : `not ${got}`);
}

function explainPixel(run, event, g, was, exact) {
  const { v, x } = event, title = `Pixel: pixel ${x}, ${event.y}`, both = ["u", "v"];
  const compared = exact ? both.map((n, i) => exactLine(n, exact[i], v[`texel_${n}`]))
    : "the exact answer does not cover this pixel";
  const z = f`z = 1 / (1/z) = 1 / ${v.one_over_z} = ${v.z}`, span = run.at(event.span).v;
  if (run.stage === 4) {
    const segment = run.at(event.segment), p = x - segment.x, { u } = truth(run, event, x);
    return [title, "No divide: one addition each for u and v, in 16.16 fixed point. The half " +
      "that rounds, and 4/65536 for ties, were added at the segment's start: >> 16 is the texel.",
    both.map((n) => `${n} + 1/2 ${segment.v[`${n}_end`] >= segment.v[n] ? "+" : "\u2212"} tie = ` +
      f`start + ${p} step = ${segment.v[`${n}_16_16`] / FIXED} + ${p} ` +
      f`\u00b7 ${segment.v[`${n}_step_16_16`] / FIXED} = ${v[`${n}_16_16`] / FIXED}, >> 16: ` +
      `texel ${v[`texel_${n}`]}`),
    f`u = ${v.u}, the curve (u/z)/(1/z) = ${u}: error here ${v.u - u}, bound ` +
      s(chordOf(run, segment).bound),
    compared];
  }
  if (run.stage === 3) {
    return [title, "The divide gives z back, and z gives u and v. They are rounded to the " +
      "nearest texel. Which way a half goes was chosen for the span: step back to it for the " +
      "reason.",
    z, both.map((n) => (rises(span, `${n}_over_z`)
      ? f`${n} rises: floor(${v[n]} + 1/2) = ${v[`texel_${n}`]}`
      : f`${n} falls: ceil(${v[n]} \u2212 1/2) = ${v[`texel_${n}`]}`)), compared];
  }
  return [title, "The divide gives z back, and z gives u and v. The cast to int truncates: 12.7 " +
    "becomes texel 12, though the centre of texel 13 is nearer.",
  z, both.map((n) => f`${n} = (int)(${n}/z \u00b7 z) = (int)(${v[`${n}_over_z`]} \u00b7 ${v.z}) ` +
    f`= (int)${v[n]} = ${v[`texel_${n}`]}`), compared];
}
