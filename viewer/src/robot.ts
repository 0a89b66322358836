// A model as objects of three.js: a group for each link, in it its shapes and what can be switched on.

import {
  ArrowHelper, AxesHelper, BoxGeometry, BufferGeometry, CapsuleGeometry, Color, ConeGeometry, CylinderGeometry,
  EdgesGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Material, Matrix4, Mesh,
  MeshLambertMaterial, type Object3D, PlaneGeometry, SphereGeometry, Vector3,
} from "three";
import type { Inertia, Joint, Link, Model, Sensor, Shape, Transform } from "./data";
import { linkPoses } from "./kinematics";
import type { Meshes } from "./meshes";

export const LAYERS = ["visuals", "collisions", "inertias", "frames", "axes", "sensors"] as const;
export type Layer = (typeof LAYERS)[number];

const VISUAL = 0xb8bcc4;
const COLLISION = 0x2f9e44;
const INERTIA = 0xd6336c;
const IMPOSSIBLE = 0xff0000;
const SENSOR = 0x1c7ed6;

function placed<T extends Object3D>(object: T, pose: Transform): T {
  object.applyMatrix4(new Matrix4().fromArray(pose));
  return object;
}

function across(geometry: BufferGeometry): BufferGeometry {
  return geometry.rotateX(Math.PI / 2); // three.js has the axis along y, robots along z
}

function geometryOf(shape: Shape): BufferGeometry | null {
  const [a = 1, b = 1, c = 1] = shape.size;
  switch (shape.kind) {
    case "box":
      return new BoxGeometry(a, b, c);
    case "sphere":
      return new SphereGeometry(a, 32, 16);
    case "cylinder":
      return across(new CylinderGeometry(a, a, b, 32));
    case "cone":
      return across(new ConeGeometry(a, b, 32));
    case "capsule":
      return across(new CapsuleGeometry(a, b, 8, 24));
    case "ellipsoid":
      return new SphereGeometry(1, 32, 16).scale(a, b, c);
    case "plane": {
      const [x, y, z, width = 10, depth = 10] = shape.size;
      const plane = new PlaneGeometry(Math.min(width, 50), Math.min(depth, 50));
      const normal = new Vector3(x, y, z);
      if (normal.lengthSq() > 0) plane.lookAt(normal);
      return plane;
    }
    default:
      return null;
  }
}

export class Robot {
  readonly group = new Group();
  readonly links = new Map<string, Group>();
  readonly layers = new Map<Layer, Object3D[]>(LAYERS.map((layer) => [layer, []]));
  readonly positions = new Map<string, number[]>();

  constructor(readonly model: Model, private readonly meshes: Meshes, private readonly tint: number | null,
    private readonly withMeshes: boolean) {
    placed(this.group, model.pose);
    for (const link of model.links) {
      const group = new Group();
      group.matrixAutoUpdate = false;
      group.userData = { link: link.name };
      this.links.set(link.name, group);
      this.group.add(group);
      this.fill(group, link);
    }
    for (const joint of model.joints) this.addAxis(joint);
    this.move();
  }

  /** Puts every link where the positions of the joints say. */
  move(): void {
    for (const [name, pose] of linkPoses(this.model, this.positions)) this.links.get(name)?.matrix.fromArray(pose);
    this.group.updateMatrixWorld(true);
  }

  show(layer: Layer, visible: boolean): void {
    for (const object of this.layers.get(layer) ?? []) object.visible = visible;
  }

  private add(layer: Layer, link: Group, object: Object3D): void {
    this.layers.get(layer)?.push(object);
    link.add(object);
  }

  private fill(group: Group, link: Link): void {
    for (const shape of link.shapes) this.addShape(group, shape);
    if (link.inertia) this.addInertia(group, link.inertia);
    this.add("frames", group, new AxesHelper(0.1));
    for (const frame of link.frames) this.add("frames", group, placed(new AxesHelper(0.07), frame.pose));
    for (const sensor of link.sensors) this.add("sensors", group, placed(field(sensor), sensor.pose));
  }

  private material(shape: Shape): Material {
    if (this.tint !== null) return new MeshLambertMaterial({ color: this.tint, transparent: true, opacity: 0.4 });
    if (shape.role === "collision")
      return new MeshLambertMaterial({ color: COLLISION, transparent: true, opacity: 0.35 });
    const [r, g, b, alpha] = shape.color ?? [0, 0, 0, 1];
    const color = shape.color ? new Color().setRGB(r, g, b) : new Color(VISUAL);
    return new MeshLambertMaterial({ color, transparent: alpha < 1, opacity: Math.max(alpha, 0.15) });
  }

  private addShape(group: Group, shape: Shape): void {
    const layer: Layer = shape.role === "collision" ? "collisions" : "visuals";
    const geometry = geometryOf(shape);
    if (geometry) {
      this.add(layer, group, placed(new Mesh(geometry, this.material(shape)), shape.pose));
    } else if (shape.mesh !== null && this.withMeshes) {
      const holder = placed(new Group(), shape.pose);
      this.add(layer, group, holder);
      void this.meshes.get(shape.mesh).then((loaded) => {
        const [x = 1, y = 1, z = 1] = shape.size;
        loaded.scale.set(x, y, z);
        if (shape.color || shape.role === "collision" || this.tint !== null)
          loaded.traverse((part) => {
            if (part instanceof Mesh) part.material = this.material(shape);
          });
        holder.add(loaded);
        document.dispatchEvent(new Event("drawn"));
      });
    } else {
      const box = new BoxGeometry(0.1, 0.1, 0.1);
      this.add(layer, group, placed(new Mesh(box, this.material(shape)), shape.pose));
    }
  }

  private addInertia(group: Group, inertia: Inertia): void {
    const color = inertia.isPossible ? INERTIA : IMPOSSIBLE;
    const [x, y, z] = inertia.box.map((side) => Math.max(side, 1e-4));
    const lines = new LineSegments(new EdgesGeometry(new BoxGeometry(x, y, z)), new LineBasicMaterial({ color }));
    const center = new Mesh(new SphereGeometry(0.012, 12, 8), new MeshLambertMaterial({ color }));
    const both = new Group();
    both.add(lines, center);
    this.add("inertias", group, placed(both, inertia.pose));
  }

  private addAxis(joint: Joint): void {
    const child = this.links.get(joint.child);
    const zero = this.model.links.find((link) => link.name === joint.child);
    if (!child || !zero) return;
    const local = new Matrix4().fromArray(zero.pose).invert().multiply(new Matrix4().fromArray(joint.pose));
    for (const axis of joint.axes) {
      const arrow = new ArrowHelper(new Vector3(...axis.direction), new Vector3(), 0.15, 0xe67700, 0.04, 0.02);
      const holder = new Group();
      holder.add(arrow);
      holder.applyMatrix4(local);
      this.add("axes", child, holder);
    }
  }
}

/** The field of view of a sensor as lines, x forward. */
function field(sensor: Sensor): Object3D {
  const view = sensor.view;
  const points: number[] = [];
  if (view?.kind === "camera") {
    const half = Math.tan(Math.min(view.horizontal, 3) / 2) * view.far;
    const up = half / view.aspect;
    const corners = [[half, up], [-half, up], [-half, -up], [half, -up]];
    corners.forEach(([y, z], index) => {
      const [nextY, nextZ] = corners[(index + 1) % 4];
      points.push(0, 0, 0, view.far, y, z, view.far, y, z, view.far, nextY, nextZ);
    });
  } else if (view?.kind === "scan") {
    const steps = 48;
    for (let step = 0; step < steps; step++) {
      const [a, b] = [step, step + 1].map((at) => view.from + ((view.to - view.from) * at) / steps);
      points.push(Math.cos(a) * view.far, Math.sin(a) * view.far, 0, Math.cos(b) * view.far, Math.sin(b) * view.far, 0);
      if (step === 0) points.push(0, 0, 0, Math.cos(a) * view.far, Math.sin(a) * view.far, 0);
    }
    points.push(0, 0, 0, Math.cos(view.to) * view.far, Math.sin(view.to) * view.far, 0);
  } else {
    return new Mesh(new SphereGeometry(0.015, 8, 6), new MeshLambertMaterial({ color: SENSOR }));
  }
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: SENSOR }));
}
