/* The stepper's figure: a triangle on its pixels, drawn large. */

const CELL = 28; /* the figure's units a pixel */

/* Twice the area of a, b, c; > 0 where c lies to the right of the way from a to b, y being down. */
function area(a, b, c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/* Is the edge a-b, with c the third corner, a left or top one? A point on it is then inside. */
function isLeftOrTop(a, b, c) {
  if (a.y === b.y) {
    return c.y > a.y;
  }
  const [top, bottom] = a.y < b.y ? [a, b] : [b, a];
  return area(top, bottom, c) < 0;
}

/* The edges of a triangle, each with the corner opposite. */
function edgesOf(v) {
  return [[v[0], v[1], v[2]], [v[1], v[2], v[0]], [v[2], v[0], v[1]]];
}

/* Does the triangle cover the centre of pixel x, y? Doubles hold all of it exactly: corners lie on
 * multiples of 2^-16. */
function covers(v, x, y) {
  return area(...v) !== 0 && edgesOf(v).every(([a, b, c]) => {
    const side = area(a, b, { x, y }) * Math.sign(area(a, b, c));
    return side > 0 || (side === 0 && isLeftOrTop(a, b, c));
  });
}

function at(coordinate) {
  return (coordinate + 0.5) * CELL;
}

class TriangleFigure {
  constructor(width, height, trace) {
    this.layers = { row: svg("g"), pixels: svg("g"), now: svg("g") };
    this.cells = new Map();
    const pixels = trace.rows.flatMap((row) => row.pixels.map((pixel) => [pixel, row.y]));
    for (const [pixel, y] of pixels) {
      this.cells.set(pixel, this.cell(pixel, y));
    }
    this.layers.pixels.append(...this.cells.values());
    const viewBox = `0 0 ${width * CELL} ${height * CELL}`;
    this.svg = svg("svg", { viewBox, "aria-hidden": "true" },
      this.layers.row, this.layers.pixels, this.grid(width, height), this.outline(trace),
      this.centres(width, height, trace), this.layers.now);
  }

  /* A drawn pixel: its texel as one of two tints, and a red corner if it is the wrong texel. */
  cell(pixel, y) {
    const [left, top] = [pixel.x * CELL, y * CELL];
    const cell = svg("g", {}, svg("rect", { x: left, y: top, width: CELL, height: CELL,
      class: `texel-${(pixel.texel_u + pixel.texel_v) & 1}` }));
    if (isWrong(pixel)) {
      const size = CELL / 3;
      cell.append(svg("path", { d: `M${left} ${top}h${size}l${-size} ${size}z`, class: "bad" }));
    }
    return cell;
  }

  grid(width, height) {
    const group = svg("g");
    for (let x = 1; x < width; x++) {
      group.append(line(x * CELL, 0, x * CELL, height * CELL, "grid"));
    }
    for (let y = 1; y < height; y++) {
      group.append(line(0, y * CELL, width * CELL, y * CELL, "grid"));
    }
    return group;
  }

  outline(trace) {
    const points = trace.given.map((v) => `${at(v.x)},${at(v.y)}`).join(" ");
    const group = svg("g", {}, svg("polygon", { points, class: "given" }));
    for (const [a, b, c] of edgesOf(trace.rounded)) {
      const kind = isLeftOrTop(a, b, c) ? "edge" : "edge out";
      group.append(line(at(a.x), at(a.y), at(b.x), at(b.y), kind));
    }
    return group;
  }

  centres(width, height, trace) {
    const group = svg("g");
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const inside = covers(trace.given, x, y);
        group.append(svg("circle", { cx: at(x), cy: at(y), r: inside ? 3 : 1.6,
          class: inside ? "inside" : "centre" }));
      }
    }
    return group;
  }

  /* Shows the first `drawn` pixels, the row, where its edges are, and the step's pixels. */
  show(drawn, row, pixels) {
    let i = 0;
    for (const cell of this.cells.values()) {
      cell.setAttribute("visibility", i++ < drawn ? "visible" : "hidden");
    }
    this.layers.row.replaceChildren(svg("rect", { x: 0, y: row.y * CELL, width: "100%",
      height: CELL, class: "row" }));
    const marks = [row.left.x, row.right.x].map((x) =>
      line(at(x), (row.y - 0.15) * CELL, at(x), (row.y + 1.15) * CELL, "end"));
    this.layers.now.replaceChildren(...marks);
    if (pixels.length > 0) {
      this.layers.now.append(svg("rect", { x: pixels[0].x * CELL, y: row.y * CELL,
        width: pixels.length * CELL, height: CELL, class: "now" }));
    }
  }
}
