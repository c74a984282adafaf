/* What all parts of the page use. */

function byId(id) {
  return document.getElementById(id);
}

/* What the program wrote for a part of the page. */
function dataOf(id) {
  return JSON.parse(byId(id).textContent);
}

/* Bytes that the program packed: zlib, in base64. */
async function unpack(base64) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/* An element with attributes and children; strings become text. */
function element(name, attributes = {}, ...children) {
  return dress(document.createElement(name), attributes, children);
}

function svg(name, attributes = {}, ...children) {
  return dress(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
}

function dress(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    node.setAttribute(key, value);
  }
  node.append(...children);
  return node;
}

/* A number for people: up to `digits` significant ones; a dash where the stage has none. */
function show(value, digits = 6) {
  if (value === null || value === undefined) {
    return "\u2013";
  }
  const small = value !== 0 && Math.abs(value) < 0.001;
  const text = Number.isInteger(value) ? String(value)
    : small ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
  return text.replaceAll("-", "\u2212");
}

/* A row of a table: a heading, then cells; a cell is text or [text, class]. */
function tableRow(heading, cells, className = "") {
  const row = element("tr", className ? { class: className } : {}, element("th", { scope: "row" },
    heading));
  for (const cell of cells) {
    const [text, name] = Array.isArray(cell) ? cell : [cell, ""];
    row.append(element("td", name ? { class: name } : {}, text));
  }
  return row;
}

/* From one texel to another where the texture repeats after `side` texels: the shorter way. */
function wrapped(from, to, side) {
  return ((to - from + side / 2) & (side - 1)) - side / 2;
}

/* A points or d attribute's numbers, no longer than the eye needs. */
function round(value) {
  return Math.round(value * 100) / 100;
}

function polyline(points, className) {
  return svg("polyline", {
    points: points.map(([x, y]) => `${round(x)},${round(y)}`).join(" "), class: className,
  });
}

function line(x1, y1, x2, y2, className) {
  return svg("line", { x1: round(x1), y1: round(y1), x2: round(x2), y2: round(y2),
    class: className });
}

function text(x, y, content, anchor = "start", className = "") {
  return svg("text", { x: round(x), y: round(y), "text-anchor": anchor, class: className },
    content);
}
