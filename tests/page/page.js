/* Brings the page to life. What goes wrong is said on the page, not only in the console. */

const faults = [];

function fault(what) {
  faults.push(String(what));
  byId("broken").hidden = false;
  byId("broken").textContent = `This page does not work as it should here: ${faults[0]}`;
}

addEventListener("error", (event) => fault(event.message));
addEventListener("unhandledrejection", (event) => fault(event.reason));

async function start() {
  document.documentElement.classList.add("script");
  const page = { stages: await Stages.load() };
  page.cases = new Cases(page.stages);
  page.stepper = new Stepper(page.stages, page.cases);
  const found = Address.read();
  page.ready = performance.now();
  page.swim = new Swim(await Stages.load()); /* memory of its own: it runs beside the stepper */
  page.lanes = new Lanes();
  page.pictures = new Pictures(await Stages.load());
  await page.pictures.load();
  addEventListener("hashchange", () => Address.read());
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    Object.keys(colours).forEach((name) => delete colours[name]);
    dispatchEvent(new Event("resize"));
  });
  if (!found) {
    Address.read();
  }
  page.loaded = true;
  window.page = page; /* for tests, and for curious readers */
}

start();
