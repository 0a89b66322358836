// The shapes of the formats as geometries of three.js, z up, and their materials.

import {
  BoxGeometry,
  type BufferGeometry,
  CapsuleGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  type Material,
  MeshLambertMaterial,
  PlaneGeometry,
  SphereGeometry,
  Vector3,
} from "three";
import type { Shape } from "./data";

export const COLORS = {
  visual: 0xb8bcc4,
  collision: 0x2f9e44,
  inertia: 0xd6336c,
  impossible: 0xff0000,
  sensor: 0x1c7ed6,
  axis: 0xe67700,
  before: 0xd9480f,
  after: 0x1864ab,
  light: 0xf2b800,
  missing: 0xb060c0,
} as const;

/** How a shape looks: as the file says, or marked as one that only the first or second robot has so. */
export type Look = "own" | "before" | "after";

const PLANE = 50; // m; planes are infinite to physics

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
      const plane = new PlaneGeometry(Math.min(width, PLANE), Math.min(depth, PLANE));
      const normal = new Vector3(x, y, z);
      if (normal.lengthSq() > 0) plane.lookAt(normal);
      return plane;
    }
    default:
      return null;
  }
}

/** The materials and geometries of a page, each made once. */
export class Palette {
  private readonly made = new Map<string, Material>();
  private readonly geometries = new Map<string, BufferGeometry | null>();

  /** The geometry of a shape; null for meshes and for kinds that are not drawn. */
  geometry(shape: Shape): BufferGeometry | null {
    const key = JSON.stringify([shape.kind, shape.size]);
    let found = this.geometries.get(key);
    if (found === undefined) {
      found = geometryOf(shape);
      this.geometries.set(key, found);
    }
    return found;
  }

  /** The material of a shape; those that let others be seen write no depth. */
  of(shape: Shape, look: Look, seeThrough: boolean): Material {
    const key = JSON.stringify([shape.role, shape.color, look, seeThrough]);
    let found = this.made.get(key);
    if (!found) {
      found = materialOf(shape, look, seeThrough);
      this.made.set(key, found);
    }
    return found;
  }

  /** A mesh's own material, as it lets others be seen. */
  faint<T extends Material | Material[]>(material: T): T {
    if (Array.isArray(material)) return material.map((each) => this.faint<Material>(each)) as T;
    let found = this.made.get(material.uuid);
    if (!found) {
      found = material.clone();
      found.transparent = true;
      found.opacity = 0.4;
      found.depthWrite = false;
      this.made.set(material.uuid, found);
    }
    return found as T;
  }
}

function materialOf(shape: Shape, look: Look, seeThrough: boolean): Material {
  const isCollision = shape.role === "collision";
  const [r, g, b, alpha] = shape.color ?? [0, 0, 0, 1];
  let color = shape.color ? new Color().setRGB(r, g, b) : new Color(COLORS.visual);
  let opacity = Math.max(alpha, 0.15) * (seeThrough ? 0.4 : 1);
  if (isCollision) {
    color = new Color(COLORS.collision);
    opacity = 0.35;
  }
  if (look !== "own") {
    color = new Color(COLORS[look]);
    opacity = seeThrough || isCollision ? 0.6 : 1;
  }
  const transparent = opacity < 1;
  return new MeshLambertMaterial({
    color,
    transparent,
    opacity,
    depthWrite: !transparent,
    polygonOffset: isCollision,
    polygonOffsetFactor: -1,
    polygonOffsetUnits: -1,
  });
}
