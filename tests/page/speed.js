/* The chart, and its numbers as a table. */

class Speed {
  constructor() {
    const { chart, rows, machine, size, rounds } = dataOf("speed");
    byId("chart").src = chart;
    byId("speed-says").textContent = "Measured for a few seconds while this page was made, "
      + `${size}, ${rounds} rounds: trust ratios, not times. make bench takes longer. `
      + `${machine.trim().replaceAll("\n", "; ")}.`;
    byId("speed-table").tBodies[0].append(...rows.map((row) => tableRow(row.scene, [row.stage,
      show(row.ns_per_pixel, 3), show(row.wrong_texel_pct, 3), show(row.position_rms, 3)])));
  }
}
