// What is known of a selected part, as lines of a name and a value.

import type { Joint, Link, Mesh, Model, Transform } from "./data";
import { counted } from "./made";
import { IDENTITY, inverse, linkPoses, product, withFollowers } from "./kinematics";

export type Fact = [name: string, value: string];

/** A number as people write it: five digits. */
export function digits(number: number): string {
  const short = Number(number.toPrecision(5)) || 0;
  return Math.abs(short) < 1e-3 && short ? short.toExponential() : String(short);
}

function list(numbers: number[]): string {
  return numbers.map((number) => digits(Math.abs(number) < 1e-12 ? 0 : number)).join(" ");
}

/** A pose as `xyz … rpy …` (m, rad), as both formats write it. */
export function poseOf(pose: Transform): string {
  const pitch = Math.asin(Math.max(-1, Math.min(1, -pose[2])));
  const isUpright = Math.abs(pose[2]) > 1 - 1e-9; // roll and yaw turn about one axis: all of it is roll
  const roll = isUpright ? Math.atan2(-pose[9], pose[5]) : Math.atan2(pose[6], pose[10]);
  const yaw = isUpright ? 0 : Math.atan2(pose[1], pose[0]);
  const small = (angle: number): number => (Math.abs(angle) < 1e-9 ? 0 : angle);
  return `xyz ${list(pose.slice(12, 15))}  rpy ${list([roll, pitch, yaw].map(small))}`;
}

export function isAngle(joint: Joint): boolean {
  return joint.kind !== "prismatic";
}

/** The limits of an axis in words; those that are none are not bounded. */
function limits(joint: Joint, index: number): Fact[] {
  const axis = joint.axes[index];
  const unit = isAngle(joint) ? "rad" : "m";
  const bound = (value: number | null, without: string): string => (value === null ? without : digits(value));
  const facts: Fact[] = [
    ["axis", list(axis.direction)],
    ["limits", axis.lower === null && axis.upper === null ? "none" : `${bound(axis.lower, "−∞")} … ${bound(axis.upper, "∞")} ${unit}`],
  ];
  if (axis.effort !== null) facts.push(["effort", `${digits(axis.effort)} ${isAngle(joint) ? "N m" : "N"}`]);
  if (axis.velocity !== null) facts.push(["velocity", `${digits(axis.velocity)} ${unit}/s`]);
  const { mimic } = axis;
  if (mimic) facts.push(["follows", `${mimic.leader} × ${digits(mimic.multiplier)} + ${digits(mimic.offset - mimic.multiplier * mimic.reference)}`]);
  return facts;
}

export function ofJoint(model: Model, joint: Joint, positions: Map<string, number[]>): Fact[] {
  const parent = model.links.find((link) => link.name === joint.parent);
  const now = withFollowers(model, positions).get(joint.name) ?? [0];
  return [
    ["joint", joint.kind],
    ["parent", joint.parent],
    ["child", joint.child],
    ["pose in parent", poseOf(product(inverse(parent?.pose ?? IDENTITY), joint.pose))],
    ...joint.axes.flatMap((_, index) => limits(joint, index)),
    ...(joint.axes.length ? [["position", `${list(now.slice(0, joint.axes.length))} ${isAngle(joint) ? "rad" : "m"}`] as Fact] : []),
    ["file", joint.place],
  ];
}

export function ofLink(model: Model, link: Link, positions: Map<string, number[]>, meshes: Mesh[]): Fact[] {
  const joint = model.joints.find((each) => each.child === link.name);
  const poses = linkPoses(model, positions);
  const pose = poses.get(link.name) ?? IDENTITY;
  const facts: Fact[] = [["model", model.name]];
  if (joint) facts.push(["parent", joint.parent], ["joint", `${joint.name} (${joint.kind})`]);
  const parent = joint && poses.get(joint.parent);
  if (parent) facts.push(["pose in parent", poseOf(product(inverse(parent), pose))]);
  facts.push(["pose in model", poseOf(pose)]);
  facts.push(["mass", link.mass === null ? "not given" : `${digits(link.mass)} kg`]);
  if (link.inertia) {
    facts.push(["center of mass", list(link.inertia.pose.slice(12, 15))]);
    const names = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];
    const moments = link.inertia.moments.map((moment, at) => `${names[at]}\u00a0${digits(moment)}`).join(" ");
    facts.push([link.inertia.isPossible ? "inertia" : "impossible inertia", moments]);
  }
  for (const shape of link.shapes) {
    const mesh = shape.mesh === null ? null : meshes[shape.mesh];
    const name = shape.name && shape.name !== shape.role ? `${shape.name}: ` : "";
    const scale = shape.size.some((side) => side !== 1) ? ` × ${list(shape.size)}` : "";
    const size = mesh ? `${mesh.name}${scale}${mesh.missing ? ` (${mesh.missing})` : ""}` : `${shape.kind} ${list(shape.size)}`;
    const color = shape.color ? ` rgba ${list(shape.color)}` : "";
    facts.push([shape.role, `${name}${size}${shape.material || color ? `; material${shape.material ? ` ${shape.material}` : ""}${color}` : ""}`]);
  }
  for (const sensor of link.sensors) facts.push(["sensor", `${sensor.name} (${sensor.type})`]);
  for (const light of link.lights) facts.push(["light", `${light.name} (${light.type})`]);
  for (const frame of link.frames) facts.push(["frame", `${frame.name}: ${poseOf(frame.pose)}`]);
  facts.push(["file", link.place]);
  return facts;
}

export function ofModel(model: Model): Fact[] {
  const mass = model.links.reduce((sum, link) => sum + (link.mass ?? 0), 0);
  return [
    ["model", `${counted(model.links.length, "link")}, ${counted(model.joints.length, "joint")}`],
    ["mass", `${digits(mass)} kg`],
    ["pose", poseOf(model.pose)],
  ];
}
