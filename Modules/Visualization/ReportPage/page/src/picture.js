// Moves the picture: layers, zoom, flicker, teeth. Needs nothing but a browser, and imports nothing: where the toolkit was
// built without npm it is the page's whole script.

/** Tells the rest of the page which tooth is marked; detail is null where none is. */
const announce = detail => document.dispatchEvent(new CustomEvent("tooth", { detail }));

class PictureView {
  constructor(root) {
    this.root = root;
    this.svg = root.querySelector("svg.picture");
    this.pane = root.querySelector(".pane");
    this.box = this.svg.viewBox.baseVal;
    this.flickering = 0;
    for (const input of root.querySelectorAll("input[data-layer]"))
      input.addEventListener("change", () => this.show(input.dataset.layer, input.checked));
    for (const control of root.querySelectorAll("[data-action]"))
      control.addEventListener(control.tagName === "BUTTON" ? "click" : "input", () => this.act(control.dataset.action, control));
    this.pane.addEventListener("keydown", event => this.onKey(event));
    // Only where somebody works with the picture does the wheel zoom: elsewhere it scrolls the page.
    this.pane.addEventListener("wheel", event => {
      if (document.activeElement !== this.pane && !event.ctrlKey) return;
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.0015), this.toPicture(event));
    }, { passive: false });
    this.pane.addEventListener("pointerdown", event => this.onDown(event));
    for (const path of this.svg.querySelectorAll("path.tracing[data-tooth]"))
      path.addEventListener("click", () => chooseTooth(path.dataset.jaw, path.dataset.tooth));
    for (const action of ["brightness", "drr"]) {
      const control = root.querySelector(`[data-action=${action}]`);
      if (control) this.act(action, control);
    }
  }

  layer(key) {
    return [...this.svg.querySelectorAll("g.layer")].find(group => group.dataset.layer === key);
  }

  show(key, shown) {
    this.layer(key)?.toggleAttribute("hidden", !shown);
    for (const input of this.root.querySelectorAll("input[data-layer]"))
      if (input.dataset.layer === key) input.checked = shown;
    document.dispatchEvent(new CustomEvent("layer", { detail: { key, shown } }));
  }

  act(action, control) {
    if (action === "in") this.zoom(0.7);
    else if (action === "out") this.zoom(1 / 0.7);
    else if (action === "home" || action === "all") this.setBox(this.svg.dataset[action]);
    else if (action === "opacity") this.svg.querySelector(".drawing").style.opacity = control.value;
    else if (action === "brightness") this.svg.querySelector(".radiograph")?.style.setProperty("opacity", control.value);
    else if (action === "drr") this.svg.querySelector(".drr")?.style.setProperty("opacity", control.value);
    else if (action === "peek") this.press(control, on => this.svg.classList.toggle("peek", on));
    else if (action === "flicker") this.press(control, on => this.flicker(on));
    else if (action === "stage" && this.flickering) this.flicker(true);
  }

  press(button, apply) {
    const on = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(on));
    apply(on);
  }

  /** The outline of the chosen stage and that of the result, in turns; at once and once where motion is unwelcome. */
  flicker(on) {
    clearInterval(this.flickering);
    this.flickering = 0;
    this.swap(false);
    if (!on) return;
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    let before = true;
    this.swap(before);
    this.flickering = calm ? -1 : setInterval(() => { before = !before; this.swap(before); }, 600);
  }

  swap(before) {
    const chosen = this.root.querySelector("[data-action=stage]")?.value;
    this.svg.classList.toggle("flick", before);
    for (const input of this.root.querySelectorAll("input[data-layer^=stage-]"))
      this.layer(input.dataset.layer)?.toggleAttribute("hidden", !(before && input.dataset.layer === chosen) && !input.checked);
    // Where the whole silhouette is what a stage is drawn of, the result's takes turns with it.
    const whole = this.svg.dataset.after === "whole" && this.root.querySelector("input[data-layer=whole]");
    if (whole) this.layer("whole").toggleAttribute("hidden", before || !(whole.checked || this.flickering));
  }

  setBox(text) {
    this.svg.setAttribute("viewBox", text);
  }

  /** Where on the picture an event was, in the picture's units. */
  toPicture(event) {
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
    return { x: point.x, y: point.y };
  }

  zoom(factor, centre = { x: this.box.x + this.box.width / 2, y: this.box.y + this.box.height / 2 }) {
    const [, , width] = this.svg.dataset.all.split(" ").map(Number);
    const next = Math.min(Math.max(this.box.width * factor, width / 200), width * 3) / this.box.width;
    this.setBox([centre.x + (this.box.x - centre.x) * next, centre.y + (this.box.y - centre.y) * next,
      this.box.width * next, this.box.height * next].join(" "));
  }

  move(right, down) {
    this.setBox([this.box.x + right * this.box.width, this.box.y + down * this.box.height, this.box.width, this.box.height].join(" "));
  }

  onDown(event) {
    if (event.button !== 0) return;
    let last = this.toPicture(event);
    const drag = moved => {
      const now = this.toPicture(moved);
      this.setBox([this.box.x + last.x - now.x, this.box.y + last.y - now.y, this.box.width, this.box.height].join(" "));
      last = this.toPicture(moved);
    };
    const end = () => {
      this.pane.removeEventListener("pointermove", drag);
      for (const name of ["pointerup", "pointercancel"]) window.removeEventListener(name, end);
    };
    this.pane.addEventListener("pointermove", drag);
    for (const name of ["pointerup", "pointercancel"]) window.addEventListener(name, end);
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const keys = {
      ArrowLeft: () => this.move(-0.1, 0), ArrowRight: () => this.move(0.1, 0), ArrowUp: () => this.move(0, -0.1), ArrowDown: () => this.move(0, 0.1),
      "+": () => this.zoom(0.8), "=": () => this.zoom(0.8), "-": () => this.zoom(1.25), 0: () => this.act("home"),
      f: () => this.root.querySelector("[data-action=flicker]")?.click(), r: () => this.root.querySelector("[data-action=peek]")?.click(),
    };
    const found = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (found) {
      event.preventDefault();
      found();
    }
  }

  mark(chosen) {
    for (const path of this.svg.querySelectorAll("path.tracing"))
      path.classList.toggle("chosen", chosen !== null && path.dataset.jaw === chosen.jaw && path.dataset.tooth === chosen.tooth);
  }
}

let views = [];
let marked = null;

/** Marks a tooth in the pictures and in the table; the one that is marked already is let go. */
function chooseTooth(jaw, tooth) {
  marked = marked && marked.jaw === jaw && marked.tooth === tooth ? null : { jaw, tooth };
  for (const view of views) view.mark(marked);
  for (const element of document.querySelectorAll("#teeth [data-tooth]")) {
    const on = marked !== null && element.dataset.jaw === jaw && element.dataset.tooth === tooth;
    if (element.tagName === "TR") element.classList.toggle("chosen", on);
    else element.setAttribute("aria-pressed", String(on));
  }
  announce(marked);
}

document.documentElement.classList.add("scripted");
views = [...document.querySelectorAll(".view")].map(root => new PictureView(root));
for (const button of document.querySelectorAll("button.tooth"))
  button.addEventListener("click", () => chooseTooth(button.dataset.jaw, button.dataset.tooth));
document.addEventListener("choose-tooth", event => chooseTooth(event.detail.jaw, event.detail.tooth));
for (const button of document.querySelectorAll("button[data-show-layer]"))
  button.addEventListener("click", () => {
    const on = button.getAttribute("aria-pressed") !== "true";
    // Candidates of both jaws that share a pose are one layer: its buttons go together.
    for (const other of document.querySelectorAll("button[data-show-layer]"))
      if (other.dataset.showLayer === button.dataset.showLayer) other.setAttribute("aria-pressed", String(on));
    for (const view of views) view.show(button.dataset.showLayer, on);
  });
