/* The stability table. Each cell opens its case: the number, what it should be and why, a window of
 * the stage's frame beside the exact answer, and the file that draws it. */

/* Few digits, so that a row fits a phone: a case tells more when it is open. */
function brief(value) {
  return value !== null && Math.abs(value) >= 10 ? show(Math.round(value * 10) / 10)
    : show(value, 2);
}

class Cases {
  constructor() {
    this.data = dataOf("cases");
    if (!this.data) {
      byId("cases-says").textContent = "Not measured: texmap report was not run in the project's "
        + "folder, where tests/cases/ lies.";
      return;
    }
    byId("cases-says").textContent = "The smallest cases in which a method fails, measured anew "
      + "for this page. Green holds what the stage promises; orange fails as it should, by about "
      + "as much as is expected; red would be a surprise. A cell opens its case.";
    this.showTable();
  }

  stageName(index) {
    const name = this.data.stages[index];
    return name.startsWith("stage") ? `stage ${name[5]}` : name;
  }

  showTable() {
    const { stages, rows } = this.data;
    const names = ["case", ...stages.map((_, i) => this.stageName(i))];
    const heading = element("tr", {}, ...names.map((name) =>
      element("th", { scope: "col" }, name)));
    byId("cases-table").tHead.append(heading);
    byId("cases-table").tBodies[0].append(...rows.map((row) => element("tr", {},
      element("th", { scope: "row" }, row.name, element("div", { class: "soft" },
        `${row.what}, ${row.unit}`)),
      ...row.cells.map((cell, i) => element("td", {}, this.button(row, cell, i))))));
  }

  button(row, cell, index) {
    const says = `${row.name}, ${this.stageName(index)}: ${show(cell.value, 3)} ${row.unit}, `
      + cell.verdict;
    const button = element("button", { class: cell.verdict.split(" ")[0], "aria-label": says },
      brief(cell.value));
    button.addEventListener("click", () => {
      this.opened = this.open(row, cell, index);
    });
    return button;
  }

  async open(row, cell, index) {
    const expected = { holds: `at most ${show(cell.amount, 3)} expected`,
      fails: `about ${show(cell.amount, 3)} expected`,
      unexpected: `${show(cell.amount, 3)} expected` }[cell.verdict];
    const why = expected ? `: ${expected}, because ${row.reason}` : "";
    byId("case-title").textContent = `${row.name}: ${this.stageName(index)}`;
    byId("case-says").textContent = `${row.what}: ${show(cell.value, 4)} ${row.unit}, `
      + `${cell.verdict}${why}.`;
    byId("case-file").textContent = row.file;
    byId("case-file").hidden = row.file === "";
    byId("case-command").textContent = `build/texmap render --stage ${this.data.stages[index]} `
      + `${row.source} --size ${row.size} -o case.png`;
    byId("case").showModal();
    const texels = await unpack(row.texels);
    byId("case-views").replaceChildren(
      this.view(row, texels, this.stageName(index), index, null),
      this.view(row, texels, "exact answer", this.data.stages.length, null),
      this.view(row, texels, "texels apart", index, this.data.stages.length));
  }

  /* A pixel of the window: [u, v], or null where nothing was drawn. */
  texel(texels, frame, pixel) {
    const size = this.data.width * this.data.height;
    const [u, v, drawn] = [0, 1, 2].map((plane) => texels[(3 * frame + plane) * size + pixel]);
    return drawn ? [u, v] : null;
  }

  /* Texels as colours: u reddens, v greens, and every second texel is darker. */
  colour(texel) {
    const light = texel && (texel[0] + texel[1]) & 1 ? 1 : 0.72;
    return texel ? [(80 + texel[0] * 0.68) * light, (80 + texel[1] * 0.68) * light, 150 * light]
      : [0, 0, 0];
  }

  /* One frame, or how far it is from another. */
  view(row, texels, name, frame, other) {
    const { width, height } = this.data;
    const canvas = element("canvas", { width, height, role: "img", "aria-label": name });
    const context = canvas.getContext("2d");
    const image = context.createImageData(width, height);
    for (let pixel = 0; pixel < width * height; pixel++) {
      const texel = this.texel(texels, frame, pixel);
      let colour = this.colour(texel);
      if (other !== null) {
        const apart = this.apart(texel, this.texel(texels, other, pixel));
        colour = apart ? distanceColour(apart) : colour.map((channel) => channel / 4);
      }
      image.data.set([...colour, 255], 4 * pixel);
    }
    context.putImageData(image, 0, 0);
    const says = `${name}: pixels ${row.x}, ${row.y} to ${row.x + width - 1}, `
      + `${row.y + height - 1}`;
    return element("figure", {}, canvas, element("figcaption", {}, says));
  }

  apart(a, b) {
    if (!a || !b) {
      return a || b ? OTHER_SURFACE : 0;
    }
    return Math.max(...a.map((value, axis) => Math.abs(wrapped(value, b[axis], 256))));
  }
}
