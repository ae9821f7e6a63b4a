// Plots by Observable Plot, as SVG: they print, and take the page's colours.
import * as Plot from "@observablehq/plot";

const JawNames = { upper: "Upper jaw", lower: "Lower jaw" };
const width = element => Math.max(320, Math.min(560, element.clientWidth || 560));

/** One row a point of the tracing, along it: teeth one after the other with a gap between. */
function residualRows(tracing) {
  const rows = [];
  let place = 0;
  for (const stretch of tracing) {
    let last = null;
    stretch.points.forEach(([u, v], i) => {
      if (last) place += Math.hypot(u - last[0], v - last[1]);
      last = [u, v];
      const distance = stretch.distance_px?.[i];
      if (typeof distance === "number") rows.push({ place, distance, tooth: stretch.tooth });
    });
    place += 8;
  }
  return rows;
}

function drawResiduals(element, data) {
  const views = data.details?.views ?? [];
  let chosen = null;
  const draw = () => {
    element.replaceChildren();
    for (const view of views)
      for (const [jaw, drawing] of Object.entries(view.jaws)) {
        const rows = residualRows(drawing.tracing ?? []);
        if (!rows.length) continue;
        const teeth = [...new Set(rows.map(row => row.tooth))].map(tooth => {
          const own = rows.filter(row => row.tooth === tooth);
          return { tooth, from: own[0].place, to: own[own.length - 1].place, middle: (own[0].place + own[own.length - 1].place) / 2 };
        });
        const on = tooth => chosen !== null && chosen.jaw === jaw && chosen.tooth === tooth;
        const plot = Plot.plot({
          width: width(element), height: 200, marginBottom: 34, marginLeft: 44, style: { fontSize: "11px" },
          ariaLabel: `${JawNames[jaw] ?? jaw}: distance of the tracing from the outline, along the tracing`,
          x: { label: null, ticks: [], domain: [rows[0].place, rows[rows.length - 1].place] },
          y: { label: "distance, px", grid: true, domain: [0, Math.max(4, ...rows.map(row => row.distance))] },
          marks: [
            Plot.rectX(teeth, { x1: "from", x2: "to", fill: "currentColor", fillOpacity: tooth => (on(tooth.tooth) ? 0.22 : 0.06) }),
            Plot.areaY(rows, { x: "place", y: "distance", z: "tooth", fill: "var(--accent)", fillOpacity: 0.25 }),
            Plot.lineY(rows, { x: "place", y: "distance", z: "tooth", stroke: "var(--accent)", strokeWidth: 1.6 }),
            Plot.ruleY([0]),
            Plot.text(teeth, { x: "middle", frameAnchor: "bottom", dy: 12, text: tooth => tooth.tooth || "?", fontWeight: tooth => (on(tooth.tooth) ? 700 : 400), rotate: teeth.length > 10 ? -60 : 0, textAnchor: teeth.length > 10 ? "end" : "middle" }),
            Plot.tip(rows, Plot.pointerX({ x: "place", y: "distance", title: row => `${row.tooth || "?"}: ${row.distance.toFixed(2)} px` })),
          ],
        });
        plot.addEventListener("click", () => {
          if (plot.value) document.dispatchEvent(new CustomEvent("choose-tooth", { detail: { jaw, tooth: plot.value.tooth } }));
        });
        const figure = document.createElement("figure");
        const title = document.createElement("h3");
        title.textContent = JawNames[jaw] ?? jaw;
        figure.append(title, plot);
        element.append(figure);
      }
  };
  document.addEventListener("tooth", event => { chosen = event.detail; draw(); });
  draw();
}

/** How far each step moved the outline, or the value where the method does not know. Values of one candidate are not one
 * curve: kernel width and noise, of which they are, change from step to step. */
function drawCourse(element, data) {
  for (const group of data.details?.course ?? []) {
    const rows = [];
    const lengths = group.stages.some(stage => stage.candidates.some(candidate => candidate.length_px.some(length => length > 0)));
    for (const stage of group.stages)
      for (const candidate of stage.candidates)
        candidate.value.forEach((value, i) => rows.push({
          stage: stage.stage, candidate: candidate.candidate, step: i + 1, value, chosen: candidate.chosen,
          accepted: candidate.accepted[i] === 1, length: candidate.length_px[i], width: candidate.width_px[i],
        }));
    const shown = lengths ? rows.filter(row => row.length > 0) : rows;
    if (!shown.length) continue;
    const y = lengths ? "length" : "value";
    const narrow = (element.clientWidth || 900) < 600;
    const stages = group.stages.map(stage => stage.stage);
    const plot = Plot.plot({
      width: Math.max(320, Math.min(1100, element.clientWidth || 900)), height: narrow ? 170 * stages.length : 260,
      marginLeft: 54, marginRight: narrow ? 84 : 20, style: { fontSize: "11px" },
      ariaLabel: "Steps of each candidate by stage",
      [narrow ? "fy" : "fx"]: { domain: stages, label: null },
      x: { label: "step", ticks: 5 }, y: { label: lengths ? "how far the step moves the outline, px of 0.25 mm" : "value", type: lengths ? "log" : "linear", grid: true, ticks: 4, tickFormat: value => String(Number(value.toPrecision(2))) },
      marks: [
        Plot.line(shown, { [narrow ? "fy" : "fx"]: "stage", x: "step", y, z: "candidate", stroke: "currentColor", strokeOpacity: row => (row.chosen ? 0 : 0.28), filter: row => !row.chosen }),
        Plot.line(shown, { [narrow ? "fy" : "fx"]: "stage", x: "step", y, z: "candidate", stroke: "var(--accent)", strokeWidth: 2.4, filter: row => row.chosen }),
        Plot.dot(shown, { [narrow ? "fy" : "fx"]: "stage", x: "step", y, filter: row => row.chosen, r: 4, stroke: "var(--accent)", fill: row => (row.accepted ? "var(--accent)" : "var(--back)") }),
        Plot.tip(shown, Plot.pointer({ [narrow ? "fy" : "fx"]: "stage", x: "step", y, filter: row => row.chosen,
          title: row => `step ${row.step}, ${row.accepted ? "accepted" : "rejected"}\nvalue ${row.value.toPrecision(4)}${lengths ? `\nmoves ${row.length.toPrecision(3)} px` : ""}${row.width ? `\nkernel ${row.width.toPrecision(3)} px` : ""}` })),
        Plot.frame({ strokeOpacity: 0.25 }),
      ],
    });
    const figure = document.createElement("figure");
    const title = document.createElement("h3");
    title.textContent = group.jaws.length > 1 ? "Both jaws" : JawNames[group.jaws[0]] ?? group.jaws[0];
    const caption = document.createElement("p");
    caption.className = "caption";
    caption.textContent = "Blue: the way that led to the result, full dots accepted steps, hollow ones rejected; grey: the other candidates.";
    figure.append(title, plot, caption);
    element.append(figure);
  }
}

export function drawPlots(data) {
  const residuals = document.getElementById("plot-residuals");
  if (residuals) drawResiduals(residuals, data);
  const course = document.getElementById("plot-course");
  if (course) drawCourse(course, data);
}
