// The scans, the X-ray source and the detector in space, by three.js. Cephalostat frame: x anterior, y patient's left,
// z superior, mm; that is right-handed with z up, which three.js is told.
import {
  AmbientLight, Box3, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, FrontSide, Group, Line, LineBasicMaterial, LineDashedMaterial,
  LineSegments, Mesh, MeshBasicMaterial, MeshStandardMaterial, PerspectiveCamera, PlaneGeometry, Scene, SphereGeometry, SRGBColorSpace, Texture, Vector3,
  WebGLRenderer, Matrix4,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const bytesOf = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer;

/** A scan as itkScanForPage packed it. */
function makeScan(packed, colour) {
  const numbers = new Uint16Array(bytesOf(packed.points));
  const points = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; ++i) points[i] = packed.origin[i % 3] + packed.step * numbers[i];
  const buffer = bytesOf(packed.triangles);
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setIndex(new BufferAttribute(packed.wide ? new Uint32Array(buffer) : new Uint16Array(buffer), 1));
  geometry.computeVertexNormals();
  return new Mesh(geometry, new MeshStandardMaterial({ color: colour, roughness: 0.7, metalness: 0, side: DoubleSide }));
}

/** A 3x4 of rows. */
const toMatrix = rows => new Matrix4().set(...rows[0], ...rows[1], ...rows[2], 0, 0, 0, 1);

/** Source, detector, and where pixels lie on it, as the toolkit has computed them: seen from the source scans lie on their
 * shadows, whatever the preset and the view. */
class Space {
  constructor({ source, centre, corners }, size) {
    this.source = new Vector3(...source);
    this.centre = new Vector3(...centre);
    this.corners = corners.map(corner => new Vector3(...corner));
    const [origin, right, , down] = this.corners;
    // Corners are edges of pixels.
    this.u = right.clone().sub(origin).divideScalar(size[0]);
    this.v = down.clone().sub(origin).divideScalar(size[1]);
    this.length = this.source.distanceTo(this.centre);
    /** Towards the source. */
    this.back = this.source.clone().sub(this.centre).normalize();
  }

  at(u, v) {
    return this.corners[0].clone().addScaledVector(this.u, u + 0.5).addScaledVector(this.v, v + 0.5);
  }
}

/** The radiograph on its detector. */
function makePlate({ corners }, image) {
  const shape = new BufferGeometry();
  shape.setAttribute("position", new BufferAttribute(new Float32Array(corners.flatMap(corner => corner.toArray())), 3));
  shape.setAttribute("uv", new BufferAttribute(new Float32Array([0, 1, 1, 1, 1, 0, 0, 0]), 2));
  shape.setIndex([0, 1, 2, 0, 2, 3]);
  if (image) {
    const texture = new Texture(image);
    texture.colorSpace = SRGBColorSpace;
    texture.needsUpdate = true;
    return new Mesh(shape, new MeshBasicMaterial({ map: texture, side: DoubleSide }));
  }
  return new Mesh(shape, new MeshBasicMaterial({ color: 0x30343a, side: DoubleSide }));
}

const makeBorder = ({ corners }) =>
  new Line(new BufferGeometry().setFromPoints([...corners, corners[0]]), new LineBasicMaterial({ color: 0x888888 }));

/** Lines of the tracing and of the matched outline, just before the detector. */
function drawLines(view, space) {
  const group = new Group();
  const add = (points, closed, colour) => {
    const line = (closed ? [...points, points[0]] : points).map(([u, v]) => space.at(u, v).addScaledVector(space.back, 0.4));
    group.add(new Line(new BufferGeometry().setFromPoints(line), new LineBasicMaterial({ color: colour })));
  };
  for (const drawing of Object.values(view.jaws)) {
    for (const stretch of drawing.contours?.matched ?? drawing.contours?.whole ?? []) add(stretch.points, stretch.closed, 0xe69f00);
    for (const stretch of drawing.tracing ?? []) add(stretch.points, stretch.closed, 0x56b4e9);
  }
  return group;
}

/** Midsagittal and occlusal plane of a jaw's dental axis, and its axes. */
function makePlanes(jaw) {
  const group = new Group();
  const material = new MeshBasicMaterial({ color: 0x4f9bd9, transparent: true, opacity: 0.14, side: DoubleSide, depthWrite: false });
  const occlusal = new Mesh(new PlaneGeometry(80, 80), material);
  const sagittal = new Mesh(new PlaneGeometry(80, 44), material);
  sagittal.rotation.x = Math.PI / 2;
  group.add(occlusal, sagittal);
  const axes = new BufferGeometry().setFromPoints([new Vector3(0, 0, 0), new Vector3(38, 0, 0), new Vector3(0, 0, 0), new Vector3(0, 24, 0), new Vector3(0, 0, 0), new Vector3(0, 0, 24)]);
  group.add(new LineSegments(axes, new LineBasicMaterial({ color: 0x4f9bd9 })));
  group.applyMatrix4(toMatrix(jaw.mesh_to_cephalostat_mm).multiply(toMatrix(jaw.mesh_to_umda_mm).invert()));
  return group;
}

class SceneView {
  constructor(data, canvas) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.scene = new Scene();
    this.scene.background = new Color(0x101114);
    this.camera = new PerspectiveCamera(30, 1, 1, 20000);
    this.camera.up.set(0, 0, 1);
    // One for each radiograph, null where it has no place; a result without report.json has none.
    this.spaces = data.spaces.map((space, i) => (space ? new Space(space, data.details.views[i].image_size) : null));
    this.space = this.spaces.find(space => space) ?? null;
    this.parts = {};
    this.hidden = new Set();
    this.plates = [];
    this.build(data);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableZoom = false;
    this.controls.addEventListener("change", () => this.draw());
    // As with the picture: only where somebody works with it does the wheel zoom.
    canvas.addEventListener("wheel", event => {
      if (document.activeElement !== canvas && !event.ctrlKey) return;
      event.preventDefault();
      this.approach(Math.exp(event.deltaY * 0.0015));
    }, { passive: false });
    canvas.addEventListener("keydown", event => this.onKey(event));
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    for (const button of document.querySelectorAll("button[data-camera]")) button.addEventListener("click", () => this.look(button.dataset.camera));
    for (const input of document.querySelectorAll("input[data-part]"))
      input.addEventListener("change", () => { this.hidden[input.checked ? "delete" : "add"](input.dataset.part); this.draw(); });
    document.querySelector("input[data-scene=opacity]")?.addEventListener("input", event => { this.fade(Number(event.target.value)); this.draw(); });
    new ResizeObserver(() => this.draw()).observe(canvas);
    this.look("front");
  }

  add(name, object) {
    (this.parts[name] ??= []).push(object);
    this.scene.add(object);
  }

  /** What is switched on; and of the detectors those that are looked at from the source's side: from behind there is their frame
   * alone, since one that stands in front of the face would hide it; and what a source sees is on its own detector. */
  updateVisibility() {
    for (const [name, objects] of Object.entries(this.parts))
      for (const object of objects) object.visible = !this.hidden.has(name);
    for (const { plate, space } of this.plates)
      plate.visible &&= (this.seen ?? space) === space && this.camera.position.clone().sub(space.centre).dot(space.back) > 0;
  }

  build(data) {
    this.scene.add(new AmbientLight(0xffffff, 1.1));
    this.light = new DirectionalLight(0xffffff, 2.2);
    this.scene.add(this.light);
    const centre = new Vector3();
    let count = 0;
    for (const [jaw, packed] of Object.entries(data.scans)) {
      const mesh = makeScan(packed, jaw === "upper" ? 0xf2e6d0 : 0xd7e4f2);
      mesh.geometry.computeBoundingBox();
      centre.add(mesh.geometry.boundingBox.getCenter(new Vector3()));
      ++count;
      this.add(jaw, mesh);
    }
    this.centre = centre.divideScalar(Math.max(1, count));
    for (const jaw of Object.values(data.result.jaws))
      if (jaw.mesh_to_umda_mm && jaw.mesh_to_cephalostat_mm) this.add("planes", makePlanes(jaw));
    // Without a detector there are the scans alone.
    const pictures = document.querySelectorAll(".view");
    this.spaces.forEach((space, i) => {
      // The picture's own radiograph: it stands in the page once.
      if (space) this.buildView(data.details.views[i], space, pictures[i]?.querySelector("image.radiograph"));
    });
  }

  /** Source, central ray and detector of a radiograph. */
  buildView(view, space, image) {
    const { source, centre: foot } = space, size = view.image_size;
    const ray = new Line(new BufferGeometry().setFromPoints([source, foot]), new LineDashedMaterial({ color: 0xf0e442, dashSize: 8, gapSize: 5 }));
    ray.computeLineDistances();
    this.add("ray", ray);
    const ball = new Mesh(new SphereGeometry(18, 24, 16), new MeshBasicMaterial({ color: 0xf0e442 }));
    ball.position.copy(source);
    this.add("ray", ball);
    this.add("detector", makeBorder(space));
    const put = picture => {
      const plate = new Group();
      plate.add(makePlate(space, picture), drawLines(view, space));
      this.plates.push({ plate, space });
      this.add("detector", plate);
    };
    if (!image) {
      put(null);
      return;
    }
    const loaded = new Image();
    loaded.addEventListener("load", () => {
      // A few columns beyond the radiograph's own may be in it, where it was shrunk: they are cut off.
      const canvas = document.createElement("canvas");
      const covered = [image.width.baseVal.value, image.height.baseVal.value];
      canvas.width = Math.round(loaded.naturalWidth * size[0] / covered[0]);
      canvas.height = Math.round(loaded.naturalHeight * size[1] / covered[1]);
      canvas.getContext("2d").drawImage(loaded, 0, 0);
      put(canvas);
      this.draw();
    });
    loaded.src = image.href.baseVal;
  }

  fade(opacity) {
    for (const jaw of ["upper", "lower"])
      for (const scan of this.parts[jaw] ?? []) {
        scan.material.transparent = opacity < 1;
        scan.material.opacity = opacity;
        // Through a pane one sees the nearest surface alone: inner walls would be drawn in any order.
        scan.material.side = opacity < 1 ? FrontSide : DoubleSide;
        scan.material.needsUpdate = true;
      }
    const slider = document.querySelector("input[data-scene=opacity]");
    if (slider) slider.value = opacity;
  }

  look(from) {
    const target = this.centre.clone();
    // On the source's side of the midsagittal plane: the detector would hide the scans from the other one.
    const side = Math.sign(-(this.space?.back.y ?? -1));
    const views = {
      front: [new Vector3(1, -0.18 * side, 0.12), 290, 30], side: [new Vector3(0, -side, 0.02), 260, 30],
      above: [new Vector3(0.25, 0, 1), 260, 30], all: [new Vector3(1, -0.25 * side, 0.35), 0, 40],
    };
    const seen = (this.seen = this.spaces[Number(/^source-(\d+)$/.exec(from)?.[1] ?? NaN)] ?? null);
    if (seen) {
      // A narrow lens far away: all rays are those of the X-rays.
      this.camera.position.copy(seen.source);
      this.camera.fov = 2 * Math.atan(48 / seen.source.distanceTo(target)) * 180 / Math.PI;
    } else {
      let [direction, distance, angle] = views[from] ?? views.side;
      if (from === "all") {
        const all = new Box3().setFromPoints(this.spaces.flatMap(space => (space ? [space.source, space.centre] : [])));
        if (!all.isEmpty()) all.getCenter(target);
        distance = this.distanceOf(all.isEmpty() ? 300 : all.getSize(new Vector3()).length());
      }
      this.camera.position.copy(target).addScaledVector(direction.normalize(), distance);
      this.camera.fov = angle;
    }
    // Seen from the source the radiograph is behind the scans.
    this.fade(seen ? 0.5 : 1);
    this.controls.target.copy(target);
    this.controls.update();
    this.draw();
  }

  /** From where a length is as wide as the canvas, with a lens of 40 degrees. */
  distanceOf(length) {
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    return 0.62 * length / (Math.tan(20 * Math.PI / 180) * Math.max(0.3, aspect)) + 200;
  }

  approach(factor) {
    // By the lens: whoever looks from the source stays there.
    this.camera.fov = Math.min(60, Math.max(0.6, this.camera.fov * factor));
    this.draw();
  }

  turn(around, up) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.applyAxisAngle(new Vector3(0, 0, 1), around);
    const tilt = Math.asin(Math.min(1, Math.max(-1, arm.z / arm.length()))) + up;
    if (Math.abs(tilt) < 1.5) arm.applyAxisAngle(new Vector3(0, 0, 1).cross(arm).normalize(), -up);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.draw();
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const keys = {
      ArrowLeft: () => this.turn(-0.1, 0), ArrowRight: () => this.turn(0.1, 0), ArrowUp: () => this.turn(0, 0.1), ArrowDown: () => this.turn(0, -0.1),
      "+": () => this.approach(0.85), "=": () => this.approach(0.85), "-": () => this.approach(1.18),
    };
    if (keys[event.key]) {
      event.preventDefault();
      keys[event.key]();
    }
  }

  draw() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width || !height) return;
    const size = this.renderer.getSize({ set(x, y) { this.x = x; this.y = y; return this; }, x: 0, y: 0 });
    if (size.x !== width || size.y !== height) this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    // The lamp is with whoever looks.
    this.light.position.copy(this.camera.position).addScaledVector(new Vector3(0, 0, 1), 60);
    this.light.target.position.copy(this.controls?.target ?? this.centre);
    this.light.target.updateMatrixWorld();
    this.updateVisibility();
    this.renderer.render(this.scene, this.camera);
  }
}

export function drawScene(data) {
  const canvas = document.getElementById("scene-canvas");
  if (!canvas) return;
  try {
    new SceneView(data, canvas);
  } catch (error) {
    document.getElementById("scene-message").textContent = `This browser does not draw in space (WebGL): ${error.message}`;
  }
}
