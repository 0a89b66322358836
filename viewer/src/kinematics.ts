// Where links are when joints move: the same as sdfcheck/robot/motion/kinematics.py, which a test compares.

import type { Axis, Joint, Model, Transform } from "./data";

export const IDENTITY: Transform = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** a · b, both column by column. */
export function product(a: Transform, b: Transform): Transform {
  const result = new Array<number>(16).fill(0);
  for (let column = 0; column < 4; column++)
    for (let row = 0; row < 4; row++)
      for (let k = 0; k < 4; k++) result[column * 4 + row] += a[k * 4 + row] * b[column * 4 + k];
  return result;
}

/** The inverse of a rotation and a shift. */
export function inverse(a: Transform): Transform {
  const result = [...IDENTITY];
  for (let row = 0; row < 3; row++)
    for (let column = 0; column < 3; column++) result[column * 4 + row] = a[row * 4 + column];
  for (let row = 0; row < 3; row++)
    result[12 + row] = -(result[row] * a[12] + result[4 + row] * a[13] + result[8 + row] * a[14]);
  return result;
}

/** A turn about a direction of length 1, by an angle in rad. */
export function turn([x, y, z]: number[], angle: number): Transform {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const t = 1 - c;
  return [
    t * x * x + c,
    t * x * y + s * z,
    t * x * z - s * y,
    0,
    t * x * y - s * z,
    t * y * y + c,
    t * y * z + s * x,
    0,
    t * x * z + s * y,
    t * y * z - s * x,
    t * z * z + c,
    0,
    0,
    0,
    0,
    1,
  ];
}

function shift([x, y, z]: number[], by: number): Transform {
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x * by, y * by, z * by, 1];
}

const TURNING = new Set(["revolute", "continuous", "gearbox"]);
const DOUBLE = new Set(["universal", "revolute2"]);

/** Whether the page has a slider for a joint. */
export function moves(joint: Joint): boolean {
  if (joint.axes.length === 0) return false;
  return TURNING.has(joint.kind) || DOUBLE.has(joint.kind) || joint.kind === "prismatic" || joint.kind === "screw";
}

/** What a joint does at its positions (rad, m), in its own frame. */
export function motion(joint: Joint, positions: number[]): Transform {
  const [first, second] = joint.axes;
  const at = positions[0] ?? 0;
  if (!first) return IDENTITY;
  if (TURNING.has(joint.kind)) return turn(first.direction, at);
  if (joint.kind === "prismatic") return shift(first.direction, at);
  if (joint.kind === "screw") return product(turn(first.direction, at), shift(first.direction, joint.pitch * at));
  if (DOUBLE.has(joint.kind) && second)
    return product(turn(first.direction, at), turn(second.direction, positions[1] ?? 0));
  return IDENTITY;
}

/** Positions by joint, with those that follow others. */
export function withFollowers(model: Model, given: Map<string, number[]>): Map<string, number[]> {
  const byName = new Map(model.joints.map((joint) => [joint.name, joint]));
  const result = new Map(given);
  const value = (name: string, seen: Set<string>): number => {
    const mimic: Axis["mimic"] = byName.get(name)?.axes[0]?.mimic ?? null;
    if (mimic && !seen.has(name) && byName.has(mimic.leader))
      return mimic.multiplier * (value(mimic.leader, new Set([...seen, name])) - mimic.reference) + mimic.offset;
    return result.get(name)?.[0] ?? 0;
  };
  for (const joint of model.joints) if (joint.axes[0]?.mimic) result.set(joint.name, [value(joint.name, new Set())]);
  return result;
}

/** The pose of each link in the model; joints that close loops are left out. */
export function linkPoses(model: Model, given: Map<string, number[]>): Map<string, Transform> {
  const positions = withFollowers(model, given);
  const zero = new Map(model.links.map((link) => [link.name, link.pose]));
  const moved = new Map<string, Transform>();
  const carried = new Set<string>();
  for (const joint of model.joints) {
    if (!zero.has(joint.child) || carried.has(joint.child) || joint.parent === joint.child) continue;
    carried.add(joint.child);
    const before = moved.get(joint.parent) ?? IDENTITY;
    const step = motion(joint, positions.get(joint.name) ?? []);
    moved.set(joint.child, product(before, product(joint.pose, product(step, inverse(joint.pose)))));
  }
  return new Map(model.links.map((link) => [link.name, product(moved.get(link.name) ?? IDENTITY, link.pose)]));
}
