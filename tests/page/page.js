/* Brings the page to life, part by part. What goes wrong is said on the page, not only in the
 * console. */

const faults = [];

function fault(what) {
  faults.push(String(what));
  byId("broken").hidden = false;
  byId("broken").textContent = `This page does not work as it should here: ${faults[0]}`;
}

addEventListener("error", (event) => fault(event.message));
addEventListener("unhandledrejection", (event) => fault(event.reason));

async function start() {
  const page = { stepper: new Stepper(), chords: new Chords(), speed: new Speed(),
    cases: new Cases() };
  page.swim = await Swim.load();
  page.panels = new Panels(await Room.load());
  if (location.hash === "#selftest") {
    await selftest(page);
  }
}

start();
