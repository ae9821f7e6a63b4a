// What is drawn, with its undo and its files. Places are continuous pixel indices, (0, 0) the centre of the first pixel.

/** The toolkit's own spelling of a tooth code ("UR1", "URA", "U6"); what it does not know stays as it is. */
function toCode(text, numbering = "") {
  const code = String(text ?? "").trim().toUpperCase();
  const quadrant = /^(U[RL]|L[RL])[-_ ]?([1-8A-E])$/.exec(code) ?? /^([UL])[-_ ]?([1-8])$/.exec(code);
  if (quadrant) return quadrant[1] + quadrant[2];
  const names = ["UR", "UL", "LL", "LR"];
  if (numbering.toLowerCase() === "universal") {
    if (/^[A-T]$/.test(code)) {
      const i = code.charCodeAt(0) - 65, q = Math.floor(i / 5), within = i % 5;
      return names[q] + "ABCDE"[q % 2 === 0 ? 4 - within : within];
    }
    const number = /^(?:#|TOOTH[ _])?(\d+)$/.exec(code);
    if (number && +number[1] >= 1 && +number[1] <= 32) {
      const i = +number[1] - 1, q = Math.floor(i / 8), within = i % 8;
      return names[q] + (q % 2 === 0 ? 8 - within : within + 1);
    }
    return code;
  }
  const fdi = /^(?:#|TOOTH[ _]|FDI )?([1-8])\.?([1-8])$/.exec(code);
  if (fdi && (+fdi[1] <= 4 || +fdi[2] <= 5)) return names[(fdi[1] - 1) % 4] + (+fdi[1] <= 4 ? fdi[2] : "ABCDE"[fdi[2] - 1]);
  return code;
}

const jawOf = code => (code.startsWith("L") ? "lower" : "upper");
/** A thousandth of a pixel is finer than any hand, and a file of it can be read. */
const round = value => Math.round(value * 1000) / 1000;
const positionOf = landmark => (Array.isArray(landmark) ? landmark : landmark.position);
const isPlace = value => Array.isArray(value) ? value.length === 2 : value !== null && typeof value === "object" && Array.isArray(value.position);

class Drawing extends EventTarget {
  constructor(imageSize) {
    super();
    this.imageSize = imageSize;
    this.state = { contours: { upper: [], lower: [] }, landmarks: {}, rest: {}, other: {} };
    this.past = [];
    this.future = [];
    /** Another one after each change. */
    this.version = 0;
  }

  /** Changes the state by a function; one step of undo. Nothing is remembered where nothing changed. */
  change(apply) {
    const before = JSON.stringify(this.state);
    apply(this.state);
    this.remember(before);
  }

  remember(before) {
    if (JSON.stringify(this.state) === before) return;
    this.past.push(before);
    if (this.past.length > 500) this.past.shift();
    this.future = [];
    this.tell();
  }

  tell() {
    this.version++;
    this.dispatchEvent(new Event("change"));
  }

  travel(from, to) {
    if (from.length === 0) return;
    to.push(JSON.stringify(this.state));
    this.state = JSON.parse(from.pop());
    this.tell();
  }
  undo() { this.travel(this.past, this.future); }
  redo() { this.travel(this.future, this.past); }

  find(code) {
    return this.state.contours[jawOf(code)].find(contour => contour.code === code && contour.points.length > 0);
  }

  all() {
    return [...this.state.contours.upper, ...this.state.contours.lower];
  }

  /** A draft that a hand has changed is the hand's. What was taken as it was says so in the file, and register tells. */
  own(contour) {
    delete contour.drafted;
  }

  /** Points have companions in lists of their own; they come and go together. */
  insertPoint(contour, index, point) {
    this.own(contour);
    contour.points.splice(index, 0, point);
    if (Array.isArray(contour.weights)) contour.weights.splice(index, 0, 1);
    if (Array.isArray(contour.sigma_px)) contour.sigma_px.splice(index, 0, null);
  }
  removePoint(contour, index) {
    this.own(contour);
    for (const list of [contour.points, contour.weights, contour.sigma_px])
      if (Array.isArray(list)) list.splice(index, 1);
    // Three points are the fewest that close.
    if (contour.points.length < 3) delete contour.closed;
  }
  drop(contour) {
    for (const jaw of ["upper", "lower"]) this.state.contours[jaw] = this.state.contours[jaw].filter(other => other !== contour);
  }

  /** Takes what a file says. \return what it was: "tracing", "landmarks", or "" for neither */
  read(json) {
    if (json === null || typeof json !== "object" || Array.isArray(json)) return "";
    if (json.contours && typeof json.contours === "object" && (json.contours.upper || json.contours.lower)) {
      const { contours, image_size: size, numbering, ...rest } = json;
      if (Array.isArray(size) && (size[0] !== this.imageSize[0] || size[1] !== this.imageSize[1]))
        throw new Error(`image_size: is ${size.join(" × ")}, but this radiograph has ${this.imageSize.join(" × ")} pixels; open the tracing of this radiograph`);
      const read = {};
      for (const jaw of ["upper", "lower"])
        read[jaw] = (contours[jaw] ?? []).map((contour, i) => {
          const points = contour.points ?? [];
          if (!points.every(point => Array.isArray(point) && point.length === 2 && point.every(Number.isFinite)))
            throw new Error(`contours.${jaw}[${i}].points: is no list of [u, v]; mend the file`);
          return { ...contour, code: toCode(contour.code, numbering), points };
        });
      this.change(state => { state.contours = read; state.rest = rest; });
      return "tracing";
    }
    const places = Object.entries(json).filter(([, value]) => isPlace(value));
    if (places.length === 0) return "";
    this.change(state => {
      state.landmarks = Object.fromEntries(places);
      state.other = Object.fromEntries(Object.entries(json).filter(([, value]) => !isPlace(value)));
    });
    return "landmarks";
  }

  /** contours.json. */
  toContours() {
    // What is to be closed once it has three points is the page's own affair.
    const own = list => list.map(({ closes, ...contour }) => contour);
    const { upper, lower } = this.state.contours;
    return { image_size: this.imageSize, ...this.state.rest, contours: { upper: own(upper), lower: own(lower) } };
  }

  /** cephalometric_landmarks. */
  toLandmarks() {
    return { ...this.state.other, ...this.state.landmarks };
  }

  /** labelme's, which counts from the pixel's corner. Open it beside the radiograph. */
  toLabelme(imageName) {
    const [width, height] = this.imageSize;
    const shape = (label, points, type) => ({
      label, points: points.map(point => point.map(x => round(x + 0.5))), group_id: null, description: "", shape_type: type, flags: {}, mask: null,
    });
    return {
      version: "5.4.1", flags: {},
      shapes: [
        ...this.all().filter(contour => contour.points.length > 0).map(contour => shape(contour.code, contour.points, contour.closed ? "polygon" : "linestrip")),
        ...Object.entries(this.state.landmarks).map(([name, value]) => shape(name, [positionOf(value)], "point")),
      ],
      imagePath: imageName, imageData: null, imageHeight: height, imageWidth: width,
    };
  }

  /** 3D Slicer's: millimetres of the grid that it shows the radiograph in, spacing and then the first pixel's centre. */
  toMarkups([spacingU, spacingV, originU, originV]) {
    // A micrometre: finer than a hundredth of any detector's pixel.
    const place = ([u, v]) => [originU + u * spacingU, originV + v * spacingV, 0].map(x => Math.round(1e6 * x) / 1e6);
    const markup = (type, name, points) => ({
      type, name, coordinateSystem: "LPS", coordinateUnits: "mm",
      controlPoints: points.map(([label, point], i) => ({ id: String(i + 1), label, position: place(point), selected: true, locked: false, visibility: true, positionStatus: "defined" })),
    });
    const landmarks = Object.entries(this.state.landmarks).map(([name, value]) => [name, positionOf(value)]);
    return {
      // Slicer opens no file of markups without its name.
      "@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/markups-schema-v1.0.3.json#",
      markups: [
        ...(landmarks.length ? [markup("Fiducial", "landmarks", landmarks)] : []),
        ...this.all().filter(contour => contour.points.length > 0).map(contour =>
          markup(contour.closed ? "ClosedCurve" : "Curve", contour.code, contour.points.map((point, i) => [`${contour.code}-${i + 1}`, point]))),
      ],
    };
  }

  hasContours() {
    return this.all().some(contour => contour.points.length > 0);
  }
  hasLandmarks() {
    return Object.keys(this.state.landmarks).length > 0;
  }
}
