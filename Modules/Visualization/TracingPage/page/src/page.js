// The page: what a click, a key and a button mean.

const data = JSON.parse(document.getElementById("tracing-data").textContent);
const $ = selector => document.querySelector(selector);
const $$ = selector => [...document.querySelectorAll(selector)];

/** The four that place two jaws, and others that analyses have. */
const LANDMARKS = [["U1_tip", "upper incisal tip"], ["L1_tip", "lower incisal tip"], ["U6_MB", "upper first molar, mesiobuccal cusp"], ["L6_MB", "lower first molar, mesiobuccal cusp"]];
const FURTHER = [["U1_apex", "upper incisor's apex"], ["L1_apex", "lower incisor's apex"], ["U6_mesial", "upper molar's mesial contact"], ["L6_mesial", "lower molar's mesial contact"],
  ["U6_occlusal", "upper molar, middle of the occlusal surface"], ["L6_occlusal", "lower molar, middle of the occlusal surface"], ["U5_cusp", "upper second premolar's buccal cusp"], ["L5_cusp", "lower second premolar's buccal cusp"],
  ["UR6_MB", "upper right molar, mesiobuccal cusp"], ["UL6_MB", "upper left molar, mesiobuccal cusp"], ["LR6_MB", "lower right molar, mesiobuccal cusp"], ["LL6_MB", "lower left molar, mesiobuccal cusp"]];
const CHARTS = {
  permanent: [["UR", "87654321"], ["UL", "12345678"], ["LR", "87654321"], ["LL", "12345678"]],
  primary: [["UR", "EDCBA"], ["UL", "ABCDE"], ["LR", "EDCBA"], ["LL", "ABCDE"]],
  sideless: [["U", "12345678"], ["L", "12345678"]],
};
const TITLES = new Map([...LANDMARKS, ...FURTHER]);
const hasFingers = matchMedia("(pointer: coarse)").matches;

/** What the next click does, in the words of what is chosen. */
function makeHint() {
  const click = hasFingers ? "Tap" : "Click";
  if (mode === "landmark") return `${click} ${landmark}${TITLES.has(landmark) ? `, the ${TITLES.get(landmark)}` : ""}. Drag a cross to mend it.`;
  if (mode === "outline")
    return tooth ? `${click} along the outline of ${tooth}; ${hasFingers ? "Next tooth" : "Enter"} ends it, a ${click.toLowerCase()} on its first point closes it.` : "Choose a tooth in the chart.";
  if (chosen?.kind === "draft") return `Draft of ${chosen.code}: take it where it lies on the crown, then drag what lies beside it.`;
  if (chosen?.kind === "contour" && chosen.contour.drafted) return `${chosen.contour.code} is the draft as it was taken, no evidence yet: drag its points onto the crown.`;
  if (hasFingers) return "Tap to choose, drag points, double-tap a line to add a point.";
  return "Click to choose, drag points, double-click a line to add a point. Arrow keys move the chosen point by a tenth of a pixel, with Shift by one.";
}

const drawing = new Drawing(data.image_size);
const picture = new Picture($(".pane"), data);
// On a narrow screen the line of news stays above the picture.
new ResizeObserver(([{ target }]) => document.documentElement.style.setProperty("--news", `${target.offsetHeight}px`)).observe($("header"));
/** What is chosen: {kind: "landmark", name}, {kind: "contour", contour, index?}, {kind: "draft", code}, or null. */
let chosen = null;
let mode = "landmark";
let landmark = "U1_tip";
let tooth = "";
/** What the last registration said; null before. */
let result = null;
let showsAim = false;

/** `by`: whose it is to take it back. */
let saidBy = "";
function say(text, isProblem = false, by = "") {
  const place = $("#said");
  saidBy = by;
  place.textContent = text;
  place.classList.toggle("problem", isProblem);
}

// ---- choices --------------------------------------------------------------------------------------------------------

function setMode(next) {
  mode = next;
  for (const button of $$("[data-mode]")) button.setAttribute("aria-pressed", String(button.dataset.mode === mode));
  $(".pane").classList.toggle("move", mode === "move");
  refresh();
}

function chooseLandmark(name) {
  landmark = name;
  chosen = drawing.state.landmarks[name] ? { kind: "landmark", name } : null;
  setMode("landmark");
}

function chooseTooth(code) {
  tooth = code;
  const contour = drawing.find(code);
  chosen = contour ? { kind: "contour", contour, index: contour.points.length - 1 } : draftOf(code) ? { kind: "draft", code } : null;
  // What is there is looked at: a click beside it must not draw it on. O goes on with it.
  setMode(chosen ? "move" : "outline");
}

/** Contours are other objects after an undo. */
function settleChoice() {
  if (chosen?.kind === "landmark" && !drawing.state.landmarks[chosen.name]) chosen = null;
  if (chosen?.kind === "contour" && !drawing.all().includes(chosen.contour)) {
    const contour = chosen.contour.code ? drawing.find(chosen.contour.code) : null;
    chosen = contour ? { kind: "contour", contour, index: Math.min(chosen.index ?? 0, contour.points.length - 1) } : null;
  }
  if (chosen?.kind === "draft" && !draftOf(chosen.code)) chosen = null;
}

function nextTooth() {
  const chart = CHARTS[$("#kind").value];
  for (const [quadrant, positions] of chart) {
    if (!tooth.startsWith(quadrant) || tooth.length !== quadrant.length + 1) continue;
    const order = [...positions].sort();
    const next = order[order.indexOf(tooth.slice(-1)) + 1];
    if (next) return chooseTooth(quadrant + next);
  }
  chosen = null;
  setMode("move");
}

// ---- what a click does ----------------------------------------------------------------------------------------------

function place(at) {
  const point = at.map(round);
  if (mode === "landmark") {
    drawing.change(state => {
      const before = state.landmarks[landmark];
      state.landmarks[landmark] = before && !Array.isArray(before) ? { ...before, position: point } : point;
    });
    chosen = { kind: "landmark", name: landmark };
    // The next one; after the last one a click that was meant for something else must not take it along.
    const open = LANDMARKS.map(([name]) => name).find(name => !drawing.state.landmarks[name]);
    if (open) landmark = open;
    else setMode("move");
  } else if (mode === "outline") {
    if (!tooth) return say("Choose a tooth in the chart first.", true);
    drawing.change(state => {
      let contour = drawing.find(tooth);
      if (!contour) {
        contour = { code: tooth, points: [] };
        if ($("#outline").value !== "crown") contour.outline = $("#outline").value;
        if ($("#closed").checked || $("#outline").value === "tooth") contour.closes = true;
        const list = state.contours[jawOf(tooth)];
        const empty = list.findIndex(other => other.code === tooth);
        if (empty >= 0) list.splice(empty, 1, contour);
        else list.push(contour);
      }
      drawing.insertPoint(contour, contour.points.length, point);
      if (contour.closes && contour.points.length >= 3) {
        contour.closed = true;
        delete contour.closes;
      }
      chosen = { kind: "contour", contour, index: contour.points.length - 1 };
    });
  }
  refresh();
}

picture.addEventListener("press", ({ detail: { at, target, event } }) => {
  showsAim = false;
  if (mode === "move" && event.detail === 0 && isSecondPress(at) && target?.kind === "line") return insertOnLine(contourOf(target), at);
  // Cusps of both jaws lie on each other: a landmark is put where it is clicked, whatever is there already.
  if (mode === "landmark") return place(at);
  if (target?.kind === "landmark") {
    landmark = target.name;
    chosen = { kind: "landmark", name: target.name };
  } else if (target?.kind === "vertex") {
    const contour = contourOf(target);
    if (mode === "outline" && contour.code === tooth && +target.index === 0 && contour.points.length >= 3 && !contour.closed) {
      drawing.change(() => { contour.closed = true; });
      return nextTooth();
    }
    chosen = { kind: "contour", contour, index: +target.index };
    tooth = contour.code;
  } else if (mode === "move" && target?.kind === "line") {
    const contour = contourOf(target);
    chosen = { kind: "contour", contour };
    tooth = contour.code;
  } else if (mode === "move" && target?.kind === "draft") {
    chosen = { kind: "draft", code: target.code };
    tooth = target.code;
  } else if (mode === "move") {
    chosen = null;
  } else {
    return place(at);
  }
  refresh();
});

let lastPress = { time: 0, at: [0, 0] };
function isSecondPress(at) {
  const now = performance.now();
  const second = now - lastPress.time < 400 && Math.hypot(at[0] - lastPress.at[0], at[1] - lastPress.at[1]) < 6 * picture.scale;
  lastPress = { time: now, at };
  return second;
}

const contourOf = target => drawing.state.contours[target.jaw][+target.contour];

function insertOnLine(contour, at) {
  const toSegment = (p, a, b) => {
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const t = Math.max(0, Math.min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy || 1)));
    return Math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
  };
  const count = contour.points.length - (contour.closed ? 0 : 1);
  const distances = Array.from({ length: count }, (_, i) => toSegment(at, contour.points[i], contour.points[(i + 1) % contour.points.length]));
  const index = distances.indexOf(Math.min(...distances)) + 1;
  drawing.change(() => drawing.insertPoint(contour, index, at.map(round)));
  chosen = { kind: "contour", contour, index };
  refresh();
}

let held = null;
picture.addEventListener("grab", ({ detail: target }) => {
  const at = target.kind === "landmark" ? positionOf(drawing.state.landmarks[target.name]) : contourOf(target).points[+target.index];
  held = { before: JSON.stringify(drawing.state), at, start: [...at], contour: target.kind === "landmark" ? null : contourOf(target) };
  chosen = target.kind === "landmark" ? { kind: "landmark", name: target.name } : { kind: "contour", contour: contourOf(target), index: +target.index };
});
picture.addEventListener("drag", ({ detail: [du, dv] }) => {
  held.at[0] = round(held.start[0] + du);
  held.at[1] = round(held.start[1] + dv);
  picture.redraw();
});
picture.addEventListener("release", ({ detail: { cancelled } }) => {
  if (cancelled) held.at.splice(0, 2, ...held.start);
  else if (held.contour) drawing.own(held.contour);
  drawing.remember(held.before);
  held = null;
  refresh();
});
picture.addEventListener("hover", ({ detail: [u, v] }) => {
  $("#place").textContent = `${u.toFixed(1)}, ${v.toFixed(1)} px.`;
});

/** The chosen point, or null. */
function chosenPoint() {
  if (chosen?.kind === "landmark") return positionOf(drawing.state.landmarks[chosen.name]);
  return chosen?.kind === "contour" && chosen.index !== undefined ? chosen.contour.points[chosen.index] : null;
}

function nudge(du, dv) {
  drawing.change(() => {
    const point = chosenPoint();
    point[0] = round(point[0] + du);
    point[1] = round(point[1] + dv);
    if (chosen.kind === "contour") drawing.own(chosen.contour);
  });
}

function remove() {
  if (chosen?.kind === "landmark") {
    const { name } = chosen;
    drawing.change(state => { delete state.landmarks[name]; });
    landmark = name;
    chosen = null;
  } else if (chosen?.kind === "contour") {
    const { contour, index } = chosen;
    drawing.change(() => {
      if (index === undefined || contour.points.length <= 1) drawing.drop(contour);
      else drawing.removePoint(contour, index);
    });
    chosen = index === undefined || contour.points.length === 0 || !drawing.all().includes(contour) ? null : { kind: "contour", contour, index: Math.max(0, index - 1) };
  }
  refresh();
}

// ---- drafts ---------------------------------------------------------------------------------------------------------

/** Of a tooth that is not drawn yet, on a side that is shown. */
function draftOf(code) {
  return drafts().find(draft => draft.code === code);
}
function drafts() {
  if (!result?.drafts) return [];
  const shown = Object.fromEntries($$("[data-side]").map(box => [box.dataset.side, box.checked]));
  return [...result.drafts.upper, ...result.drafts.lower].filter(draft => shown[draft.code[1]] && !drawing.find(draft.code));
}
function accept(taken) {
  if (taken.length === 0) return say("There is no such draft: register first, or choose a tooth that is not drawn.", true);
  drawing.change(state => {
    for (const draft of taken) {
      const list = state.contours[jawOf(draft.code)];
      const made = { code: draft.code, points: draft.points.map(point => [...point]), drafted: true };
      const empty = list.findIndex(contour => contour.code === draft.code);
      if (empty >= 0) list.splice(empty, 1, made);
      else list.push(made);
    }
  });
  const [{ code }] = taken;
  if (taken.length === 1) {
    tooth = code;
    chosen = { kind: "contour", contour: drawing.find(code) };
  }
  setMode("move");
}

// ---- registration ---------------------------------------------------------------------------------------------------

function toRequest() {
  return { contours: drawing.hasContours() ? drawing.toContours() : null, landmarks: drawing.hasLandmarks() ? drawing.toLandmarks() : null };
}

/** The server answers the page that was loaded last, which it knows by its number. */
const addressOf = what => new URL(`${data.number}/${what}`, location.href);
async function post(what, request) {
  const answer = await fetch(addressOf(what), { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(request) });
  const json = await answer.json();
  if (!answer.ok) throw new Error(json.error);
  return json;
}

function sayProblem(error, advice, by) {
  say(error instanceof TypeError ? `The server does not answer: was it ended? ${advice}` : error.message, true, by);
}

let registering = false;
let registersAgain = false;
/** Of the drawing that the verdict is of. */
let registeredVersion = -1;
let refusal = "";
async function register() {
  if (!data.can_register) return;
  if (registering) {
    registersAgain = true;
    return;
  }
  registering = true;
  const started = performance.now();
  const registered = drawing.version;
  $("#registration").setAttribute("aria-busy", "true");
  try {
    result = await post("register", toRequest());
    registeredVersion = registered;
    showVerdict();
    const verdicts = Object.entries(result.jaws).map(([jaw, { status }]) => `${jaw} ${status}`);
    $("#outcome").textContent = `Registered in ${((performance.now() - started) / 1000).toFixed(2)} s: ${verdicts.join(", ")}.`;
    if (saidBy === "register") say("");
  } catch (error) {
    sayProblem(error, "What is drawn is kept in this browser.", "register");
    // The verdict is none of this drawing.
    refusal = error.message;
  }
  $("#registration").removeAttribute("aria-busy");
  registering = false;
  refresh();
  if (registersAgain) {
    registersAgain = false;
    register();
  }
}

/** Four landmarks, or as much of a tracing as can be registered. */
function isEnough() {
  return Object.keys(drawing.state.landmarks).length >= 4 || drawing.all().reduce((sum, contour) => sum + contour.points.length, 0) >= 10;
}
let timer = 0;
function registerSoon() {
  clearTimeout(timer);
  refusal = "";
  if (data.can_register && $("#live").checked && isEnough()) timer = setTimeout(register, 100);
}

/** A verdict stays until the next one, and says when it is of what was drawn before. */
function showAge() {
  if (!data.can_register) return;
  const isOld = result !== null && registeredVersion !== drawing.version;
  for (const part of ["#outcome", "#verdict", "#figures"]) $(part).classList.toggle("old", isOld);
  $("#age").hidden = !isOld && !refusal;
  $("#age").textContent = refusal ? `Not registered: ${refusal}` : $("#live").checked && isEnough() ? "Registering what you changed …" : "You changed the drawing since this verdict.";
  $("#age").classList.toggle("problem", Boolean(refusal));
}

const make = (name, text, className = "") => {
  const element = document.createElement(name);
  element.textContent = text;
  if (className) element.className = className;
  return element;
};
const number = value => (value === null || value === undefined ? "–" : value.toFixed(1));

function table(caption, heads, rows) {
  const made = document.createElement("table");
  made.append(make("caption", caption));
  const head = made.createTHead().insertRow();
  heads.forEach((text, i) => { const cell = make("th", text, i ? "number" : ""); cell.scope = "col"; head.append(cell); });
  const body = made.createTBody();
  for (const row of rows) {
    const line = body.insertRow();
    row.forEach((text, i) => { const cell = make(i ? "td" : "th", text, i ? "number" : ""); if (!i) cell.scope = "row"; line.append(cell); });
  }
  return made;
}

function showVerdict() {
  const place = $("#verdict"), residuals = $("#residuals"), predictions = $("#predicted");
  for (const part of [place, residuals, predictions]) part.replaceChildren();
  for (const [jaw, said] of Object.entries(result.jaws)) {
    const title = make("h3", `${jaw} `, said.status);
    title.append(make("span", said.status, "badge"));
    place.append(title);
    const figures = [];
    if (said.expected_error_px !== undefined) figures.push(`expected error ${number(said.expected_error_px)} px`);
    if (said.fit_px !== undefined) figures.push(`fit ${number(said.fit_px)} px`);
    const sigmas = (said.predicted ?? []).map(row => row.sigma_px).filter(sigma => sigma !== null);
    if (sigmas.length) figures.push(`σ of its landmarks ${number(Math.min(...sigmas))} to ${number(Math.max(...sigmas))} px`);
    if (said.placed_by) figures.push(`placed by the ${said.placed_by} jaw`);
    if (figures.length) place.append(make("p", figures.join(", ")));
    if (said.findings.length) {
      const list = document.createElement("ul");
      for (const finding of said.findings) list.append(make("li", `${finding.severity}: ${finding.text}`));
      place.append(list);
    }
    if (said.landmarks_used?.length)
      residuals.append(table(`Landmarks that the ${jaw} jaw was registered with`, ["landmark", "away, px", "away, sd", "weight"],
        said.landmarks_used.map(used => [used.name, number(Math.hypot(...used.residual_px)), number(used.residual_sd), number(used.weight)])));
    if (said.teeth?.length)
      residuals.append(table(`Outlines of the ${jaw} jaw: distance from the scan's`, ["tooth", "mean, px", "largest, px"], said.teeth.map(row => [row.tooth || "?", number(row.mean_px), number(row.max_px)])));
    if (said.predicted?.length)
      predictions.append(table(`Of the ${jaw} jaw`, ["landmark", "u", "v", "σ, px"], said.predicted.map(row => [row.name, number(row.position[0]), number(row.position[1]), number(row.sigma_px)])));
  }
  const outlines = drawing.all().filter(contour => contour.points.length > 0), taken = outlines.filter(contour => contour.drafted).length;
  // Of more than half of a jaw's the verdict speaks itself.
  const isTold = Object.values(result.jaws).some(said => said.findings.some(finding => finding.code === "drafts-unmended"));
  if (taken > 0 && !isTold)
    place.prepend(make("p", `${taken} of ${outlines.length} outlines are drafts as they were taken. Of these the registration knows only what it said itself: fit, σ and expected error look better than they are. Correct what lies beside its crown.`, "warned"));
  for (const [jaw, why] of Object.entries(result.skipped)) place.append(make("p", `${jaw}: skipped, ${why}`, "quiet"));
  place.append(make("p", `Taken as ${result.traced_side === "standard" ? "the middle of both sides (standard)" : `drawn of the ${result.traced_side} side${result.traced_side === "both" ? "s" : ""}`}${result.traced_side_is_given ? ", as the case says" : ""}.`, "quiet"));
}

// ---- files ----------------------------------------------------------------------------------------------------------

let savedState = "";
function isDirty() {
  return JSON.stringify(drawing.state) !== savedState;
}
/** Whether anything would be lost, always in sight. */
function showState() {
  const place = $("#state"), dirty = isDirty();
  const failed = $("#saved").classList.contains("problem");
  place.textContent = !dirty ? (canSave() && (drawing.hasContours() || drawing.hasLandmarks()) ? "Saved" : "")
    : !canSave() ? "Kept in this browser, not in a file" : failed || !$("#saves").checked ? "Not saved" : "Saving …";
  place.classList.toggle("problem", dirty && canSave() && (failed || !$("#saves").checked));
}
/** What a file holds has to be saved also where it is nothing any more. */
const isInFile = { contours: Boolean(data.contours) && data.contours_saved, landmarks: Boolean(data.landmarks) && data.landmarks_saved };
let asRead = {};
let saving = null;
async function save(isAsked = true) {
  if (!canSave()) return drawing.hasContours() || !drawing.hasLandmarks() ? download("contours.json", drawing.toContours()) : download("landmarks.json", drawing.toLandmarks());
  await saving;
  saving = saveNow(isAsked);
  return saving;
}
async function saveNow(isAsked) {
  /** Beside the buttons, since the line above belongs to the registration while somebody draws. */
  const sayFiles = (text, isProblem = false) => {
    $("#saved").textContent = text;
    $("#saved").classList.toggle("problem", isProblem);
    if (isAsked || isProblem) say(text, isProblem, isProblem ? "save" : "");
  };
  const state = JSON.stringify(drawing.state);
  const hasContours = drawing.hasContours() || isInFile.contours, hasLandmarks = drawing.hasLandmarks() || isInFile.landmarks;
  try {
    const { saved } = await post("save", { contours: hasContours ? drawing.toContours() : null, landmarks: hasLandmarks ? drawing.toLandmarks() : null });
    isInFile.contours ||= hasContours;
    isInFile.landmarks ||= hasLandmarks;
    // What was read and not touched is where it was.
    const left = [["contours", "the tracing (start with --output)"], ["landmarks", "the landmarks (start with --landmarks)"]]
      .filter(([what]) => !data[`${what}_file`] && JSON.stringify(drawing.state[what]) !== asRead[what]).map(([, name]) => name);
    if (left.length) return void (sayFiles(`${saved.length ? `Saved ${saved.join(" and ")}, but not` : "Not saved:"} ${left.join(" and ")}. Download what is missing.`, true), refresh());
    savedState = state;
    keep();
    if (saidBy === "save") say("");
    sayFiles(saved.length ? `Saved ${saved.join(" and ")}.` : "There is nothing to save yet.");
  } catch (error) {
    sayFiles(error instanceof TypeError ? "The server does not answer: was it ended? Download what is drawn." : `Not saved: ${error.message}`, true);
  }
  refresh();
}
let saveTimer = 0;
function saveSoon() {
  clearTimeout(saveTimer);
  if (canSave() && $("#saves").checked && isDirty()) saveTimer = setTimeout(() => save(false), 1000);
}
const canSave = () => data.served && Boolean(data.contours_file || data.landmarks_file);

function download(name, json) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([`${JSON.stringify(json, null, 1)}\n`], { type: "application/json" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  say(`Downloaded as ${name}.`);
}

async function open(files) {
  for (const file of files) {
    try {
      const what = drawing.read(JSON.parse(await file.text()));
      say(what ? `${file.name}: ${what} opened.` : `${file.name}: is neither a tracing nor landmarks of the toolkit; other programs' files are read at the start, as --contours and --cephalometric-landmarks`, !what);
      suitChart();
    } catch (error) {
      say(`${file.name}: ${error.message}`, true);
    }
  }
}

// What is drawn outlives the page. A server's next page has another address, which the browser keeps apart.
const KEPT = `dentalscr-trace:${data.identity}`;
function keep() {
  try {
    if (isDirty()) localStorage.setItem(KEPT, JSON.stringify({ time: Date.now(), state: drawing.state }));
    else localStorage.removeItem(KEPT);
  } catch {
    say("This browser keeps nothing: save now and then.", true);
  }
}
function takeKept() {
  try {
    const kept = JSON.parse(localStorage.getItem(KEPT));
    if (!kept?.state?.contours) return;
    drawing.change(state => Object.assign(state, kept.state));
    say(`Unsaved drawing of ${new Date(kept.time).toLocaleString()} is back. Undo returns to the file's.`);
  } catch {
    // What cannot be read was not kept.
  }
}

/** All that is drawn, and the drafts where there are any: the region of the teeth. */
function allPoints() {
  const lines = [...drawing.all(), ...drafts()].flatMap(line => line.points);
  return [...lines, ...Object.values(drawing.state.landmarks).map(positionOf)];
}

// ---- what is seen ---------------------------------------------------------------------------------------------------

/** A white line on enamel is seen by its dark border. */
function halo(pen, what, ...where) {
  pen[what]("halo", ...where);
}

function paint({ drafts: under, drawing: pen, aim }, scale) {
  if (result && $("#outlines")?.checked)
    for (const jaw of Object.values(result.jaws)) for (const outline of jaw.outline ?? []) under.line("silhouette", outline.points, outline.closed);
  for (const draft of drafts()) {
    const on = chosen?.kind === "draft" && chosen.code === draft.code;
    if (on) halo(under, "line", draft.points);
    under.line(`draft${on ? " chosen" : ""}`, draft.points);
    if (mode === "move") under.line("hit", draft.points, false, { kind: "draft", code: draft.code });
    if (on) under.text(draft.points[0], draft.code);
  }
  for (const jaw of Object.values(result?.jaws ?? {})) {
    for (const predicted of jaw.predicted ?? []) {
      under.circle("predicted", predicted.position, 2.5);
      // Of all landmarks at once they hide the drafts.
      if ($("#regions").checked && predicted.sigma_px !== null) under.circle("sigma", predicted.position, (2.448 * predicted.sigma_px) / under.scale);
    }
    for (const used of jaw.landmarks_used ?? []) {
      const marked = drawing.state.landmarks[used.name];
      if (marked) { const [u, v] = positionOf(marked); under.line("residual", [[u, v], [u - used.residual_px[0], v - used.residual_px[1]]]); }
    }
  }
  for (const [name, value] of Object.entries(drawing.state.landmarks)) {
    const on = chosen?.kind === "landmark" && chosen.name === name;
    halo(pen, "cross", positionOf(value), on ? 11 : 8);
    pen.cross(`landmark${on ? " chosen" : ""}`, positionOf(value), on ? 11 : 8);
    // An outline goes through its tip: there a click is a point of the outline.
    if (mode !== "outline") pen.circle("grip", positionOf(value), 10, { kind: "landmark", name });
    pen.text(positionOf(value), name);
  }
  // Above the landmarks: of an outline that is chosen every point can be taken hold of.
  for (const jaw of ["upper", "lower"]) drawing.state.contours[jaw].forEach((contour, index) => {
    if (contour.points.length === 0) return;
    const on = chosen?.kind === "contour" && chosen.contour === contour;
    if (on) halo(pen, "line", contour.points, contour.closed);
    pen.line(`contour${on ? " chosen" : ""}${contour.drafted ? " taken" : ""}`, contour.points, contour.closed);
    if (mode === "move") pen.line("hit", contour.points, contour.closed, { kind: "line", jaw, contour: index });
    // Names that would lie on each other are left out until the picture is large enough for them.
    const [first, last] = [contour.points[0], contour.points.at(-1)];
    const middle = contour.points[Math.floor(contour.points.length / 2)];
    if (on || Math.hypot(first[0] - last[0], first[1] - last[1]) > 30 * scale) pen.text(middle, contour.code || "?", -12, jaw === "upper" ? 20 : -12);
    if (!on && contour.points.length > 1) return;
    contour.points.forEach((point, i) => {
      pen.circle(`vertex${on && chosen.index === i ? " chosen" : ""}`, point, 4);
      pen.circle("grip", point, 9, { kind: "vertex", jaw, contour: index, index: i });
    });
  });
  if (showsAim) aim.cross("aim", picture.centre(), 14);
  $("#aim").toggleAttribute("hidden", !showsAim);
}

function refresh() {
  settleChoice();
  $("#hint").textContent = makeHint();
  showState();
  for (const button of $$("#landmarks button")) {
    button.setAttribute("aria-pressed", String(mode === "landmark" && button.dataset.name === landmark));
    button.classList.toggle("drawn", Boolean(drawing.state.landmarks[button.dataset.name]));
  }
  const drafted = new Set(drafts().map(draft => draft.code));
  for (const button of $$("#chart button")) {
    const { code } = button.dataset;
    const contour = drawing.find(code);
    button.setAttribute("aria-pressed", String(code === tooth));
    button.classList.toggle("drawn", Boolean(contour));
    button.classList.toggle("drafted", drafted.has(code));
    button.classList.toggle("taken", Boolean(contour?.drafted));
    button.title = contour ? `${code}: ${contour.points.length} points${contour.drafted ? ", the draft as it was taken" : ""}` : drafted.has(code) ? `${code}: draft` : code;
  }
  const contour = chosen?.kind === "contour" ? chosen.contour : null;
  if (contour) {
    $("#closed").checked = Boolean(contour.closed ?? contour.closes);
    $("#outline").value = contour.outline ?? "crown";
  }
  $("[data-action=undo]").disabled = drawing.past.length === 0;
  $("[data-action=redo]").disabled = drawing.future.length === 0;
  $("[data-action=delete]").disabled = !chosen || chosen.kind === "draft";
  $("[data-action=insert]").disabled = !(contour && chosen.index !== undefined && contour.points.length > 1);
  $("[data-action=teeth]").disabled = allPoints().length === 0;
  $("[data-action=finish]").disabled = !tooth;
  $("[data-action=download-contours]").disabled = !drawing.hasContours();
  $("[data-action=download-landmarks]").disabled = !drawing.hasLandmarks();
  for (const other of ["labelme", "slicer"]) $(`[data-action=download-${other}]`).disabled = !drawing.hasContours() && !drawing.hasLandmarks();
  showAge();
  for (const button of $$("[data-action=accept]")) button.disabled = chosen?.kind !== "draft";
  for (const button of $$("[data-accept]")) button.disabled = !drafts().some(draft => draft.code[1] === button.dataset.accept);
  picture.redraw();
}

function makeChart() {
  const chart = $("#chart");
  chart.replaceChildren();
  const kind = $("#kind").value;
  CHARTS[kind].forEach(([quadrant, positions], row) => {
    if (row === CHARTS[kind].length / 2) chart.append(document.createElement("hr"));
    for (const position of positions) {
      const button = make("button", quadrant + position);
      button.type = "button";
      button.dataset.code = quadrant + position;
      button.addEventListener("click", () => chooseTooth(button.dataset.code));
      chart.append(button);
    }
    for (let i = positions.length; i < 8; i++) chart.append(document.createElement("span"));
  });
  refresh();
}

/** The chart on which what is drawn is found: a tracing of U1 and L6 has none of UR1's. */
function suitChart() {
  const codes = new Set(drawing.all().map(contour => contour.code));
  const count = kind => CHARTS[kind].flatMap(([quadrant, positions]) => [...positions].map(position => quadrant + position)).filter(code => codes.has(code)).length;
  const best = Object.keys(CHARTS).reduce((a, b) => (count(b) > count(a) ? b : a));
  if (count(best) > 0 && count($("#kind").value) === 0) $("#kind").value = best;
  makeChart();
}

function makeLandmarks() {
  const add = ([name, title]) => {
    const button = make("button", name);
    Object.assign(button, { type: "button", title });
    button.dataset.name = name;
    button.addEventListener("click", () => chooseLandmark(name));
    $("#landmarks").append(button);
  };
  LANDMARKS.forEach(add);
  for (const [name, title] of FURTHER) $("#further").append(new Option(`${name}: ${title}`, name));
  $("#further").addEventListener("change", event => {
    const name = event.target.value;
    event.target.value = "";
    if (!name) return;
    if (![...$$("#landmarks button")].some(button => button.dataset.name === name)) add([name, name]);
    chooseLandmark(name);
  });
  for (const name of Object.keys(drawing.state.landmarks)) if (!LANDMARKS.some(([known]) => known === name)) add([name, name]);
}

const ACTIONS = {
  in: () => picture.zoom(0.7), out: () => picture.zoom(1 / 0.7), home: () => picture.home(), teeth: () => picture.show(allPoints()),
  undo: () => drawing.undo(), redo: () => drawing.redo(), delete: remove, finish: nextTooth,
  insert: () => {
    const { contour, index } = chosen, next = contour.points[(index + 1) % contour.points.length];
    const isLast = index === contour.points.length - 1 && !contour.closed;
    const other = isLast ? contour.points[index - 1] : next, at = contour.points[index];
    // Halfway to the next point; behind the last one of an open line before it.
    const position = isLast ? index : index + 1;
    drawing.change(() => drawing.insertPoint(contour, position, [round((at[0] + other[0]) / 2), round((at[1] + other[1]) / 2)]));
    chosen = { kind: "contour", contour, index: position };
    refresh();
  },
  register, save: () => save(), accept: () => chosen?.kind === "draft" && accept([draftOf(chosen.code)]),
  "download-contours": () => download("contours.json", drawing.toContours()),
  "download-landmarks": () => download("landmarks.json", drawing.toLandmarks()),
  // labelme looks for a file that is called as the radiograph is.
  "download-labelme": () => download(`${data.title.replace(/\.[^.]*$/, "")}.json`, drawing.toLabelme(data.title)),
  "download-slicer": () => download("drawing.mrk.json", drawing.toMarkups(data.markups_grid)),
};

function onKey(event) {
  const isTyping = event.target.closest("input, select, textarea") !== null && event.target.type !== "checkbox" && event.target.type !== "range";
  if (event.ctrlKey || event.metaKey) {
    const action = { z: event.shiftKey ? "redo" : "undo", y: "redo", s: "save" }[event.key.toLowerCase()];
    if (!action || isTyping) return;
    event.preventDefault();
    return ACTIONS[action]();
  }
  if (event.altKey || isTyping) return;
  const press = action => () => { const button = $(`[data-action=${action}]`); if (button && !button.disabled) ACTIONS[action](); };
  const everywhere = { l: () => setMode("landmark"), o: () => setMode("outline"), v: () => setMode("move"), g: press("register"), a: press("accept"), i: press("insert") };
  const step = event.shiftKey ? 1 : 0.1;
  const shift = (right, down) => () => { if (chosenPoint() && mode === "move") nudge(right * step, down * step); else { showsAim = true; picture.move(0.05 * right, 0.05 * down); } };
  const inPane = {
    ArrowLeft: shift(-1, 0), ArrowRight: shift(1, 0), ArrowUp: shift(0, -1), ArrowDown: shift(0, 1),
    "+": () => picture.zoom(0.8), "=": () => picture.zoom(0.8), "-": () => picture.zoom(1.25), 0: () => picture.home(), t: press("teeth"),
    " ": () => { showsAim = true; place(picture.centre()); }, Enter: press("finish"), Delete: press("delete"), Backspace: press("delete"),
    Escape: () => { chosen = null; setMode("move"); },
  };
  const found = (event.target === $(".pane") && inPane[event.key]) || everywhere[event.key.toLowerCase()];
  if (found) {
    event.preventDefault();
    found();
  }
}

// ---- beginning ------------------------------------------------------------------------------------------------------

for (const button of $$("[data-mode]")) button.addEventListener("click", () => setMode(button.dataset.mode));
for (const button of $$("[data-action]")) button.addEventListener("click", () => ACTIONS[button.dataset.action]());
for (const button of $$("[data-accept]")) button.addEventListener("click", () => accept(drafts().filter(draft => draft.code[1] === button.dataset.accept)));
for (const input of $$("[data-film]")) input.addEventListener("input", () => picture.setFilm(input.dataset.film, input.type === "checkbox" ? input.checked : input.value));
for (const box of $$("[data-side], #outlines, #regions")) box.addEventListener("change", refresh);
$("#live")?.addEventListener("change", () => { registerSoon(); refresh(); });
$("#kind").addEventListener("change", makeChart);
$("#closed").addEventListener("change", event => {
  if (chosen?.kind !== "contour") return;
  const { contour } = chosen;
  if (event.target.checked && contour.points.length < 3) { contour.closes = true; return; }
  drawing.change(() => { if (event.target.checked) contour.closed = true; else { delete contour.closed; delete contour.closes; } });
});
$("#outline").addEventListener("change", event => {
  if (chosen?.kind !== "contour") return;
  const { contour } = chosen, { value } = event.target;
  drawing.change(() => { if (value === "crown") delete contour.outline; else contour.outline = value; });
});
$("#open").addEventListener("change", async event => {
  await open([...event.target.files]);
  event.target.value = "";
});
document.addEventListener("keydown", onKey);
window.addEventListener("beforeunload", event => {
  // Another page of the server will not find what this one kept.
  if (data.served && isDirty()) event.preventDefault();
});
if (data.served) {
  // A server without a page ends; one that is loaded again comes in time.
  window.addEventListener("pagehide", () => navigator.sendBeacon(addressOf("closed"), new Blob(["{}"], { type: "application/json" })));
  window.addEventListener("pageshow", event => { if (event.persisted) location.reload(); });
}

try {
  if (data.contours) drawing.read(data.contours);
  if (data.landmarks) drawing.read(data.landmarks);
  say(data.served || drawing.hasContours() || drawing.hasLandmarks() ? "" : "This page works by itself: download what you draw.");
} catch (error) {
  say(error.message, true);
}
drawing.past = [];
// What came from other files is in none of these yet.
const isElsewhere = data.served && ["contours", "landmarks"].some(what => data[what] && data[`${what}_file`] && !data[`${what}_saved`]);
asRead = Object.fromEntries(["contours", "landmarks"].map(what => [what, JSON.stringify(drawing.state[what])]));
savedState = isElsewhere ? "" : JSON.stringify(drawing.state);
$("[data-action=save]").hidden = !canSave();
$("#saves").closest("label").hidden = !canSave();
$("#saves").checked = data.saves_itself;
$("#saves").addEventListener("change", saveSoon);
makeLandmarks();
picture.setPainter(paint);
takeKept();
suitChart();
drawing.addEventListener("change", () => { keep(); registerSoon(); saveSoon(); refresh(); });
// Goes on where it was left: a click takes nothing away.
landmark = LANDMARKS.map(([name]) => name).find(name => !drawing.state.landmarks[name]) ?? landmark;
setMode("landmark");
if (drawing.hasLandmarks() && LANDMARKS.every(([name]) => drawing.state.landmarks[name])) setMode("move");
registerSoon();
saveSoon();
refresh();
