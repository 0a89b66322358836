// The picture: renderer, camera, grid, and what a click hits.

import {
  AmbientLight,
  Box3,
  Box3Helper,
  Color,
  DirectionalLight,
  GridHelper,
  Group,
  type Intersection,
  InstancedMesh,
  Line,
  Mesh,
  Object3D,
  OrthographicCamera,
  PerspectiveCamera,
  Raycaster,
  Sphere,
  Sprite,
  Vector2,
  Vector3,
  WebGLRenderer,
  Scene as World,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { label, meters } from "./labels";

Object3D.DEFAULT_UP.set(0, 0, 1); // as robots have it

/** Where the camera looks from. */
export const VIEWS: Record<string, Vector3> = {
  Fit: new Vector3(1, -0.75, 0.6),
  Front: new Vector3(1, 0, 0.001),
  Left: new Vector3(0, 1, 0.001),
  Top: new Vector3(-0.001, 0, 1),
};
const SMALLEST = 0.05; // m; what is smaller is not made larger
const FARTHEST = 1e7; // m; what is farther or larger is not looked at
const MARKED = 0xf08c00;

/** What is visible of an object and takes up room: no words, no lights, and no planes, which are infinite. */
function visibleBounds(object: Object3D, all = new Box3()): Box3 {
  if (!object.visible || object instanceof Sprite || object.userData.isAside) return all;
  const own = new Box3();
  if (object instanceof InstancedMesh) {
    if (!object.boundingBox) object.computeBoundingBox();
    own.copy(object.boundingBox as Box3);
  } else if (object instanceof Mesh || object instanceof Line) {
    if (!object.geometry.boundingBox) object.geometry.computeBoundingBox();
    own.copy(object.geometry.boundingBox as Box3);
  }
  own.applyMatrix4(object.matrixWorld);
  if (own.getSize(new Vector3()).length() < FARTHEST && own.getCenter(new Vector3()).length() < FARTHEST) all.union(own);
  for (const child of object.children) visibleBounds(child, all);
  return all;
}

/** What is under the pointer. */
export interface Hit {
  /** The group of the link. */
  link: Object3D;
  point: Vector3;
}

const dark = matchMedia("(prefers-color-scheme: dark)");

export class Stage {
  readonly content = new Group();
  /** What is drawn over the robots, such as measures. */
  readonly notes = new Group();
  /** The side of a cell of the grid (m). */
  cell = 1;
  /** Called when the camera was put elsewhere. */
  onLook: () => void = () => {};
  /** Called when a person has put it elsewhere. */
  onTurn: () => void = () => {};
  private readonly world = new World();
  private readonly deep = new PerspectiveCamera(45, 1, 0.01, 1000);
  private readonly flat = new OrthographicCamera();
  private camera: PerspectiveCamera | OrthographicCamera = this.deep;
  readonly controls: OrbitControls;
  private readonly renderer: WebGLRenderer | null;
  private grid: GridHelper | null = null;
  /** What the selected part takes up. */
  marked: Box3 | null = null;
  private marker: Group | null = null;
  private isWaiting = false;
  /** How large what is looked at is (m). */
  private size = 1;
  private isDark = false;
  /** Whether the camera is where a person has put it. */
  isHeld = false;

  /** `isSmooth`: edges are, at twice the work. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly isSmooth: boolean,
  ) {
    const ground = (): void => {
      this.paint(dark.matches);
      this.draw();
    };
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, -3, 5);
    this.world.add(new AmbientLight(0xffffff, 1.4), sun, this.content, this.notes);
    this.renderer = this.made();
    this.controls = new OrbitControls(this.camera, canvas);
    let isTurned = false;
    this.controls.addEventListener("start", () => {
      isTurned = true;
    });
    this.controls.addEventListener("end", () => {
      isTurned = false;
      this.onTurn();
    });
    this.controls.addEventListener("change", () => {
      this.isHeld ||= isTurned;
      this.draw();
    });
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement as HTMLElement);
    dark.addEventListener("change", ground);
    ground();
  }

  /** Takes all robots away; the camera stays. */
  clear(): void {
    this.mark([]);
    this.content.traverse((part) => {
      if (part instanceof Mesh || part instanceof Line) part.geometry.dispose();
      if (part instanceof Sprite) part.material.map?.dispose();
    });
    this.content.clear();
    this.notes.clear();
  }

  private made(): WebGLRenderer | null {
    try {
      const renderer = new WebGLRenderer({ canvas: this.canvas, antialias: this.isSmooth });
      renderer.debug.checkShaderErrors = false; // it would wait for the graphics card
      return renderer;
    } catch {
      return null;
    }
  }

  /** Whether the browser can draw in three dimensions. */
  get works(): boolean {
    return this.renderer !== null;
  }

  /** Draws soon. */
  draw(): void {
    if (this.isWaiting || !this.renderer) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.drawNow();
    });
  }

  /** Draws; returns how many drawing calls that took. */
  drawNow(): number {
    this.renderer?.render(this.world, this.camera);
    return this.renderer?.info.render.calls ?? 0;
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement as HTMLElement;
    if (!clientWidth || !clientHeight) return;
    this.renderer?.setSize(clientWidth, clientHeight, false);
    this.deep.aspect = clientWidth / clientHeight;
    this.project();
    if (!this.isHeld) this.look();
    this.drawNow();
  }

  /** Takes over what the perspective camera sees at the distance of its target. */
  private project(): void {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const half = distance * Math.tan(((this.deep.fov / 2) * Math.PI) / 180);
    Object.assign(this.flat, { top: half, bottom: -half, right: half * this.deep.aspect, left: -half * this.deep.aspect });
    for (const camera of [this.deep, this.flat]) camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld(); // what is under the pointer is asked for before the next picture
  }

  get isFlat(): boolean {
    return this.camera === this.flat;
  }

  /** Draws without or with perspective, as large as before. */
  setFlat(isFlat: boolean): void {
    if (isFlat === this.isFlat) return;
    const { target } = this.controls;
    const from = this.camera;
    const to = isFlat ? this.flat : this.deep;
    to.position.copy(from.position).sub(target).divideScalar(isFlat ? 1 : from.zoom).add(target);
    this.flat.zoom = 1;
    this.camera = to;
    this.controls.object = to;
    this.setDepth();
    this.controls.update();
    this.project();
    this.draw();
  }

  private setDepth(): void {
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.deep.near = distance / 500;
    this.flat.near = -distance * 50;
    this.deep.far = this.flat.far = distance * 50;
  }

  /** Shows all that is visible, or a part of it, from a side, unless a person holds the camera (``force`` lets go of it). */
  look(from: Vector3 = VIEWS.Fit, force = false, part: Box3 | null = null): void {
    if (this.isHeld && !force) return;
    if (force) this.isHeld = part !== null;
    this.content.updateMatrixWorld(true);
    const bounds = part ?? visibleBounds(this.content);
    if (bounds.isEmpty()) bounds.set(new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 1));
    const { center, radius } = bounds.getBoundingSphere(new Sphere());
    const size = Math.max(radius, SMALLEST);
    const distance = (size * 0.95) / Math.sin(((this.deep.fov / 2) * Math.PI) / 180) / Math.min(this.deep.aspect, 1);
    this.put(center.clone().addScaledVector(from.clone().normalize(), distance), center, 1);
    this.lay(size);
    this.onLook();
  }

  /** Looks from a side at what is looked at. */
  lookAt(part: Box3): void {
    this.look(this.camera.position.clone().sub(this.controls.target), true, part);
  }

  private put(position: Vector3, target: Vector3, zoom: number): void {
    this.camera.position.copy(position);
    this.camera.zoom = zoom;
    this.controls.target.copy(target);
    this.setDepth();
    this.controls.update();
    this.project();
    this.draw();
  }

  /** Where the camera is, what it looks at, and how near. */
  seen(): number[] {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray(), this.camera.zoom];
  }

  /** Puts the camera where it was, as {@link seen} has it. */
  see(seen: number[]): void {
    this.look(VIEWS.Fit, true);
    this.isHeld = true;
    this.put(new Vector3(...seen.slice(0, 3)), new Vector3(...seen.slice(3, 6)), seen[6]);
  }

  private paint(isDark: boolean): void {
    this.isDark = isDark;
    this.world.background = new Color(isDark ? 0x1b1e23 : 0xf4f5f7);
    this.lay(this.size);
  }

  /** The picture as paper has it, as an address with data in it. */
  picture(): string {
    const { isDark } = this;
    this.paint(false);
    this.world.background = new Color(0xffffff);
    this.drawNow();
    const picture = this.canvas.toDataURL();
    this.paint(isDark);
    this.draw();
    return picture;
  }

  /** Lays a grid with cells of 1, 2 or 5 times a power of ten under what is shown. */
  private lay(size: number): void {
    this.size = size;
    const wanted = size / 6;
    const power = 10 ** Math.floor(Math.log10(wanted));
    this.cell = power * ([1, 2, 5].find((step) => step * power >= wanted) ?? 10);
    if (this.grid) this.world.remove(this.grid);
    const [middle, others] = this.isDark ? [0x6c757d, 0x343a40] : [0x868e96, 0xced4da];
    this.grid = new GridHelper(this.cell * 24, 24, middle, others).rotateX(Math.PI / 2);
    const { x, y } = this.controls.target;
    this.grid.position.set(Math.round(x / this.cell) * this.cell, Math.round(y / this.cell) * this.cell, 0);
    this.world.add(this.grid);
  }

  /** Marks what parts take up, each with its name and size. */
  mark(parts: [string, Box3][]): void {
    if (this.marker) this.world.remove(this.marker);
    this.marker = null;
    this.marked = parts.length ? parts[0][1] : null;
    if (parts.length) {
      this.marker = new Group();
      for (const [name, bounds] of parts) {
        const box = bounds.isEmpty() ? new Box3(new Vector3(), new Vector3()) : bounds;
        const size = box.getSize(new Vector3()).toArray().map(meters).join(" × ");
        const words = label(bounds.isEmpty() ? name : `${name}: ${size} m`, "#6b3a00");
        words.position.copy(box.getCenter(new Vector3())).setZ(box.max.z);
        this.marker.add(new Box3Helper(box, new Color(MARKED)), words);
      }
      this.world.add(this.marker);
    }
    this.draw();
  }

  /** Where a point of the world is on the screen (pixels). */
  onScreen(point: Vector3): number[] {
    const { x, y } = point.clone().project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return [box.left + ((x + 1) / 2) * box.width, box.top + ((1 - y) / 2) * box.height];
  }

  /** The ray of the eye through a point of the screen. */
  rayAt(x: number, y: number): Raycaster {
    const box = this.canvas.getBoundingClientRect();
    const ray = new Raycaster();
    ray.setFromCamera(
      new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2),
      this.camera,
    );
    return ray;
  }

  /** The nearest shape at a point of the screen. */
  hitAt(x: number, y: number): Hit | null {
    const shapes: Object3D[] = [];
    const gather = (part: Object3D): void => {
      if (!part.visible || part.userData.isMarker) return;
      if (part instanceof Mesh) shapes.push(part);
      part.children.forEach(gather);
    };
    gather(this.content);
    for (const hit of this.rayAt(x, y).intersectObjects(shapes, false)) {
      const link = linkOf(hit);
      if (link) return { link, point: hit.point };
    }
    return null;
  }
}

function linkOf({ object, instanceId }: Intersection): Object3D | null {
  if (instanceId !== undefined) return (object.userData.links as Object3D[])[instanceId];
  let at: Object3D | null = object;
  while (at && typeof at.userData.link !== "string") at = at.parent;
  return at;
}
