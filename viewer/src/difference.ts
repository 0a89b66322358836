// Two robots: which of their shapes and links differ, and where they differ most.

import type { Axis, Joint, Link, Mesh, Model, Shape, Transform } from "./data";
import { linkPoses, moves } from "./kinematics";

const TOLERANCE = 1e-6;
const REACH = 0.1; // m: points of a link that are compared, along its axes

function near(a: number[], b: number[]): boolean {
  return (
    a.length === b.length && a.every((one, index) => Math.abs(one - b[index]) <= TOLERANCE * Math.max(1, Math.abs(one)))
  );
}

function sameShape(a: Shape, b: Shape, meshes: Mesh[]): boolean {
  const name = (shape: Shape): string => (shape.mesh === null ? "" : meshes[shape.mesh].name);
  return (
    a.role === b.role &&
    a.kind === b.kind &&
    name(a) === name(b) &&
    near(a.size, b.size) &&
    near(a.pose, b.pose) &&
    (a.color === null || b.color === null ? a.color === b.color : near(a.color, b.color))
  );
}

function sameInertia(a: Link, b: Link): boolean {
  if (!a.inertia || !b.inertia) return a.inertia === b.inertia;
  const numbers = ({ mass, inertia }: Link): number[] =>
    inertia ? [mass ?? 0, ...inertia.box, ...inertia.pose.slice(12, 15)] : [];
  return near(numbers(a), numbers(b));
}

/** The shapes of either model that the other does not have so, and the links whose inertia differs. */
export function differing(a: Model, b: Model, meshes: Mesh[]): { shapes: Set<Shape>; inertias: Set<string> } {
  const shapes = new Set<Shape>();
  const inertias = new Set<string>();
  const others = new Map(b.links.map((link) => [link.name, link]));
  const own = new Set(a.links.map((link) => link.name));
  for (const link of a.links) {
    const left = [...(others.get(link.name)?.shapes ?? [])];
    for (const shape of link.shapes) {
      const found = left.findIndex((other) => sameShape(shape, other, meshes));
      if (found < 0) shapes.add(shape);
      else left.splice(found, 1);
    }
    for (const shape of left) shapes.add(shape);
    const other = others.get(link.name);
    if (other && !sameInertia(link, other)) inertias.add(link.name);
  }
  for (const link of b.links) if (!own.has(link.name)) for (const shape of link.shapes) shapes.add(shape);
  return { shapes, inertias };
}

/** How far two poses of a link put its origin and the points at 0.1 m along its axes apart, at most (m). */
export function apart(a: Transform, b: Transform): number {
  let most = 0;
  for (let axis = -1; axis < 3; axis++) {
    let square = 0;
    for (let row = 0; row < 3; row++) {
      const point = (pose: Transform): number => pose[12 + row] + (axis < 0 ? 0 : REACH * pose[axis * 4 + row]);
      square += (point(a) - point(b)) ** 2;
    }
    most = Math.max(most, square);
  }
  return Math.sqrt(most);
}

/** The links that are elsewhere at these positions. */
export function moved(a: Model, b: Model, positions: Map<string, number[]>): Map<string, number> {
  const others = linkPoses(b, positions);
  const result = new Map<string, number>();
  for (const [name, pose] of linkPoses(a, positions)) {
    const other = others.get(name);
    const distance = other ? apart(pose, other) : 0;
    if (distance > TOLERANCE) result.set(name, distance);
  }
  return result;
}

export interface Farthest {
  distance: number;
  link: string;
  positions: Map<string, number[]>;
}

const WORK = 2_000_000; // links placed, after which no more configurations are tried

const STEPS = 12; // from bound to bound

/** Positions that an axis is tried at: evenly from bound to bound, and zero. */
function tried(axis: Axis, joint: Joint): number[] {
  const wide = joint.kind === "prismatic" ? 1 : Math.PI;
  const [low, high] = [axis.lower ?? -wide, axis.upper ?? wide];
  const inside = low <= 0 && high >= 0 ? [0] : [];
  return [...inside, ...Array.from({ length: STEPS + 1 }, (_, step) => low + ((high - low) * step) / STEPS)];
}

/**
 * The configuration in which a link of one robot is farthest from that of the other, among those tried.
 *
 * One joint after the other goes where the distance is largest, from three starts: all joints at zero, at their
 * lower and at their upper bound; again until nothing gets larger.
 */
export function farthest(a: Model, b: Model): Farthest {
  const shared = new Set(b.joints.map((joint) => joint.name));
  const axes = a.joints
    .filter((joint) => shared.has(joint.name) && moves(joint))
    .flatMap((joint) =>
      joint.axes
        .slice(0, 2)
        .flatMap((axis, index) => (axis.mimic ? [] : [{ joint, index, values: tried(axis, joint) }])),
    );
  let left = WORK;
  const measure = (positions: Map<string, number[]>): [number, string] => {
    left -= a.links.length + b.links.length;
    let best: [number, string] = [0, ""];
    for (const [name, distance] of moved(a, b, positions)) if (distance > best[0]) best = [distance, name];
    return best;
  };
  const at = (pick: (values: number[]) => number): Map<string, number[]> => {
    const result = new Map<string, number[]>();
    for (const { joint, index, values } of axes) {
      const known = result.get(joint.name) ?? [0, 0];
      known[index] = pick(values);
      result.set(joint.name, known);
    }
    return result;
  };
  let result: Farthest = { distance: 0, link: "", positions: at((values) => (values.includes(0) ? 0 : values[0])) };
  for (const pick of [
    (values: number[]) => (values.includes(0) ? 0 : values[0]),
    (values: number[]) => Math.min(...values),
    (values: number[]) => Math.max(...values),
  ]) {
    const positions = at(pick);
    let [distance, link] = measure(positions);
    for (let grew = true; grew && left > 0; ) {
      grew = false;
      for (const { joint, index, values } of axes) {
        const own = positions.get(joint.name) as number[];
        let best = own[index];
        for (const value of values) {
          own[index] = value;
          const [far, name] = measure(positions);
          if (far > distance * (1 + 1e-9) + 1e-12) {
            [distance, link, best, grew] = [far, name, value, true];
          }
        }
        own[index] = best;
        if (left <= 0) break;
      }
    }
    if (distance > result.distance) result = { distance, link, positions };
  }
  return result;
}

/** Models of two scenes that are compared: by name, or the only one of each. */
export function counterpart(model: Model, others: Model[], own: Model[]): Model | undefined {
  return (
    others.find((other) => other.name === model.name) ??
    (own.length === 1 && others.length === 1 ? others[0] : undefined)
  );
}
