// The picture: renderer, camera, grid, and what a click hits.

import {
  AmbientLight,
  Box3,
  Box3Helper,
  Color,
  DirectionalLight,
  GridHelper,
  Group,
  InstancedMesh,
  Line,
  Mesh,
  Object3D,
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

export class Stage {
  readonly content = new Group();
  /** The side of a cell of the grid (m). */
  cell = 1;
  /** Called when the camera was put elsewhere. */
  onLook: () => void = () => {};
  private readonly world = new World();
  private readonly camera = new PerspectiveCamera(45, 1, 0.01, 1000);
  private readonly controls: OrbitControls;
  private readonly renderer: WebGLRenderer | null;
  private grid: GridHelper | null = null;
  /** What the selected part takes up. */
  marked: Box3 | null = null;
  private marker: Group | null = null;
  private isWaiting = false;
  /** Whether the camera is where a person has put it. */
  private isHeld = false;
  /** Called with the group of the link that a click hits. */
  onPick: (link: Object3D) => void = () => {};

  /** `isSmooth`: edges are, at twice the work. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly isSmooth: boolean,
  ) {
    this.world.background = new Color(matchMedia("(prefers-color-scheme: dark)").matches ? 0x1b1e23 : 0xf4f5f7);
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(2, -3, 5);
    this.world.add(new AmbientLight(0xffffff, 1.4), sun, this.content);
    this.renderer = this.made();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("start", () => {
      this.isHeld = true;
    });
    addEventListener("resize", () => this.resize());
    this.listen();
  }

  /** Takes all robots away; the camera stays. */
  clear(): void {
    this.mark([]);
    this.content.traverse((part) => {
      if (part instanceof Mesh || part instanceof Line) part.geometry.dispose();
      if (part instanceof Sprite) part.material.map?.dispose();
    });
    this.content.clear();
  }

  private made(): WebGLRenderer | null {
    try {
      return new WebGLRenderer({ canvas: this.canvas, antialias: this.isSmooth });
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
    this.renderer?.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / Math.max(clientHeight, 1);
    this.camera.updateProjectionMatrix();
    if (!this.isHeld) this.look();
    this.draw();
  }

  /** Shows all that is visible from a side, unless a person holds the camera (``force`` lets go of it). */
  look(from: Vector3 = VIEWS.Fit, force = false): void {
    if (this.isHeld && !force) return;
    if (force) this.isHeld = false;
    this.content.updateMatrixWorld(true);
    const bounds = visibleBounds(this.content);
    if (bounds.isEmpty()) bounds.set(new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 1));
    const { center, radius } = bounds.getBoundingSphere(new Sphere());
    const size = Math.max(radius, SMALLEST);
    const narrow = Math.min(this.camera.aspect, 1);
    const distance = (size * 0.95) / Math.sin(((this.camera.fov / 2) * Math.PI) / 180) / narrow;
    this.camera.position.copy(center).addScaledVector(from.clone().normalize(), distance);
    this.camera.near = distance / 500;
    this.camera.far = distance * 50;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(center);
    this.controls.update();
    this.lay(size);
    this.onLook();
    this.draw();
  }

  /** Lays a grid with cells of 1, 2 or 5 times a power of ten under what is shown. */
  private lay(size: number): void {
    const wanted = size / 6;
    const power = 10 ** Math.floor(Math.log10(wanted));
    this.cell = power * ([1, 2, 5].find((step) => step * power >= wanted) ?? 10);
    if (this.grid) this.world.remove(this.grid);
    this.grid = new GridHelper(this.cell * 24, 24, 0x868e96, 0xced4da).rotateX(Math.PI / 2);
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

  /** Where the camera is and what it looks at. */
  seen(): number[] {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  /** Where a point of the world is on the screen (pixels). */
  onScreen(point: Vector3): number[] {
    const { x, y } = point.clone().project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return [box.left + ((x + 1) / 2) * box.width, box.top + ((1 - y) / 2) * box.height];
  }

  private listen(): void {
    let pressed = new Vector2();
    this.canvas.addEventListener("pointerdown", (event) => {
      pressed = new Vector2(event.clientX, event.clientY);
    });
    this.canvas.addEventListener("pointerup", (event) => {
      if (pressed.distanceTo(new Vector2(event.clientX, event.clientY)) > 4) return;
      const link = this.linkAt(event.clientX, event.clientY);
      if (link) this.onPick(link);
    });
  }

  private linkAt(x: number, y: number): Object3D | null {
    const box = this.canvas.getBoundingClientRect();
    const ray = new Raycaster();
    ray.setFromCamera(
      new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2),
      this.camera,
    );
    for (const hit of ray.intersectObject(this.content, true)) {
      if (hit.instanceId !== undefined && hit.object.visible)
        return (hit.object.userData.links as Object3D[])[hit.instanceId];
      let at: Object3D | null = hit.object;
      while (at?.visible && typeof at.userData.link !== "string") at = at.parent;
      if (at?.visible) return at;
    }
    return null;
  }
}
