/* The stages' own C code, as a WebAssembly module: see tests/page/wasm/module.c. */

const EXACT = 7;
const OTHER_SURFACE = 32767;
const SIDE = 256;       /* of every texture */
const TEXTURE_OWN = -1, TEXTURE_BRICKS = 1, TEXTURE_COORD = 4;
const SCENE_ROOM = 0, ROOM_FRAME = 40, ROOM_SIZE = [320, 240]; /* as tests/page/pictures.c */
const FLOATS = 15, WORDS = 16; /* a triangle's: its vertices', and with its texture */
const TRIANGLES_MAX = 64;      /* that can be given */

const STAGES = [
  { number: 1, name: "float", folder: "stage1_float", grid: 0 },
  { number: 2, name: "DDA", folder: "stage2_dda", grid: 1 },
  { number: 3, name: "28.4", folder: "stage3_fixed28_4", grid: 16 },
  { number: 4, name: "subdivide", folder: "stage4_subdivide", grid: 16 },
  { number: 5, name: "assembly", folder: "stage5_asm", grid: 16 },
  { number: 6, name: "coda", folder: "coda", grid: 0 },
  { number: EXACT, name: "exact", folder: "exact", grid: 0 },
];
const stageOf = (number) => STAGES[number - 1];
/* What the module has in the place of a stage: stage 5 has stage 4's bits. */
const standIn = (number) => (number === 5 ? 4 : number);

/* An event of the trace: four words, then as many doubles as it can have. */
const EVENT_WORDS = 4, EVENT_DOUBLES = 12;
const EVENTS_MAX = 50000; /* that a trace keeps */

class Stages {
  static async load() {
    const bytes = Uint8Array.from(atob(byId("module").textContent.replace(/\s/g, "")),
      (c) => c.charCodeAt(0));
    const { instance } = await WebAssembly.instantiate(bytes, {});
    return new Stages(instance.exports);
  }

  constructor(wasm) {
    this.wasm = wasm;
  }

  /* An array in the module's memory; it is gone when the memory grows. */
  array(Type, address, length) {
    return new Type(this.wasm.memory.buffer, address, length);
  }

  /* A frame's size, and how many pixels stage 4 divides once for. */
  open([width, height], segmentLength = 16) {
    if (!this.wasm.page_open(width, height)) {
      throw new Error("no memory for the frame");
    }
    this.wasm.page_segment_length(segmentLength);
    Object.assign(this, { width, height });
  }

  /* Takes triangles of fifteen numbers each, clipped; returns the list of them. */
  give(triangles) {
    const given = this.array(Float32Array, this.wasm.page_given(), WORDS * triangles.length);
    triangles.forEach((triangle, k) => given.set(triangle, WORDS * k));
    return this.list(this.wasm.page_triangles(triangles.length));
  }

  /* Takes those of the room instead, all or only those with one texture. */
  room(frame, shiftX, shiftY, texture = TEXTURE_OWN) {
    return this.list(this.wasm.page_scene(SCENE_ROOM, frame, shiftX, shiftY, texture));
  }

  list(count) {
    const all = count ? this.array(Float32Array, this.wasm.page_list(), WORDS * count) : [];
    return Array.from({ length: count },
      (_, k) => Array.from(all.slice(WORDS * k, WORDS * k + FLOATS)));
  }

  /* A frame's pixels, 0xAARRGGBB, row by row: a copy. */
  draw(stage, texture = TEXTURE_COORD) {
    return this.array(Uint32Array, this.wasm.page_draw(standIn(stage), texture),
      this.width * this.height).slice();
  }

  /* Before the first measurement of these triangles. False where the frame is too large. */
  measurable() {
    return this.width * this.height <= 1 << 21 && this.wasm.page_measurable() !== 0;
  }

  /* How a stage errs: counts, texels as frame, errors in u and v pixel by pixel. */
  measure(stage) {
    return this.counts(this.wasm.page_measure(standIn(stage)));
  }

  /* By stage, how it errs; only its frame where the frame is too large, and of the exact answer. */
  results() {
    const measured = this.measurable();
    return new Map([...STEPPED, EXACT].map((n) => [n, measured && n !== EXACT ? this.measure(n)
      : { frame: this.draw(n), errors: null }]));
  }

  /* The same of a frame that was drawn elsewhere, for the coda and stage 5. */
  compare(stage, pixels) {
    this.wasm.page_measure(stage === 6 ? EXACT : 4);
    const size = this.width * this.height;
    this.array(Uint32Array, this.wasm.page_frame(), size).set(pixels);
    return this.counts(this.wasm.page_compare());
  }

  counts(address) {
    const size = this.width * this.height;
    const [pixels, wrong, largest, missing, extra] = this.array(Int32Array, address, 5);
    return { pixels, wrong, largest, missing, extra,
      frame: this.array(Uint32Array, this.wasm.page_frame(), size).slice(),
      errors: this.array(Int16Array, this.wasm.page_errors(), 2 * size).slice() };
  }

  /* What is exact at a pixel that the exact answer draws, for u, then v: the coordinate, its texel,
   * and how far from that, 1 or -1, lies another that is right too. */
  exactAt(x, y) {
    const at = this.wasm.page_places() + 16 * (y * this.width + x);
    const words = this.array(Int16Array, at, 8), floats = this.array(Float32Array, at, 4);
    return [0, 1].map((axis) => ({ at: words[4 * axis] - floats[2 * axis + 1],
      texel: words[4 * axis], other: words[4 * axis + 1] }));
  }

  /* What a stage does with triangle k, event by event: kind, source line, pixel (counted from the
   * frame's first, row by row), and the values by the names that the recorder gives them. */
  trace(stage, k) {
    const count = Math.min(this.wasm.page_trace(stage, k), EVENTS_MAX);
    const address = this.wasm.page_events(), frame = this.wasm.page_frame();
    const size = EVENT_WORDS / 2 + EVENT_DOUBLES; /* in doubles */
    const words = this.array(Int32Array, address, 2 * size * count);
    const doubles = this.array(Float64Array, address, size * count).slice();
    const names = KINDS.map((_, kind) => this.text(this.wasm.page_event_names(stage, kind))
      .split(" "));
    return Array.from({ length: count }, (_, i) => {
      const [kind, line, address] = words.subarray(2 * size * i), from = size * i + EVENT_WORDS / 2;
      return { kind, line, pixel: (address - frame) / 4, get v() { /* most are never asked for */
        return Object.fromEntries(names[kind].map((name, k) => [name, doubles[from + k]]));
      } };
    });
  }

  /* Divides, conversions, multiplications, additions of a run up to step `last`. */
  costs({ stage, events }, last) {
    const each = KINDS.map((_, kind) => this.array(Uint8Array,
      this.wasm.page_event_costs(stage, kind), 4));
    return [0, 1, 2, 3].map((i) => events.slice(0, last + 1)
      .reduce((sum, { kind }) => sum + each[kind][i], 0));
  }

  /* A string of C's. */
  text(address) {
    const bytes = new Uint8Array(this.wasm.memory.buffer, address);
    return String.fromCharCode(...bytes.subarray(0, bytes.indexOf(0)));
  }
}

/* Where a stage puts a coordinate that gives vertices `grid` places a pixel; 0: as it is given. */
const placeOn = (grid) => (c) => (grid ? Math.floor(c * grid + 0.5) / grid : c);

/* A triangle's corners there. */
function cornersOf(triangle, grid) {
  const place = placeOn(grid);
  return [0, 5, 10].map((i) => ({ x: place(triangle[i]), y: place(triangle[i + 1]),
    z: triangle[i + 2], u: triangle[i + 3], v: triangle[i + 4] }));
}

const texelU = (pixel) => pixel >> 16 & 0xFF;
const texelV = (pixel) => pixel >> 8 & 0xFF;

/* A pixel's error in texels, the larger of both axes; OTHER_SURFACE where coverage differs. */
const errorAt = (errors, i) => Math.max(Math.abs(errors[2 * i]), Math.abs(errors[2 * i + 1]));

/* In words. */
function verdict(m) {
  const coverage = [m.missing ? `${m.missing} missing` : "", m.extra ? `${m.extra} too many` : ""]
    .filter(Boolean).join(", ");
  return `${m.wrong} of ${plural(m.pixels, "texel")} wrong` +
    (m.largest > 1 ? `, by up to ${m.largest}` : "") + (coverage ? `; ${coverage}` : "");
}
