// What a pointer does in the picture: it names parts, selects them, moves their joints, and measures.

import { BufferGeometry, Group, Line, LineBasicMaterial, Matrix4, Mesh, MeshBasicMaterial, Plane, SphereGeometry, Vector3 } from "three";
import type { Joint } from "./data";
import { moves, withFollowers } from "./kinematics";
import { label, meters } from "./labels";
import type { Robot } from "./robot";
import type { Hit, Stage } from "./stage";

const STILL = 4; // pixels that a pointer may move in a click
const INK = 0x1098ad;

/** What the page does about it. */
export interface Hand {
  /** Whether a drag moves joints. */
  readonly isMoving: boolean;
  readonly isMeasuring: boolean;
  pick(hit: Hit | null): void;
  name(hit: Hit): string;
  moved(robot: Robot, joint: Joint): void;
  measured(words: string): void;
}

/** A joint that follows the pointer: what it was at, and how far the pointer has moved it since. */
interface Grip {
  robot: Robot;
  joint: Joint;
  start: number;
  /** The way (rad, m) from where the pointer was to where it is. */
  way(x: number, y: number): number | null;
}

export class Pointer {
  private grip: Grip | null = null;
  private pressed: [number, number] | null = null;
  private last: [number, number] | null = null;
  private from: Vector3 | null = null;
  private readonly tip = document.getElementById("tip") as HTMLElement;

  hand: Hand | null = null;

  constructor(private readonly stage: Stage) {
    const { canvas } = stage;
    // Before the camera's own listeners: a drag of a joint does not turn it.
    canvas.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.release(event));
    canvas.addEventListener("pointercancel", () => this.letGo());
    canvas.addEventListener("pointerleave", () => this.hover(null));
  }

  private press(event: PointerEvent): void {
    this.pressed = [event.clientX, event.clientY];
    this.hover(null);
    if (event.button || !(this.hand?.isMoving || event.shiftKey)) return;
    const hit = this.stage.hitAt(event.clientX, event.clientY);
    this.grip = hit && gripOf(this.stage, hit, event);
    if (!this.grip) return;
    this.stage.controls.enabled = false;
    this.stage.canvas.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    const { clientX: x, clientY: y } = event;
    if (!this.grip) {
      if (!event.buttons) this.hover([x, y]);
      return;
    }
    const { robot, joint, start, way } = this.grip;
    const moved = way(x, y);
    if (moved === null) return;
    const { lower, upper } = joint.axes[0];
    const [low, high] = [lower ?? -Infinity, upper ?? Infinity].sort((a, b) => a - b);
    const at = Math.min(Math.max(start + moved, low), high);
    robot.positions.set(joint.name, [at, ...(robot.positions.get(joint.name) ?? [0, 0]).slice(1)]);
    this.hand?.moved(robot, joint);
  }

  private release(event: PointerEvent): void {
    const [x, y] = this.pressed ?? [Infinity, 0];
    this.letGo();
    if (Math.hypot(event.clientX - x, event.clientY - y) > STILL || event.button) return;
    const hit = this.stage.hitAt(event.clientX, event.clientY);
    if (this.hand?.isMeasuring) this.measure(hit);
    else this.hand?.pick(hit);
  }

  private letGo(): void {
    this.grip = null;
    this.pressed = null;
    this.stage.controls.enabled = true;
  }

  /** Names what is under the pointer, at most once for each picture. */
  private hover(at: [number, number] | null): void {
    const isWaiting = this.last !== null;
    this.last = at;
    if (!at) this.tip.hidden = true;
    else if (!isWaiting)
      requestAnimationFrame(() => {
        const place = this.last;
        this.last = null;
        const hit = place && this.stage.hitAt(...place);
        this.tip.hidden = !hit;
        this.stage.canvas.style.cursor = this.hand?.isMeasuring ? "crosshair" : hit ? "pointer" : "";
        if (!hit || !this.hand) return;
        this.tip.textContent = this.hand.name(hit);
        const box = (this.tip.offsetParent ?? this.stage.canvas).getBoundingClientRect();
        const [x, y] = [place[0] - box.left, place[1] - box.top];
        this.tip.style.left = `${Math.min(x + 14, box.width - this.tip.offsetWidth - 4)}px`;
        this.tip.style.top = `${Math.min(y + 14, box.height - this.tip.offsetHeight - 4)}px`;
      });
  }

  /** Takes a point; with the second one says how far they are apart. */
  private measure(hit: Hit | null): void {
    if (!hit) return;
    const { notes } = this.stage;
    if (!this.from) this.clear();
    const size = this.stage.cell / 12;
    const ball = new Mesh(new SphereGeometry(size, 12, 8), new MeshBasicMaterial({ color: INK, depthTest: false }));
    ball.position.copy(hit.point);
    ball.renderOrder = 9;
    notes.add(ball);
    if (this.from) {
      const way = hit.point.clone().sub(this.from);
      const geometry = new BufferGeometry().setFromPoints([this.from, hit.point]);
      const line = new Line(geometry, new LineBasicMaterial({ color: INK, depthTest: false }));
      line.renderOrder = 9;
      const words = label(`${meters(way.length())} m`, "#0b5563");
      words.position.copy(this.from).add(hit.point).divideScalar(2);
      notes.add(new Group().add(line, words));
      const [x, y, z] = way.toArray().map((each) => each.toFixed(4));
      this.hand?.measured(`${way.length().toFixed(4)} m (x ${x}, y ${y}, z ${z})`);
      this.from = null;
    } else {
      this.from = hit.point.clone();
      this.hand?.measured("Choose the second point.");
    }
    this.stage.draw();
  }

  /** Takes measures away. */
  clear(): void {
    this.from = null;
    this.stage.notes.clear();
    this.stage.draw();
  }
}

/** The joint that a drag of a link moves: the nearest one towards the root that can move; of a follower, its leader. */
export function movedBy(robot: Robot, link: string): { joint: Joint; factor: number; carrier: Joint } | null {
  const carriers = new Map(robot.model.joints.map((joint) => [joint.child, joint]).reverse() as [string, Joint][]);
  const names = new Map(robot.model.joints.map((joint) => [joint.name, joint]));
  const seen = new Set<string>();
  for (let carrier = carriers.get(link); carrier && !seen.has(carrier.name); carrier = carriers.get(carrier.parent)) {
    seen.add(carrier.name);
    if (!moves(carrier)) continue;
    let [joint, factor] = [carrier, 1];
    for (let mimic = joint.axes[0].mimic; mimic && names.has(mimic.leader); mimic = joint.axes[0].mimic) {
      joint = names.get(mimic.leader) as Joint;
      factor *= mimic.multiplier;
      if (seen.has(joint.name) || !joint.axes.length) return null;
      seen.add(joint.name);
    }
    return factor ? { joint, factor, carrier } : null;
  }
  return null;
}

function gripOf(stage: Stage, hit: Hit, event: PointerEvent): Grip | null {
  const robot = hit.link.userData.robot as Robot;
  const found = movedBy(robot, hit.link.userData.link as string);
  if (!found) return null;
  const { joint, factor, carrier } = found;
  const [origin, axis] = axisOf(robot, carrier);
  const at = carrier.kind === "prismatic" ? along(stage, origin, axis) : around(stage, origin, axis, hit.point);
  const start = withFollowers(robot.model, robot.positions).get(joint.name)?.[0] ?? 0;
  let before = at(event.clientX, event.clientY);
  let sum = 0;
  const way = (x: number, y: number): number | null => {
    const now = at(x, y);
    if (now === null) return null;
    let step = now - (before ?? now);
    if (carrier.kind !== "prismatic") step -= 2 * Math.PI * Math.round(step / (2 * Math.PI)); // the shorter way round
    before = now;
    sum += step / factor;
    return sum;
  };
  return { robot, joint, start, way };
}

/** The origin and the direction of a joint's axis in the world, as its parent is now. */
function axisOf(robot: Robot, joint: Joint): [Vector3, Vector3] {
  const zero = robot.model.links.find((link) => link.name === joint.parent);
  const parent = robot.links.get(joint.parent) ?? robot.group;
  const pose = parent.matrixWorld.clone();
  if (zero) pose.multiply(new Matrix4().fromArray(zero.pose).invert());
  pose.multiply(new Matrix4().fromArray(joint.pose));
  const axis = new Vector3(...joint.axes[0].direction).transformDirection(pose);
  return [new Vector3().setFromMatrixPosition(pose), axis];
}

/** Where the pointer is along a line (m). */
function along(stage: Stage, origin: Vector3, axis: Vector3) {
  return (x: number, y: number): number | null => {
    const { ray } = stage.rayAt(x, y);
    const cross = axis.dot(ray.direction);
    const apart = ray.origin.clone().sub(origin);
    const square = 1 - cross * cross;
    return square < 1e-4 ? null : (apart.dot(axis) - cross * apart.dot(ray.direction)) / square;
  };
}

/** Where the pointer is around a line (rad): on the plane of the point that it holds, or as it crosses a line seen from the side. */
function around(stage: Stage, origin: Vector3, axis: Vector3, held: Vector3) {
  const center = origin.clone().addScaledVector(axis, held.clone().sub(origin).dot(axis));
  const arm = held.clone().sub(center);
  const plane = new Plane().setFromNormalAndCoplanarPoint(axis, held);
  const first = arm.clone().normalize();
  const second = axis.clone().cross(first);
  return (x: number, y: number): number | null => {
    const { ray } = stage.rayAt(x, y);
    if (Math.abs(ray.direction.dot(axis)) < 0.2 || arm.length() < 1e-6) {
      const facing = new Plane().setFromNormalAndCoplanarPoint(ray.direction, held);
      const point = ray.intersectPlane(facing, new Vector3());
      const side = axis.clone().cross(ray.direction).normalize();
      if (!point) return null;
      return (point.sub(held).dot(side) / Math.max(arm.length(), 1e-3)) * (second.dot(side) < 0 ? -1 : 1);
    }
    const point = ray.intersectPlane(plane, new Vector3());
    if (!point) return null;
    point.sub(center);
    return Math.atan2(point.dot(second), point.dot(first));
  };
}
