/* The cases in which a method fails. C writes each as an article with its triangles; here their
 * frames are drawn, once one is opened. */

class Cases extends Part {
  constructor(stages) {
    const articles = Array.from(document.querySelectorAll(".case"));
    super("cases", { case: oneOf("", articles.map(({ dataset: { name } }) => [name, name])) });
    this.stages = stages;
    this.all = new Map(articles.map((article) => [article.dataset.name, this.parse(article)]));
    for (const article of articles) {
      article.addEventListener("toggle", () => {
        if (article.open) {
          this.drawCase(article);
          this.set({ case: article.dataset.name });
        }
      });
    }
  }

  open(wanted) {
    super.open(wanted);
    const article = byId(`case-${this.state.case}`);
    if (article) {
      article.open = true;
      requestAnimationFrame(() => article.scrollIntoView());
    }
  }

  draw() {} /* a case is drawn once it is opened */

  /* Its triangles: fifteen numbers each. */
  parse(article) {
    const numbers = article.querySelector(".tri").textContent.trim().split(/\s+/).map(Number);
    return { size: article.dataset.size.split("x").map(Number),
      triangles: Array.from({ length: numbers.length / FLOATS },
        (_, k) => numbers.slice(FLOATS * k, FLOATS * k + FLOATS)) };
  }

  drawCase(article) {
    const { size, triangles } = this.all.get(article.dataset.name), { stages } = this;
    const place = article.querySelector(".views");
    if (place.childElementCount) {
      return;
    }
    stages.open(size);
    stages.give(triangles.slice(0, TRIANGLES_MAX));
    for (const [n, result] of stages.results()) {
      const name = n === EXACT ? "Exact" : `Stage ${n}`;
      const canvas = element("canvas", { role: "img", "aria-label": name });
      place.append(element("figure", {}, canvas, element("figcaption", {},
        name + (result.errors ? `: ${verdict(result)}` : ""))));
      drawSmall(canvas, result, triangles, size, 240);
    }
  }
}

/* Hardly wider than a pixel? All of it at once would show nothing. */
function thin([x, y, , , , x1, y1, , , , x2, y2]) {
  const [dx, dy] = [x2 - x, y2 - y];
  return Math.abs((x1 - x) * dy - dx * (y1 - y)) < Math.abs(dx) + Math.abs(dy);
}

/* The window of a frame that fits these triangles. */
function fit(triangles, size) {
  const range = (axis) => {
    const all = triangles.flatMap((v) => [v[axis], v[axis + 5], v[axis + 10]]);
    const low = clamp(Math.floor(Math.min(...all)) - 1, 0, size[axis] - 1);
    return [low, clamp(Math.ceil(Math.max(...all)) + 2, low + 1, size[axis])];
  };
  const [x, right] = range(0), [y, bottom] = range(1);
  return { x, y, w: right - x, h: bottom - y };
}
