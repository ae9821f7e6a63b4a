// The radiograph with what is drawn on it. Zoom, pan and pointers are its own; what a click means is the page's.
// Its units are pixels, u to the right, v down; where pixels are not square v is stretched, by the aspect.

class Picture extends EventTarget {
  constructor(pane, data) {
    super();
    this.pane = pane;
    this.svg = pane.querySelector("svg");
    this.aspect = data.aspect;
    this.size = data.image_size;
    this.box = { x: 0, y: 0, width: 1, height: 1 };
    // The first pixel's centre is (0, 0), hence its corner half a pixel before it.
    const film = this.svg.querySelector(".film");
    for (const [name, value] of Object.entries({ x: -0.5, y: -0.5 * this.aspect, width: data.picture_size[0], height: data.picture_size[1] * this.aspect }))
      film.setAttribute(name, value);
    this.film = { brightness: 1, contrast: 1, invert: false };
    this.pointers = new Map();
    this.gesture = null;
    pane.addEventListener("wheel", event => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.0015), this.toUnits(event));
    }, { passive: false });
    pane.addEventListener("pointerdown", event => this.onDown(event));
    pane.addEventListener("pointermove", event => this.onMove(event));
    for (const name of ["pointerup", "pointercancel"]) pane.addEventListener(name, event => this.onUp(event, name === "pointercancel"));
    pane.addEventListener("contextmenu", event => event.preventDefault());
    new ResizeObserver(() => this.redraw()).observe(pane);
    this.home();
  }

  setFilm(name, value) {
    this.film[name] = value;
    const { brightness, contrast, invert } = this.film;
    this.svg.querySelector(".film").style.filter = `${invert ? "invert(1) " : ""}brightness(${brightness}) contrast(${contrast})`;
  }

  /** Units of the picture in one of the screen. */
  get scale() {
    return 1 / (this.svg.getScreenCTM()?.a || 1);
  }
  /** A mouse points with a pixel of the screen, whose middle is meant; fingers and pens know fractions of one. */
  toUnits(event) {
    const half = event.pointerType === "mouse" ? 0.5 / (window.devicePixelRatio || 1) : 0;
    const point = new DOMPoint(event.clientX + half, event.clientY + half).matrixTransform(this.svg.getScreenCTM().inverse());
    return { x: point.x, y: point.y };
  }
  /** Continuous pixel index of an event. */
  toPixel(event) {
    const { x, y } = this.toUnits(event);
    return [x, y / this.aspect];
  }
  /** What stands in the middle of the view. */
  centre() {
    return [this.box.x + this.box.width / 2, (this.box.y + this.box.height / 2) / this.aspect];
  }
  toSVG([u, v]) {
    return [u, v * this.aspect];
  }

  setBox(box) {
    this.box = box;
    this.svg.setAttribute("viewBox", [box.x, box.y, box.width, box.height].join(" "));
    this.redraw();
  }
  home() {
    this.setBox({ x: -0.5, y: -0.5 * this.aspect, width: this.size[0], height: this.size[1] * this.aspect });
  }
  zoom(factor, at = { x: this.box.x + this.box.width / 2, y: this.box.y + this.box.height / 2 }) {
    const width = Math.min(Math.max(this.box.width * factor, 4), this.size[0] * 3), f = width / this.box.width;
    this.setBox({ x: at.x + (this.box.x - at.x) * f, y: at.y + (this.box.y - at.y) * f, width, height: this.box.height * f });
  }
  move(right, down) {
    this.setBox({ ...this.box, x: this.box.x + right * this.box.width, y: this.box.y + down * this.box.height });
  }
  /** Shows a region, with room around it. */
  show(points) {
    if (points.length === 0) return;
    const x = points.map(p => this.toSVG(p)[0]), y = points.map(p => this.toSVG(p)[1]);
    const [left, right, top, bottom] = [Math.min(...x), Math.max(...x), Math.min(...y), Math.max(...y)];
    const room = 0.25 * Math.max(right - left, bottom - top, 40);
    this.setBox({ x: left - room, y: top - room, width: right - left + 2 * room, height: bottom - top + 2 * room });
  }

  // ---- pointers: one drags what it took hold of, or the picture; two zoom --------------------------------------------

  onDown(event) {
    this.pane.focus({ preventScroll: true });
    this.pane.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, event);
    if (this.pointers.size === 2) {
      this.finishDrag(true);
      this.gesture = { kind: "pinch" };
    } else if (this.pointers.size === 1) {
      // What lies under the pointer: of a hand that is faster than the screen, under what its last click has made.
      const under = this.waiting ? (this.paintNow(), document.elementFromPoint(event.clientX, event.clientY)) : event.target;
      const target = under?.closest?.("[data-kind]");
      const takes = event.button === 0 && target && ["vertex", "landmark"].includes(target.dataset.kind);
      this.gesture = { kind: takes ? "drag" : "pan", target: target ? { ...target.dataset } : null, start: event, last: this.toUnits(event), moved: false, button: event.button };
    }
  }

  onMove(event) {
    this.dispatchEvent(new CustomEvent("hover", { detail: this.toPixel(event) }));
    const before = this.pointers.get(event.pointerId);
    if (!before || !this.gesture) return;
    if (this.gesture.kind === "pinch") {
      const others = [...this.pointers.values()].filter(pointer => pointer.pointerId !== event.pointerId);
      const [other] = others;
      const spread = pointer => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY) || 1;
      const middle = pointer => this.toUnits({ pointerType: pointer.pointerType, clientX: (pointer.clientX + other.clientX) / 2, clientY: (pointer.clientY + other.clientY) / 2 });
      const from = middle(before), to = middle(event);
      this.box.x += from.x - to.x;
      this.box.y += from.y - to.y;
      this.zoom(spread(before) / spread(event), from);
    } else {
      // A hand that clicks moves a little; a finger more.
      const slack = event.pointerType === "touch" ? 8 : 3;
      const { start } = this.gesture;
      if (!this.gesture.moved && Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) > slack) {
        this.gesture.moved = true;
        if (this.gesture.kind === "drag") {
          this.gesture.grabbed = this.toPixel(start);
          this.dispatchEvent(new CustomEvent("grab", { detail: this.gesture.target }));
        }
      }
      if (this.gesture.moved && this.gesture.kind === "drag") {
        const at = this.toPixel(event);
        this.dispatchEvent(new CustomEvent("drag", { detail: [at[0] - this.gesture.grabbed[0], at[1] - this.gesture.grabbed[1]] }));
      } else if (this.gesture.moved) {
        const now = this.toUnits(event);
        this.setBox({ ...this.box, x: this.box.x + this.gesture.last.x - now.x, y: this.box.y + this.gesture.last.y - now.y });
        this.gesture.last = this.toUnits(event);
      }
    }
    this.pointers.set(event.pointerId, event);
  }

  onUp(event, cancelled) {
    if (!this.pointers.delete(event.pointerId) || !this.gesture) return;
    if (this.gesture.kind !== "pinch") {
      if (this.gesture.kind === "drag" && this.gesture.moved) this.finishDrag(cancelled);
      else if (!this.gesture.moved && !cancelled && this.gesture.button === 0)
        // Where it was pressed: what the hand did after that it did not mean.
        this.dispatchEvent(new CustomEvent("press", { detail: { at: this.toPixel(this.gesture.start), target: this.gesture.target, event } }));
    }
    if (this.pointers.size === 0) this.gesture = null;
  }

  finishDrag(cancelled) {
    if (this.gesture?.kind === "drag" && this.gesture.moved) this.dispatchEvent(new CustomEvent("release", { detail: { cancelled } }));
  }

  // ---- drawing -------------------------------------------------------------------------------------------------------

  /** Sets what redraw() calls, which gets a pen for each of the two layers and the size of a screen's pixel. */
  setPainter(paint) {
    this.paint = paint;
    this.redraw();
  }

  redraw() {
    if (this.paint && !this.waiting) this.waiting = requestAnimationFrame(() => this.paintNow());
  }

  paintNow() {
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    const scale = this.scale;
    const layers = Object.fromEntries(["drafts", "drawing", "aim"].map(id => [id, new Pen(this, scale)]));
    this.paint(layers, scale);
    for (const [id, pen] of Object.entries(layers)) this.svg.querySelector(`#${id}`).replaceChildren(...pen.elements);
  }
}

/** Makes the elements of one layer. Lengths in pixels of the screen, places in pixels of the radiograph. */
class Pen {
  constructor(picture, scale) {
    this.picture = picture;
    this.scale = scale;
    this.elements = [];
  }
  add(name, className, attributes, data = {}) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    element.setAttribute("class", className);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    Object.assign(element.dataset, data);
    this.elements.push(element);
    return element;
  }
  line(className, points, closed = false, data = {}) {
    const text = points.map(point => this.picture.toSVG(point).join(",")).join(" L");
    return this.add("path", className, { d: `M${text}${closed ? "Z" : ""}` }, data);
  }
  circle(className, point, radius, data = {}) {
    const [x, y] = this.picture.toSVG(point);
    return this.add("circle", className, { cx: x, cy: y, r: radius * this.scale }, data);
  }
  cross(className, point, arm) {
    const [x, y] = this.picture.toSVG(point), a = arm * this.scale, gap = a * 0.3;
    return this.add("path", className, { d: `M${x - a},${y}H${x - gap}M${x + gap},${y}H${x + a}M${x},${y - a}V${y - gap}M${x},${y + gap}V${y + a}` });
  }
  text(point, text, right = 9, down = -7) {
    const [x, y] = this.picture.toSVG(point);
    const element = this.add("text", "name", { x: x + right * this.scale, y: y + down * this.scale, "font-size": 13 * this.scale });
    element.textContent = text;
  }
}
