/* The stepper's large figure: a window of the frame, pixel by pixel, the triangle over it, and its
 * three vertices as buttons to drag. */

const MARGIN = 30;          /* CSS pixels for the numbers along the border */
const FIGURE_HEIGHT_MAX = 520;
const CELLS_MAX = 60;       /* CSS pixels a pixel of the frame is at most drawn with */

const HANDLE_AWAY = 26;     /* CSS pixels from a vertex to its handle */
const MARKS_FROM = 5;       /* such a cell has room for a cross */

/* A window of a frame, each texel in one of two colours, in squares of 2^shift where there are
 * many; with errors, a wrong pixel in its error's. Alpha is 0 to 255. Where a cell is smaller than
 * the screen's pixels, some are left out. */
function drawFrame(c, { frame, errors }, { x, y, w, h }, cell, width, shift, alphaOf) {
  const step = Math.max(1, Math.ceil(1 / cell));
  drawPixels(c, (i, j) => {
    const at = (y + j * step) * width + x + i * step, error = errors ? errorAt(errors, at) : 0;
    if (!frame[at] && !error) {
      return 0;
    }
    const odd = (texelU(frame[at]) >> shift) + (texelV(frame[at]) >> shift) & 1;
    const name = error ? errorClass(error) : odd ? "texel-b" : "texel-a";
    return (alphaOf(at) << 24 | pixelOf(name) & 0xFFFFFF) >>> 0;
  }, Math.ceil(w / step), Math.ceil(h / step), cell * step);
}

class Figure {
  constructor(stepper) {
    this.canvas = byId("figure-canvas");
    this.handles = Array.from(document.querySelectorAll(".handle"));
    this.canvas.addEventListener("click", (event) => {
      stepper.pick(...this.toFrame(event).map(Math.round));
    });
    this.canvas.addEventListener("keydown", (event) => stepper.key(event));
    this.handles.forEach((handle, i) => this.listen(stepper, handle, i));
  }

  listen(stepper, handle, i) {
    handle.addEventListener("pointerdown", (event) => {
      const [x, y] = this.toFrame(event);
      handle.setPointerCapture(event.pointerId);
      this.grab = [x - this.given[i].x, y - this.given[i].y];
      this.dragged = i;
    });
    handle.addEventListener("pointermove", (event) => {
      if (this.dragged === i) {
        stepper.move(i, ...this.toFrame(event).map((c, axis) => c - this.grab[axis]));
      }
    });
    handle.addEventListener("lostpointercapture", () => { this.dragged = null; });
    handle.addEventListener("keydown", (event) => {
      const step = (stepper.state.snap === 1 ? 1 : 1 / 16) * (event.shiftKey ? 16 : 1);
      const way = arrow(event), { x, y } = this.given[i];
      if (way) {
        stepper.move(i, x + step * way[0], y + step * way[1]);
      }
    });
  }

  /* The frame's coordinates, pixel centres at integers, on the canvas; and a pointer's there. */
  toCanvas(x, y) {
    return [MARGIN + (x - this.window.x + 0.5) * this.cell,
      MARGIN + (y - this.window.y + 0.5) * this.cell];
  }

  toFrame(event) {
    const box = this.canvas.getBoundingClientRect(), { x, y } = this.window;
    return [(event.clientX - box.left - MARGIN) / this.cell + x - 0.5,
      (event.clientY - box.top - MARGIN) / this.cell + y - 0.5];
  }

  draw(stepper, event) {
    const { state, list, results } = stepper, width = this.canvas.clientWidth || 600;
    const at = (x, y) => this.toCanvas(x, y), { grid } = stageOf(state.stage);
    this.result = results.get(state.stage);
    this.width = state.size[0];
    this.window = stepper.window();
    this.cell = Math.min((width - MARGIN - 8) / this.window.w,
      (FIGURE_HEIGHT_MAX - MARGIN) / this.window.h, CELLS_MAX);
    const [c] = context(this.canvas, Math.ceil(MARGIN + this.window.h * this.cell + 10));
    this.drawCells(c, stepper);
    this.drawGrid(c);
    this.drawMarks(c);
    this.drawStep(c, event);
    list.forEach((piece) => outline(c, cornersOf(piece, grid), at, "ink", 2));
    this.given = cornersOf(state.v, 0);
    outline(c, this.given, at, "accent", 1.5, [5, 4]);
    this.given.forEach((vertex, i) => this.placeHandle(this.handles[i], vertex, "ABC"[i]));
  }

  eachPixel(visit) {
    const { x, y, w, h } = this.window;
    for (let j = y; j < y + h; j++) {
      for (let i = x; i < x + w; i++) {
        visit(i, j, j * this.width + i);
      }
    }
  }

  /* What is drawn at this step, and fainter what is drawn later. */
  drawCells(c, { run, state: { v, at } }) {
    const { frame, errors } = this.result, spread = Math.max(...[3, 4].map((k) =>
      Math.abs(v[k] - v[k + 5]) + Math.abs(v[k] - v[k + 10])));
    c.translate(MARGIN, MARGIN);
    drawFrame(c, { frame, errors: this.cell < MARKS_FROM ? errors : null }, this.window, this.cell,
      this.width, spread > 128 ? 4 : 0, (i) => (run.order.get(i) <= at ? 255 : 90));
    c.translate(-MARGIN, -MARGIN);
  }

  drawGrid(c) {
    const { x, y, w, h } = this.window, cell = this.cell;
    const room = 8 + 8 * String(Math.max(x + w, y + h)).length; /* for a label */
    const every = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].find((n) => n * cell >= room);
    c.font = "11px system-ui, sans-serif";
    for (const [from, count, length, at] of [[x, w, h * cell, (along, across) => [along, across]],
      [y, h, w * cell, (along, across) => [across, along]]]) {
      for (let i = 0; i <= count; i++) {
        const along = MARGIN + i * cell;
        if (cell >= MARKS_FROM) {
          path(c, [at(along, MARGIN), at(along, MARGIN + length)], "line");
        }
        if (i < count && (from + i) % every === 0) {
          label(c, String(from + i), ...at(along + cell / 2, MARGIN / 2));
        }
      }
    }
    label(c, "x", MARGIN / 2, MARGIN / 2);
    if (cell >= 12) {
      this.eachPixel((i, j) => {
        const [cx, cy] = this.toCanvas(i, j);
        c.fillRect(cx - 1, cy - 1, 2, 2);
      });
    }
    border(c, MARGIN, MARGIN, w * cell, h * cell, "soft");
  }

  /* Wrong texels, missing pixels, pixels too many. */
  drawMarks(c) {
    const { errors, frame } = this.result, arm = Math.max(this.cell * 0.22, 1);
    if (!errors || this.cell < MARKS_FROM) {
      return; /* in small cells a colour says it */
    }
    c.font = `bold ${Math.max(this.cell * 0.8, 8)}px system-ui, sans-serif`;
    this.eachPixel((x, y, i) => {
      const error = errorAt(errors, i), [cx, cy] = this.toCanvas(x, y);
      if (error === OTHER_SURFACE) {
        label(c, frame[i] ? "+" : "\u2212", cx, cy, "wrong");
      } else if (error) {
        path(c, [[cx - arm, cy - arm], [cx + arm, cy + arm]], "wrong", 1.5);
        path(c, [[cx - arm, cy + arm], [cx + arm, cy - arm]], "wrong", 1.5);
      }
    });
  }

  drawStep(c, step) {
    const { x, w } = this.window;
    if (!step || step.y === undefined) {
      return;
    }
    const [left, top] = this.toCanvas(x - 0.5, step.y - 0.5);
    c.fillStyle = colour("accent");
    c.globalAlpha = 0.13;
    c.fillRect(left, top, w * this.cell, this.cell);
    c.globalAlpha = 1;
    if (step.x !== undefined) {
      const [cx] = this.toCanvas(step.x - 0.5, step.y);
      border(c, cx, top, this.cell * step.count, this.cell, "now", 3);
    }
    if (step.edge) {
      const [edge, way] = [step.edge, step.path].map((all) => all.map((p) => this.toCanvas(...p)));
      path(c, edge, "now", 6);
      path(c, way, "accent", 3);
      way.forEach((at) => dot(c, at, 5, "accent"));
    }
  }

  placeHandle(handle, vertex, name) {
    const [x, y] = this.toCanvas(vertex.x, vertex.y);
    handle.hidden = !(x >= 0 && y >= 0 && x <= this.canvas.clientWidth &&
      y <= this.canvas.clientHeight);
    const out = ["x", "y"].map((axis) => /* beside the vertex, not on its pixel */
      this.given.reduce((sum, other) => sum + vertex[axis] - other[axis], 0));
    const far = HANDLE_AWAY / (Math.hypot(...out) || 1);
    handle.style.transform = `translate(` +
      `${clamp(x + far * out[0], 17, this.canvas.clientWidth - 17)}px, ` +
      `${clamp(y + far * out[1], 17, this.canvas.clientHeight - 17)}px)`;
    handle.setAttribute("aria-label", `Vertex ${name}: x ${show(vertex.x)}, y ` +
      `${show(vertex.y)}. Arrow keys move it.`);
  }
}
