// What is drawn beside shapes: inertias, joint axes, frames, fields of view, lights, links without shapes.

import {
  ArrowHelper,
  AxesHelper,
  BoxGeometry,
  BufferGeometry,
  CircleGeometry,
  Color,
  DoubleSide,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  OctahedronGeometry,
  SphereGeometry,
  Vector3,
} from "three";
import type { Axis, Inertia, Joint, Light, Sensor, Transform } from "./data";
import { label } from "./labels";
import { COLORS } from "./shapes";

/** Puts an object where a transform says, on top of what it has. */
export function placed<T extends Object3D>(object: T, pose: Transform): T {
  object.applyMatrix4(new Matrix4().fromArray(pose));
  return object;
}

/** Drawn over everything, so that nothing hides it. */
function onTop<T extends Object3D>(object: T): T {
  object.traverse((part) => {
    const material = (part as Mesh).material as Material | undefined;
    if (material) material.depthTest = false;
    part.renderOrder = 5;
  });
  return object;
}

function lines(points: number[], color: number): LineSegments {
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color }));
}

function seeThrough(color: number, opacity: number): MeshBasicMaterial {
  const offset = { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 }; // it may be as large as the shape
  return new MeshBasicMaterial({ color, transparent: true, opacity, side: DoubleSide, depthWrite: false, ...offset });
}

const LARGEST = 1e5; // m; larger boxes, of inertias that stand for infinity, are drawn so large

/** The box of even density with the same moments, and the center of mass. */
export function inertiaOf(inertia: Inertia, unit: number): Object3D {
  const color = inertia.isPossible ? COLORS.inertia : COLORS.impossible;
  const [x, y, z] = inertia.box.map((side) => Math.min(Math.max(side, unit * 1e-3), LARGEST));
  const box = new BoxGeometry(x, y, z);
  const edges = onTop(new LineSegments(new EdgesGeometry(box), new LineBasicMaterial({ color })));
  const center = onTop(new Mesh(new SphereGeometry(unit * 0.08, 12, 8), new MeshBasicMaterial({ color })));
  const both = new Group().add(new Mesh(box, seeThrough(color, 0.25)), edges, center);
  if (!inertia.isPossible) both.add(label("impossible inertia", "#c00000"));
  return placed(both, inertia.pose);
}

export function frameOf(pose: Transform, size: number): Object3D {
  return placed(onTop(new AxesHelper(size)), pose);
}

/** The axis of a joint as an arrow that moves with its child. */
export function arrowOf(axis: Axis, unit: number): Object3D {
  const long = unit * 1.6;
  const direction = new Vector3(...axis.direction);
  const start = direction.clone().multiplyScalar(-unit * 0.6);
  return onTop(new ArrowHelper(direction, start, long, COLORS.axis, long * 0.18, long * 0.08));
}

/** Where an axis lets its child go, in the joint's frame: a sector of a disc, or a way along the axis. */
export function rangeOf(joint: Joint, axis: Axis, unit: number): Object3D {
  const direction = new Vector3(...axis.direction);
  if (joint.kind === "prismatic") {
    const ends = [axis.lower ?? -unit, axis.upper ?? unit].map((at) => direction.clone().multiplyScalar(at));
    return onTop(
      lines(
        ends.flatMap((end) => end.toArray()),
        COLORS.axis,
      ),
    );
  }
  const [from, to] = [axis.lower ?? -Math.PI, axis.upper ?? Math.PI];
  const swept = Math.min(Math.max(to - from, 0), 2 * Math.PI);
  const radius = unit * 0.7;
  const disc = new CircleGeometry(radius, 48, from, swept);
  const rim = new BufferGeometry().setFromPoints(
    Array.from({ length: 49 }, (_, step) => {
      const at = from + (swept * step) / 48;
      return new Vector3(Math.cos(at) * radius, Math.sin(at) * radius, 0);
    }),
  );
  const both = new Group().add(
    new Mesh(disc, seeThrough(COLORS.axis, 0.3)),
    onTop(new Line(rim, new LineBasicMaterial({ color: COLORS.axis }))),
  );
  both.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), direction);
  return both;
}

/** A point where two parts meet. */
export function contactOf(point: [number, number, number], unit: number): Object3D {
  const ball = onTop(new Mesh(new SphereGeometry(unit * 0.1, 16, 12), new MeshBasicMaterial({ color: COLORS.impossible })));
  ball.position.set(...point);
  return ball;
}

/** A link that nothing else shows. */
export function emptyLinkOf(unit: number): Object3D {
  const geometry = new OctahedronGeometry(unit * 0.14);
  const edges = new LineSegments(new EdgesGeometry(geometry), new LineBasicMaterial({ color: 0x868e96 }));
  return new Group().add(new Mesh(geometry, seeThrough(0x868e96, 0.3)), edges);
}

const REACH = 3; // sizes of an ordinary link: fields of view are not drawn any farther

/** The field of view of a sensor as lines, x forward; a small ball for one that sees nothing. */
export function fieldOf(sensor: Sensor, unit: number): Object3D {
  const { view } = sensor;
  const points: number[] = [];
  const reach = unit * REACH;
  if (view?.kind === "camera") {
    const half = Math.tan(Math.min(view.horizontal, 3) / 2);
    const far = Math.min(view.far, reach / Math.hypot(1, half, half / view.aspect)); // no corner is farther away
    for (const at of [Math.min(view.near, far), far]) {
      const [side, up] = [half * at, (half * at) / view.aspect];
      const corners = [
        [side, up],
        [-side, up],
        [-side, -up],
        [side, -up],
      ];
      corners.forEach(([y, z], index) => {
        const [nextY, nextZ] = corners[(index + 1) % 4];
        points.push(at, y, z, at, nextY, nextZ);
        if (at === far) points.push(0, 0, 0, at, y, z);
      });
    }
  } else if (view?.kind === "scan") {
    const steps = 48;
    const far = Math.min(view.far, reach);
    for (const tilt of new Set([view.down, view.up])) {
      const at = (angle: number): number[] => [
        Math.cos(angle) * Math.cos(tilt) * far,
        Math.sin(angle) * Math.cos(tilt) * far,
        Math.sin(tilt) * far,
      ];
      for (let step = 0; step < steps; step++) {
        const [a, b] = [step, step + 1].map((one) => view.from + ((view.to - view.from) * one) / steps);
        points.push(...at(a), ...at(b));
        if (step % 4 === 0) points.push(0, 0, 0, ...at(a));
      }
      points.push(0, 0, 0, ...at(view.to));
    }
  } else {
    return onTop(new Mesh(new SphereGeometry(unit * 0.1, 8, 6), new MeshBasicMaterial({ color: COLORS.sensor })));
  }
  const all = lines(points, COLORS.sensor);
  all.userData.isAside = true;
  return all;
}

/** A light: a ball, with an arrow where it shines to one side, and the cone of a spot. */
export function lightOf(light: Light, unit: number): Object3D {
  const [r, g, b] = light.color;
  const ball = new Mesh(new SphereGeometry(unit * 0.25, 16, 12), new MeshBasicMaterial({ color: new Color(r, g, b) }));
  const rim = new LineSegments(
    new EdgesGeometry(new SphereGeometry(unit * 0.27, 8, 6)),
    new LineBasicMaterial({ color: COLORS.light }),
  );
  const all = new Group().add(ball, rim, label(light.name, "#7a5b00"));
  const direction = new Vector3(...light.direction).normalize();
  if (light.type !== "point" && direction.lengthSq() > 0)
    all.add(new ArrowHelper(direction, new Vector3(), unit * 2, COLORS.light, unit * 0.4, unit * 0.2));
  if (light.type === "spot" && direction.lengthSq() > 0) {
    const wide = Math.tan(Math.min(light.angle, 3) / 2) * unit * 2;
    const points: number[] = [];
    for (let step = 0; step < 24; step++) {
      const [a, c] = [step, step + 1].map((one) => (one * Math.PI) / 12);
      points.push(Math.cos(a) * wide, Math.sin(a) * wide, unit * 2, Math.cos(c) * wide, Math.sin(c) * wide, unit * 2);
      if (step % 6 === 0) points.push(0, 0, 0, Math.cos(a) * wide, Math.sin(a) * wide, unit * 2);
    }
    const cone = lines(points, COLORS.light);
    cone.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), direction);
    all.add(cone);
  }
  all.userData.isAside = true;
  return placed(all, light.pose);
}
