/* What all parts of the page use. */

const byId = (id) => document.getElementById(id);

/* An element with attributes and children; strings become text. */
function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    node.setAttribute(key, value);
  }
  node.append(...children);
  return node;
}

/* A number for people: up to `digits` significant ones, a minus that is one. */
function show(value, digits = 6) {
  if (value === null || value === undefined || Number.isNaN(value)) {
    return "\u2013";
  }
  const tiny = value !== 0 && Math.abs(value) < 0.0001;
  const text = Number.isInteger(value) ? String(value)
    : tiny ? value.toExponential(digits - 2) : String(Number(value.toPrecision(digits)));
  return text.replace(/-/g, "\u2212");
}

const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const plural = (count, thing) => `${count} ${thing}${count === 1 ? "" : "s"}`;

/* A colour of page.css. */
const colours = {};
function colour(name) {
  if (!colours[name]) {
    colours[name] = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  }
  return colours[name];
}

/* A canvas's context, in CSS pixels, cleared, as sharp as the screen. */
function context(canvas, height) {
  const width = canvas.clientWidth || 300, ratio = devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.height = `${height}px`;
  }
  const c = canvas.getContext("2d");
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.clearRect(0, 0, width, height);
  c.font = "12px system-ui, sans-serif";
  c.textBaseline = "middle";
  return [c, width];
}

/* What is drawn into it, in colours of page.css: a line through points, a box's border, a text. */
function path(c, points, stroke, width = 1, dash = []) {
  c.beginPath();
  points.forEach(([x, y]) => c.lineTo(x, y));
  c.strokeStyle = colour(stroke);
  c.lineWidth = width;
  c.setLineDash(dash);
  c.stroke();
}

function border(c, x, y, w, h, stroke, width = 1) {
  c.strokeStyle = colour(stroke);
  c.lineWidth = width;
  c.setLineDash([]);
  c.strokeRect(x, y, w, h);
}

function label(c, text, x, y, fill = "soft", align = "center") {
  c.fillStyle = colour(fill);
  c.textAlign = align;
  c.fillText(text, x, y);
}

function dot(c, [x, y], radius, fill) {
  c.fillStyle = colour(fill);
  c.beginPath();
  c.arc(x, y, radius, 0, 7);
  c.fill();
}

/* A triangle's outline, of points {x, y} that `at` puts on the canvas. */
const outline = (c, [first, ...others], at, stroke, width, dash) =>
  path(c, [first, ...others, first].map(({ x, y }) => at(x, y)), stroke, width, dash);

/* Pixels 0xAARRGGBB, one by one, so that each is sharp. */
function drawPixels(c, pixelAt, w, h, cell) {
  const image = new ImageData(w, h), bytes = new Uint32Array(image.data.buffer);
  for (let i = 0; i < w * h; i++) {
    bytes[i] = swapped(pixelAt(i % w, Math.floor(i / w)));
  }
  const canvas = drawPixels.canvas ||= document.createElement("canvas");
  canvas.width = w;
  canvas.height = h;
  canvas.getContext("2d").putImageData(image, 0, 0);
  c.imageSmoothingEnabled = false;
  c.drawImage(canvas, 0, 0, w * cell, h * cell);
}

/* From 0xAARRGGBB to the order of a canvas's bytes: R first. */
const swapped = (pixel) => pixel & 0xFF00FF00 | (pixel & 0xFF) << 16 | pixel >>> 16 & 0xFF;

/* A colour of page.css, #rrggbb there, as 0xAARRGGBB. */
const pixelOf = (name) =>
  (colours[`${name} pixel`] ||= (0xFF000000 | parseInt(colour(name).slice(1), 16)) >>> 0);

/* Calls `draw` once before the next frame that is shown, however often it is asked for. */
function later(draw) {
  let asked = false;
  return () => {
    if (!asked) {
      asked = true;
      requestAnimationFrame(() => { asked = false; draw(); });
    }
  };
}

/* The way of an arrow key, which then does nothing else; none for other keys. */
function arrow(event) {
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1],
    ArrowDown: [0, 1] }[event.key];
  if (way) {
    event.preventDefault();
  }
  return way;
}

/* What a value in a part's state may be: `first` it has when the page opens, `read` makes one of a
 * text, undefined of nonsense. */
const whole = (first, low, high) => ({ first, read: (text) =>
  (text.trim() && isFinite(text) ? clamp(Math.round(text), low, high) : undefined) });
const oneOf = (first, labels) => ({ first, labels,
  read: (text) => labels.map(([value]) => value).find((value) => String(value) === text) });
const several = (first, sign, low, high) => ({ first, sign, read: (text) => {
  const all = text.split(sign).map(Number);
  return all.length === first.length && all.every((n) => n >= low && n <= high) ? all : undefined;
} });

/* A part of the page, section #NAME: its state, and the controls that show and change it. A control
 * has data-state="KEY": an input, a select, or a span that gets a button for each value; data-log:
 * a slider of powers of two. A button with data-go="METHOD" calls that with its data-by. */
class Part {
  constructor(name, fields) {
    Object.assign(this, { name, fields, section: byId(name), drawSoon: later(() => {
      this.showState();
      this.draw();
    }) });
    this.state = Object.fromEntries(Object.entries(fields).map(([key, { first }]) => [key, first]));
    this.controls = Array.from(this.section.querySelectorAll("[data-state]"));
    this.controls.forEach((control) => this.bind(control));
    for (const button of this.section.querySelectorAll("[data-go]")) {
      button.addEventListener("click", () => this[button.dataset.go](Number(button.dataset.by)));
    }
    addEventListener("resize", this.drawSoon);
    Address.parts[name] = this;
  }

  bind(control) {
    const { state: key, log } = control.dataset, { labels = [], read } = this.fields[key];
    const group = control.matches("span");
    control.append(...labels.map(([value, label]) =>
      element(group ? "button" : "option", group ? { value, type: "button" } : { value }, label)));
    control.addEventListener(group ? "click" : "input", ({ target }) => {
      const text = target.type === "checkbox" ? String(Number(target.checked))
        : log === undefined ? target.value : String(2 ** target.value);
      const value = read(text);
      if (value !== undefined) {
        this.set({ [key]: value });
      }
    });
  }

  showState() {
    for (const control of this.controls) {
      const key = control.dataset.state, value = this.state[key];
      const { labels, says } = this.fields[key];
      if (control.matches("span")) {
        Array.from(control.children).forEach((button, i) =>
          button.setAttribute("aria-pressed", String(labels[i][0] === value)));
      } else if (control.type === "checkbox") {
        control.checked = value;
      } else {
        control.value = control.dataset.log === undefined ? value : Math.log2(value);
      }
      if (says) {
        control.nextElementSibling.textContent = says(value);
      }
    }
  }

  set(change) {
    Object.assign(this.state, change);
    Address.write(this);
    this.drawSoon();
  }

  /* Takes what an address says, as texts. */
  open(wanted) {
    this.set(Object.fromEntries(Object.entries(this.fields).map(([key, { first, read }]) =>
      [key, wanted[key] === undefined ? first : read(wanted[key]) ?? first])));
  }

  /* What an address says: all that is not as at first. */
  address() {
    return Object.entries(this.fields).filter(([key, { first }]) => this.state[key] !== first)
      .map(([key, { sign }]) => [key, sign ? this.state[key].join(sign) : this.state[key]]);
  }

  step(way) {
    this.go(this.state.at + way);
  }

  /* False at the end. */
  next() {
    const { at } = this.state;
    this.step(1);
    return this.state.at > at;
  }

  /* Calls next() so many times a second, until it returns false or the button is pressed again. */
  play() {
    const tick = () => {
      this.timer = setTimeout(tick, 1000 / (this.state.speed || 8));
      if (this.next() === false) {
        this.play();
      }
    };
    this.playing = !this.playing;
    this.section.querySelector("[data-go=play]").textContent = this.playing ? "Pause" : "Play";
    clearTimeout(this.timer);
    if (this.playing) {
      this.timer = setTimeout(tick, 0);
    }
  }
}

/* The page's address holds what it shows: index.html#PART?NAME=VALUE&... A lesson links to it.
 *
 *   step      stage=1..4  at=STEP or pixel=X,Y  length=4..4096 (a segment's)  snap=0|1|16
 *             case=NAME (of tests/cases/, without .tri) and triangle=K, or
 *             size=WxH and v=x,y,z,u,v,x,y,z,u,v,x,y,z,u,v; before=1: the stage before beside it
 *   swim      frame=0..127  direction=right|down|both  speed=FRAMES_A_SECOND
 *   pictures  stage=1..7  with=1..7  mode=one|blink|swipe  show=picture|error
 *             zoom=1..16  at=X,Y
 *   assembly  recording=0|1|2  at=INSTRUCTION
 *   cases     case=NAME
 *
 * What is left out stays as it is when the page opens. */
const Address = {
  parts: {},

  write(part) {
    if (!this.ready) {
      return; /* what the page was opened with is still to be read */
    }
    const pairs = part.address().map(([key, value]) => `${key}=${encodeURI(value)}`);
    clearTimeout(this.timer); /* browsers refuse more than a few addresses a second */
    this.timer = setTimeout(() =>
      history.replaceState(null, "", `#${part.name}?${pairs.join("&")}`), 300);
  },

  read() {
    const [name, query] = location.hash.slice(1).split("?");
    this.ready = true;
    if (this.parts[name] && query !== undefined) {
      this.parts[name].open(Object.fromEntries(new URLSearchParams(query)));
      byId(name).scrollIntoView();
    }
  },
};
