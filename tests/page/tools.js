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
  c.lineWidth = 1;
  c.setLineDash([]);
  return [c, width];
}

function line(c, x1, y1, x2, y2, stroke, width = 1, dash = []) {
  c.beginPath();
  c.moveTo(x1, y1);
  c.lineTo(x2, y2);
  c.strokeStyle = stroke;
  c.lineWidth = width;
  c.setLineDash(dash);
  c.stroke();
}

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

/* A group of buttons of which one is pressed. */
class Choice {
  constructor(id, choices, chosen) {
    this.buttons = new Map();
    for (const [value, label] of choices) {
      const button = element("button", { type: "button", "aria-pressed": "false" }, label);
      button.addEventListener("click", () => chosen(value));
      byId(id).append(button);
      this.buttons.set(String(value), button);
    }
  }

  press(value) {
    for (const [own, button] of this.buttons) {
      button.setAttribute("aria-pressed", String(own === String(value)));
    }
  }
}

/* Plays: calls `step` so many times a second, until it returns false or the button is pressed. */
class Player {
  constructor(id, step, perSecond) {
    this.button = byId(id);
    this.words = this.button.textContent;
    this.step = step;
    this.perSecond = perSecond;
    this.button.addEventListener("click", () => (this.timer ? this.stop() : this.play()));
  }

  play() {
    const tick = () => {
      this.timer = setTimeout(tick, 1000 / this.perSecond());
      if (this.step() === false) {
        this.stop();
      }
    };
    this.button.textContent = "Pause";
    this.timer = setTimeout(tick, 0);
  }

  stop() {
    clearTimeout(this.timer);
    this.timer = null;
    this.button.textContent = this.words;
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
 *   assembly  recording=0..  at=STEP
 *
 * What is left out stays as it is when the page opens. */
const Address = {
  parts: {},

  /* `state()` gives an object, `open(object of strings)` takes one. */
  part(name, state, open) {
    this.parts[name] = { state, open };
  },

  write(name) {
    if (!this.ready) {
      return; /* what the page was opened with is still to be read */
    }
    const pairs = Object.entries(this.parts[name].state())
      .filter(([, value]) => value !== null && value !== undefined && value !== "")
      .map(([key, value]) => `${key}=${encodeURI(value)}`);
    clearTimeout(this.timer); /* browsers refuse more than a few addresses a second */
    this.timer = setTimeout(() => history.replaceState(null, "", `#${name}?${pairs.join("&")}`),
      300);
  },

  read() {
    this.ready = true;
    const [name, query] = location.hash.slice(1).split("?");
    if (!this.parts[name] || query === undefined) {
      return false; /* none, or one whose part is not there yet */
    }
    this.parts[name].open(Object.fromEntries(new URLSearchParams(query)));
    byId(name).scrollIntoView();
    return true;
  },
};
