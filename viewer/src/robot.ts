// A model as objects of three.js: a group for each link, in it its shapes and what can be switched on.

import { Box3, Group, Matrix4, Mesh, type MeshLambertMaterial, type Object3D, Vector3 } from "three";
import type { Crowd } from "./crowd";
import { label, meters } from "./labels";
import type { Joint, Link, Model, Shape } from "./data";
import { linkPoses, moves } from "./kinematics";
import { arrowOf, emptyLinkOf, fieldOf, frameOf, inertiaOf, lightOf, placed, rangeOf } from "./markers";
import type { Meshes } from "./meshes";
import type { Look, Palette } from "./shapes";

export const LAYERS = [
  "visuals",
  "collisions",
  "inertias",
  "axes",
  "frames",
  "sensors",
  "lights",
  "empty links",
] as const;
export type Layer = (typeof LAYERS)[number];

const OUTSIZED = 100; // times the size of all other links

/** A shape that is drawn, with the materials that its file gives it. */
interface Drawn {
  link: string;
  shape: Shape;
  object: Object3D;
  own: [Mesh, MeshLambertMaterial][];
}

export class Robot {
  readonly group = new Group();
  readonly links = new Map<string, Group>();
  readonly positions = new Map<string, number[]>();
  /** How large markers are: the size of an ordinary link (m). */
  readonly unit: number;
  private readonly drawn: Drawn[] = [];
  private readonly layers = new Map<Layer, Object3D[]>();
  private readonly zero: Map<string, Link>;

  constructor(
    readonly model: Model,
    private readonly meshes: Meshes,
    private readonly palette: Palette,
    private readonly crowd: Crowd | null,
  ) {
    placed(this.group, model.pose);
    this.zero = new Map(model.links.map((link) => [link.name, link]));
    for (const link of model.links) {
      const group = new Group();
      group.matrixAutoUpdate = false;
      group.userData = { robot: this, link: link.name };
      this.links.set(link.name, group);
      this.group.add(group);
      for (const shape of link.shapes) this.addShape(group, link, shape);
    }
    this.move();
    this.unit = this.ordinarySize();
    this.markOutsized();
  }

  /** Puts every link where the positions of the joints say. */
  move(): void {
    for (const [name, pose] of linkPoses(this.model, this.positions)) this.links.get(name)?.matrix.fromArray(pose);
    this.group.updateMatrixWorld(true);
    this.crowd?.place(this.links.values());
  }

  show(layer: Layer, visible: boolean): void {
    if (visible && !this.layers.has(layer)) this.build(layer);
    for (const object of this.layers.get(layer) ?? []) object.visible = visible;
  }

  /** Gives each shape its look. */
  paint(look: (link: string, shape: Shape) => Look, seeThrough: boolean): void {
    for (const [name, group] of this.links) this.crowd?.paint(group, (shape) => look(name, shape), seeThrough);
    for (const { link, shape, object, own } of this.drawn) {
      const chosen = look(link, shape);
      object.renderOrder = chosen === "own" ? 0 : 1;
      const isOwn = chosen === "own" && own.length > 0;
      if (isOwn)
        for (const [mesh, material] of own) mesh.material = seeThrough ? this.palette.faint(material) : material;
      else
        object.traverse((part) => {
          if (part instanceof Mesh) part.material = this.palette.of(shape, chosen, seeThrough);
        });
    }
  }

  /** The link of a part: itself, or of a joint its child. */
  linkOf(part: string): Group | undefined {
    return this.links.get(part) ?? this.links.get(this.model.joints.find((joint) => joint.name === part)?.child ?? "");
  }

  /** What a link takes up in the world, by its shapes. */
  bounds(link: Group): Box3 {
    const all = this.crowd?.bounds(link) ?? new Box3();
    for (const { object } of this.drawn) if (object.parent === link && object.visible) all.expandByObject(object);
    return all;
  }

  /** Says which link is far larger than the others, and where those are: they are not to be seen beside it. */
  private markOutsized(): void {
    const sizes = [...this.links].flatMap(([name, link]): [string, Group, number][] => {
      const box = this.bounds(link);
      return box.isEmpty() ? [] : [[name, link, box.getSize(new Vector3()).length()]];
    });
    sizes.sort((a, b) => b[2] - a[2]);
    const [largest, second] = sizes;
    if (!second || largest[2] < OUTSIZED * second[2]) return;
    const [name, link, size] = largest;
    const large = label(`${name}: ${meters(size / second[2])} times as large as any other link`, "#a50000");
    this.bounds(link).getCenter(large.position).applyMatrix4(link.matrixWorld.clone().invert());
    const rest = label(`here are the other links of ${this.model.name}`, "#1b1e23");
    rest.center.set(0.5, 1.8);
    link.add(large);
    second[1].add(rest);
    this.keep("visuals", large);
    this.keep("visuals", rest);
  }

  private addShape(group: Group, link: Link, shape: Shape): void {
    const layer: Layer = shape.role === "collision" ? "collisions" : "visuals";
    if (this.crowd && (shape.mesh === null || !this.crowd.isFine)) {
      this.crowd.add(layer, group, shape);
      return;
    }
    const geometry = this.palette.geometry(shape);
    const number = shape.mesh;
    let object: Object3D;
    if (geometry) object = new Mesh(geometry, this.palette.of(shape, "own", false));
    else if (number !== null) object = this.meshes.copy(number, shape.size);
    else return; // a kind that is not drawn
    const hasOwn = number !== null && (!this.meshes.has(number) || (!shape.color && layer === "visuals"));
    const own: [Mesh, MeshLambertMaterial][] = [];
    object.traverse((part) => {
      if (part instanceof Mesh && hasOwn) own.push([part, part.material]);
      else if (part instanceof Mesh) part.material = this.palette.of(shape, "own", false);
    });
    const holder = placed(new Group().add(object), shape.pose);
    holder.userData.isAside = shape.kind === "plane";
    group.add(holder);
    this.keep(layer, holder);
    this.drawn.push({ link: link.name, shape, object: holder, own });
  }

  private keep(layer: Layer, object: Object3D): void {
    const known = this.layers.get(layer);
    if (known) known.push(object);
    else this.layers.set(layer, [object]);
  }

  /** The median of the sizes of links, which one shape that is far too large does not change. */
  private ordinarySize(): number {
    const sizes = [...this.links.values()]
      .map((link) => this.bounds(link))
      .flatMap((box) => (box.isEmpty() ? [] : [box.getSize(new Vector3()).length()]))
      .sort((a, b) => a - b);
    const joined = this.model.joints.map((joint) =>
      new Vector3(joint.pose[12], joint.pose[13], joint.pose[14]).length(),
    );
    const size = sizes.length ? sizes[sizes.length >> 1] : Math.max(...joined, 0.3) / 2;
    return Math.min(Math.max(size * 0.6, 0.01), 2);
  }

  /** Makes the objects of a layer when it is first shown. */
  private build(layer: Layer): void {
    const add = (link: Group, object: Object3D): void => {
      link.add(object);
      this.keep(layer, object);
    };
    if (layer === "axes") for (const joint of this.model.joints) this.addAxis(joint, add);
    for (const link of this.model.links) {
      const group = this.links.get(link.name) as Group;
      if (layer === "inertias" && link.inertia) add(group, inertiaOf(link.inertia, this.unit));
      if (layer === "frames") {
        add(group, new Group().add(frameOf(new Matrix4().toArray(), this.unit)));
        for (const frame of link.frames) add(group, frameOf(frame.pose, this.unit * 0.7));
      }
      if (layer === "sensors")
        for (const sensor of link.sensors) add(group, placed(fieldOf(sensor, this.unit), sensor.pose));
      if (layer === "lights") for (const light of link.lights) add(group, lightOf(light, this.unit));
      if (layer === "empty links" && !link.shapes.length) add(group, emptyLinkOf(this.unit));
    }
  }

  private addAxis(joint: Joint, add: (link: Group, object: Object3D) => void): void {
    const child = this.links.get(joint.child);
    if (!child || !moves(joint)) return;
    const at = (link: string): Matrix4 => {
      const zero = this.zero.get(link);
      const back = zero ? new Matrix4().fromArray(zero.pose).invert() : new Matrix4();
      return back.multiply(new Matrix4().fromArray(joint.pose));
    };
    for (const axis of joint.axes) {
      add(child, placed(arrowOf(axis, this.unit), at(joint.child).toArray()));
      add(
        this.links.get(joint.parent) ?? this.group,
        placed(rangeOf(joint, axis, this.unit), at(joint.parent).toArray()),
      );
    }
  }
}
