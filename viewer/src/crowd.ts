// Many shapes in few drawing calls: one instanced mesh for each kind of shape of a layer.

import {
  Box3,
  BoxGeometry,
  type BufferGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  type Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  PlaneGeometry,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import type { Shape } from "./data";
import type { Manner } from "./robot";
import { COLORS, type Look } from "./shapes";

const TURNED = Math.PI / 2;
const UNITS: Record<string, (fine: boolean) => BufferGeometry> = {
  box: () => new BoxGeometry(1, 1, 1),
  sphere: (fine) => (fine ? new SphereGeometry(1, 24, 12) : new SphereGeometry(1, 6, 4)),
  cylinder: (fine) => new CylinderGeometry(1, 1, 1, fine ? 24 : 6).rotateX(TURNED),
  cone: (fine) => new ConeGeometry(1, 1, fine ? 24 : 6).rotateX(TURNED),
  plane: () => new PlaneGeometry(1, 1),
};
const KINDS: Record<string, string> = { capsule: "cylinder", ellipsoid: "sphere" };

/** Which unit geometry a shape is drawn as, how large, and turned how. */
function simplified(shape: Shape): { kind: string; scale: Vector3; turn: Quaternion } {
  const [a = 1, b = 1, c = 1, d = 10, e = 10] = shape.size;
  const turn = new Quaternion();
  const kind = KINDS[shape.kind] ?? shape.kind;
  switch (shape.kind) {
    case "box":
    case "ellipsoid":
      return { kind, scale: new Vector3(a, b, c), turn };
    case "sphere":
      return { kind, scale: new Vector3(a, a, a), turn };
    case "cylinder":
    case "cone":
      return { kind, scale: new Vector3(a, a, b), turn };
    case "capsule":
      return { kind, scale: new Vector3(a, a, b + 2 * a), turn };
    case "plane":
      turn.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(a, b, c).normalize());
      return { kind, scale: new Vector3(Math.min(d, 50), Math.min(e, 50), 1), turn };
    default:
      return { kind: "box", scale: new Vector3(0.1, 0.1, 0.1), turn };
  }
}

interface Member {
  link: Group;
  local: Matrix4;
  shape: Shape;
  /** The layer's mesh has it no more: it is not drawn, or alone. */
  isOut: boolean;
}

const NOWHERE = new Matrix4().makeScale(0, 0, 0);

/** The shapes of the models of a scene, in the scene's frame. */
export class Crowd {
  private readonly members = new Map<string, Member[]>();
  private readonly meshes = new Map<string, InstancedMesh>();
  private readonly places = new Map<Group, [InstancedMesh, number, Member][]>();

  /** `isFine`: round shapes are round, as far as a few thousand triangles are. */
  constructor(
    private readonly scene: Group,
    readonly isFine: boolean,
  ) {}

  add(layer: string, link: Group, shape: Shape): void {
    const { kind, scale, turn } = simplified(shape);
    const local = new Matrix4().fromArray(shape.pose).multiply(new Matrix4().compose(new Vector3(), turn, scale));
    const key = `${layer} ${kind}`;
    const member = { link, local, shape, isOut: false };
    const known = this.members.get(key);
    if (known) known.push(member);
    else this.members.set(key, [member]);
  }

  /** Makes the meshes of what was added; returns them with their layers. */
  build(): [string, InstancedMesh][] {
    for (const [key, members] of this.members) {
      const kind = key.split(" ")[1];
      const mesh = new InstancedMesh(UNITS[kind](this.isFine), new MeshLambertMaterial(), members.length);
      members.forEach((member, index) => {
        const known = this.places.get(member.link) ?? [];
        known.push([mesh, index, member]);
        this.places.set(member.link, known);
      });
      mesh.frustumCulled = false;
      mesh.userData.isAside = kind === "plane";
      mesh.userData.links = members.map((member) => member.link);
      this.meshes.set(key, mesh);
      this.scene.add(mesh);
    }
    this.scene.updateMatrixWorld(true);
    this.place(this.places.keys());
    for (const link of this.places.keys()) this.paint(link, () => "own", false);
    return [...this.meshes].map(([key, mesh]) => [key.split(" ")[0], mesh]);
  }

  /** Puts the shapes of links where their links are, which know that themselves. */
  place(links: Iterable<Group>): void {
    const back = new Matrix4().copy(this.scene.matrixWorld).invert();
    for (const link of links)
      for (const [mesh, index, { local, isOut }] of this.places.get(link) ?? []) {
        const at = new Matrix4().multiplyMatrices(back, link.matrixWorld).multiply(local);
        mesh.setMatrixAt(index, isOut ? NOWHERE : at);
        mesh.instanceMatrix.needsUpdate = true;
      }
    for (const mesh of this.meshes.values()) {
      mesh.boundingBox = null; // worked out again when it is asked for
      mesh.boundingSphere = null;
    }
  }

  /** Takes the shapes of a link out of the crowd, to be drawn alone as faint ones or not at all, or back into it. */
  setManner(link: Group, manner: Manner): void {
    for (const alone of link.children.filter((child) => child.userData.isAlone)) link.remove(alone);
    for (const [mesh, , member] of this.places.get(link) ?? []) {
      member.isOut = manner !== "shown";
      if (manner !== "faint" || !mesh.visible) continue;
      const [r, g, b] = member.shape.color ?? [0.7, 0.7, 0.75];
      const color = new Color().setRGB(r, g, b);
      const material = new MeshLambertMaterial({ color, transparent: true, opacity: 0.4, depthWrite: false });
      const alone = new Mesh(mesh.geometry, material);
      alone.userData.isAlone = true;
      alone.applyMatrix4(member.local);
      link.add(alone);
    }
    this.place([link]);
  }

  /** Gives each shape of a link its look. */
  paint(link: Group, look: (shape: Shape) => Look, seeThrough: boolean): void {
    for (const [mesh, index, { shape }] of this.places.get(link) ?? []) {
      const chosen = look(shape);
      const isCollision = shape.role === "collision";
      const color = new Color(isCollision ? COLORS.collision : COLORS.visual);
      if (chosen !== "own") color.set(COLORS[chosen]);
      else if (!isCollision && shape.color) color.setRGB(shape.color[0], shape.color[1], shape.color[2]);
      mesh.setColorAt(index, color);
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
      const material = mesh.material as MeshLambertMaterial;
      material.transparent = seeThrough || isCollision;
      material.opacity = material.transparent ? 0.4 : 1;
      material.depthWrite = !material.transparent;
    }
  }

  /** What the shapes of a link take up in the world. */
  bounds(link: Group): Box3 {
    const all = new Box3();
    for (const [mesh, , member] of this.places.get(link) ?? []) {
      if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
      const own = (mesh.geometry.boundingBox as Box3).clone();
      all.union(own.applyMatrix4(member.local).applyMatrix4(link.matrixWorld));
    }
    return all;
  }
}
