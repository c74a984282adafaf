/* One scanline of stage 4: the curve u(x), the chords that it draws, how far apart they may be. */

const FIGURE = { width: 760, left: 66, right: 748, curveTop: 12, curveBottom: 300, errorTop: 348,
  errorBottom: 460, height: 496 };

function bound(du, ratio) {
  const root = Math.sqrt(ratio);
  return Math.abs(du) * (root - 1) / (root + 1);
}

class Chords {
  constructor() {
    [this.row] = dataOf("chords").rows;
    const { span, pixels } = this.row;
    this.first = span.x;
    this.last = span.x + span.count - 1;
    this.segments = this.row.segments.map((segment) => this.measure(segment));
    this.uMax = Math.max(...pixels.map((pixel) => pixel.exact_u));
    this.errorMax = Math.max(...this.segments.map((segment) => segment.bound));
    byId("chords-figure").append(this.figure());
    byId("chords-table").tBodies[0].append(...this.segments.map((s) =>
      tableRow(`${s.x} to ${s.x + s.count - 1}`, [s.du, s.ratio, s.bound, s.error].map((value) =>
        show(value, 4)))));
  }

  /* The linear quantities at x, which need not be whole, as the stage has them. */
  linear(field, x) {
    const { span } = this.row;
    return span[field] + (x - this.first) * span[`${field}_dx`];
  }

  u(x) {
    return this.linear("u_over_z", x) / this.linear("one_over_z", x);
  }

  /* A segment with what bounds its error, and the largest that its pixels really have. */
  measure(segment) {
    const end = segment.x + segment.length;
    const ratio = this.linear("one_over_z", segment.x) / this.linear("one_over_z", end);
    const du = segment.u_end - segment.u;
    const errors = this.row.pixels
      .filter((p) => p.x >= segment.x && p.x < segment.x + segment.count)
      .map((p) => Math.abs(p.u - p.exact_u));
    return { ...segment, end, du, ratio: Math.max(ratio, 1 / ratio), error: Math.max(...errors),
      bound: bound(du, Math.max(ratio, 1 / ratio)) };
  }

  x(x) {
    return FIGURE.left + (x - this.first) / (this.last - this.first) * (FIGURE.right - FIGURE.left);
  }

  y(u) {
    return FIGURE.curveBottom - u / this.uMax * (FIGURE.curveBottom - FIGURE.curveTop);
  }

  errorY(error) {
    return FIGURE.errorBottom - error / this.errorMax * (FIGURE.errorBottom - FIGURE.errorTop);
  }

  figure() {
    const title = svg("title", {}, "u along one scanline of stage 4: the curve, its chords, and "
      + "below the error of each pixel under the bound of each segment");
    return svg("svg", { viewBox: `0 0 ${FIGURE.width} ${FIGURE.height}`, role: "img" }, title,
      this.axes(), this.curve(), ...this.segments.map((segment) => this.segment(segment)),
      polyline(this.row.pixels.map((p) => [this.x(p.x), this.errorY(Math.abs(p.u - p.exact_u))]),
        "error"), this.key());
  }

  axes() {
    const group = svg("g");
    for (const segment of this.segments) {
      group.append(line(this.x(segment.x), FIGURE.curveTop, this.x(segment.x), FIGURE.errorBottom,
        "grid"), text(this.x(segment.x), FIGURE.height - 16, String(segment.x), "middle", "soft"));
    }
    for (const u of [0, 32, 64, 96, 128].filter((value) => value <= this.uMax)) {
      group.append(line(FIGURE.left, this.y(u), FIGURE.right, this.y(u), "grid"),
        text(FIGURE.left - 6, this.y(u) + 4, String(u), "end", "soft"));
    }
    const top = show(this.errorMax, 3);
    group.append(line(FIGURE.left, FIGURE.errorBottom, FIGURE.right, FIGURE.errorBottom, "grid"),
      text(FIGURE.left - 6, this.errorY(0) + 4, "0", "end", "soft"),
      text(FIGURE.left - 6, this.errorY(this.errorMax) + 4, top, "end", "soft"),
      text(FIGURE.right, FIGURE.height - 2, "x, pixels", "end", "soft"),
      text(FIGURE.left + 8, FIGURE.curveTop + 12, "u, texels"),
      text(FIGURE.left + 8, FIGURE.errorTop - 10, "error, texels"));
    return group;
  }

  curve() {
    const points = [];
    for (let x = this.first; x <= this.last; x += 0.25) {
      points.push([this.x(x), this.y(this.u(x))]);
    }
    return polyline(points, "curve");
  }

  segment(s) {
    const end = Math.min(s.end, this.last);
    const ends = [[this.x(s.x), this.y(s.u)], [this.x(end), this.y(s.u_end)]];
    const dots = ends.map(([cx, cy]) => svg("circle", { cx: round(cx), cy: round(cy), r: 4,
      class: "dot" }));
    return svg("g", {}, polyline(ends, "chord"), ...dots,
      line(this.x(s.x), this.errorY(s.bound), this.x(end), this.errorY(s.bound), "bound"));
  }

  key() {
    const group = svg("g");
    const names = [["curve", "u, exact"], ["chord", "u, stage 4"], ["bound", "the bound"],
      ["error", "error of its pixels"]];
    names.forEach(([name, label], i) => {
      const [x, y] = [FIGURE.left + 90, FIGURE.curveTop + 50 + 28 * i];
      group.append(line(x, y - 4, x + 34, y - 4, name), text(x + 42, y, label));
    });
    return group;
  }
}
