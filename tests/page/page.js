/* Brings the page to life. What goes wrong is said on the page, not only in the console. */

function fault(what) {
  byId("broken").textContent ||= `This page does not work as it should here: ${what}`;
  byId("broken").hidden = false;
}

addEventListener("error", (event) => fault(event.message));
addEventListener("unhandledrejection", (event) => fault(event.reason));

async function start() {
  document.documentElement.classList.add("script");
  const page = { stages: await Stages.load() };
  page.cases = new Cases(await Stages.load()); /* each with memory of its own */
  page.stepper = new Stepper(page.stages, page.cases);
  page.ready = performance.now();
  page.swim = new Swim(await Stages.load());
  const { recordings, missing } = JSON.parse(byId("lanes-data").textContent);
  byId("lanes").hidden = Boolean(missing);
  byId("lanes-missing").textContent = missing ? `There is no recording: ${missing}.` : "";
  page.lanes = recordings && new Lanes(recordings);
  page.pictures = await Pictures.load(await Stages.load());
  addEventListener("hashchange", () => Address.read());
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    Object.keys(colours).forEach((name) => delete colours[name]);
    dispatchEvent(new Event("resize"));
  });
  Address.read();
  page.loaded = true;
  window.page = page; /* for tests, and for curious readers */
}

start();
