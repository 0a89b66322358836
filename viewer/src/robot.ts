// A model as objects of three.js: a group for each link, in it its shapes and what can be switched on.

import { Box3, Group, type Material, Matrix4, Mesh, type Object3D, Vector3 } from "three";
import type { Crowd } from "./crowd";
import { label, meters } from "./labels";
import type { Joint, Link, Model, Shape } from "./data";
import { linkPoses, moves } from "./kinematics";
import { arrowOf, contactOf, emptyLinkOf, fieldOf, frameOf, inertiaOf, lightOf, placed, rangeOf } from "./markers";
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
  own: [Mesh, Material | Material[]][];
}

/** How a link is shown: all can be seen behind faint ones. */
export type Manner = "shown" | "faint" | "hidden";

export class Robot {
  readonly group = new Group();
  readonly links = new Map<string, Group>();
  readonly positions = new Map<string, number[]>();
  private readonly drawn: Drawn[] = [];
  /** Link → what is drawn of each layer. */
  private readonly parts = new Map<string, Map<Layer, Object3D[]>>();
  private readonly layers = new Set<Layer>();
  /** Links → the layers that are shown of them alone. */
  private revealed = new Map<string, Layer[]>();
  private readonly manners = new Map<string, Manner>();
  private readonly zero: Map<string, Link>;
  private size: number | null = null;
  private marks: Object3D[] = [];

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
  }

  /** Draws meshes that were read since; returns whether there was one. */
  fill(numbers: number[]): boolean {
    const found = this.drawn.filter(({ shape, object }) => !object.children.length && numbers.includes(shape.mesh ?? -1));
    for (const drawn of found) this.fillOne(drawn);
    return found.length > 0;
  }

  /** Is called when all meshes are there. */
  finish(): void {
    this.size = null;
    this.markOutsized();
  }

  /** How large markers are: the size of an ordinary link (m). */
  get unit(): number {
    return (this.size ??= this.ordinarySize());
  }

  /** Puts every link where the positions of the joints say. */
  move(): void {
    for (const [name, pose] of linkPoses(this.model, this.positions)) this.links.get(name)?.matrix.fromArray(pose);
    this.group.updateMatrixWorld(true);
    this.crowd?.place(this.links.values());
  }

  /** Marks points of the model, and only these. */
  mark(points: [number, number, number][]): void {
    this.group.remove(...this.marks);
    this.marks = points.map((point) => contactOf(point, this.unit));
    for (const mark of this.marks) this.group.add(mark);
  }

  marked(): number[][] {
    return this.marks.map((mark) => mark.position.toArray());
  }

  /** Shows a layer of all links, or of those alone that have it revealed. */
  show(layer: Layer, visible: boolean): void {
    if (visible) this.layers.add(layer);
    else this.layers.delete(layer);
    for (const link of this.links.keys()) this.refresh(link, layer);
  }

  /** Shows layers of single links. */
  reveal(links: Map<string, Layer[]>): void {
    const before = this.revealed;
    this.revealed = links;
    for (const link of new Set([...before.keys(), ...links.keys()]))
      for (const layer of LAYERS) this.refresh(link, layer);
  }

  private refresh(link: string, layer: Layer): void {
    const visible = this.layers.has(layer) || Boolean(this.revealed.get(link)?.includes(layer));
    let objects = this.parts.get(link)?.get(layer);
    if (visible && !objects) objects = this.build(link, layer);
    for (const object of objects ?? []) object.visible = visible;
  }

  mannerOf(link: string): Manner {
    return this.manners.get(link) ?? "shown";
  }

  /** Says how links are shown; to be painted after that. */
  setManners(manner: (link: string) => Manner): void {
    for (const [name, group] of this.links) {
      const now = manner(name);
      if (now === this.mannerOf(name)) continue;
      this.manners.set(name, now);
      group.visible = now !== "hidden";
      this.crowd?.setManner(group, now);
    }
  }

  /** Gives each shape its look. */
  paint(look: (link: string, shape: Shape) => Look, seeThrough: boolean): void {
    for (const [name, group] of this.links) this.crowd?.paint(group, (shape) => look(name, shape), seeThrough);
    for (const { link, shape, object, own } of this.drawn) {
      const chosen = look(link, shape);
      const isFaint = seeThrough || this.mannerOf(link) === "faint";
      object.renderOrder = chosen === "own" ? 0 : 1;
      const isOwn = chosen === "own" && own.length > 0;
      if (isOwn) for (const [mesh, material] of own) mesh.material = isFaint ? this.palette.faint(material) : material;
      else
        object.traverse((part) => {
          if (part instanceof Mesh) part.material = this.palette.of(shape, chosen, isFaint);
        });
    }
  }

  /** The link of a part: itself, or of a joint its child. */
  linkOf(part: string): Group | undefined {
    return this.links.get(part) ?? this.links.get(this.model.joints.find((joint) => joint.name === part)?.child ?? "");
  }

  /** What a link takes up in the world, by its shapes; ``whole``: also by those that are not shown now. */
  bounds(link: Group, whole = false): Box3 {
    const all = this.crowd?.bounds(link) ?? new Box3();
    for (const { object } of this.drawn)
      if (object.parent === link && (whole || object.visible)) all.expandByObject(object);
    return all;
  }

  /** Labels the link that is far larger than the others, and where those are: they are not to be seen beside it. */
  private markOutsized(): void {
    const sizes = [...this.links].flatMap(([name, link]): [string, Group, number][] => {
      const box = this.bounds(link, true);
      return box.isEmpty() ? [] : [[name, link, box.getSize(new Vector3()).length()]];
    });
    sizes.sort((a, b) => b[2] - a[2]);
    const [largest, second] = sizes;
    if (!second || largest[2] < OUTSIZED * second[2]) return;
    const [name, link, size] = largest;
    const large = label(`${name}: ${meters(size / second[2])} times as large as any other link`, "#a50000");
    this.bounds(link, true).getCenter(large.position).applyMatrix4(link.matrixWorld.clone().invert());
    const rest = label(`here are the other links of ${this.model.name}`, "#1b1e23");
    rest.center.set(0.5, 1.8);
    link.add(large);
    second[1].add(rest);
    this.keep(name, "visuals", large);
    this.keep(second[0], "visuals", rest);
  }

  private addShape(group: Group, link: Link, shape: Shape): void {
    const layer: Layer = shape.role === "collision" ? "collisions" : "visuals";
    if (this.crowd && (shape.mesh === null || !this.crowd.isFine)) {
      this.crowd.add(layer, group, shape);
      return;
    }
    const geometry = this.palette.geometry(shape);
    const number = shape.mesh;
    if (!geometry && number === null) return; // a kind that is not drawn
    const holder = placed(new Group(), shape.pose);
    holder.userData.isAside = shape.kind === "plane";
    holder.visible = this.layers.has(layer);
    group.add(holder);
    this.keep(link.name, layer, holder);
    const drawn: Drawn = { link: link.name, shape, object: holder, own: [] };
    this.drawn.push(drawn);
    if (geometry) holder.add(new Mesh(geometry, this.palette.of(shape, "own", false)));
    else if (number !== null && this.meshes.isRead(number)) this.fillOne(drawn);
  }

  private fillOne({ shape, object, own }: Drawn): void {
    const number = shape.mesh as number;
    const mesh = this.meshes.copy(number, shape.size);
    let isPainted = false;
    mesh.traverse((part) => {
      if (part instanceof Mesh) isPainted ||= [part.material].flat().some((each: { map?: unknown }) => each.map);
    });
    const hasOwn = !this.meshes.has(number) || (shape.role === "visual" && (isPainted || !shape.color));
    mesh.traverse((part) => {
      if (part instanceof Mesh && hasOwn) own.push([part, part.material]);
      else if (part instanceof Mesh) part.material = this.palette.of(shape, "own", false);
    });
    object.add(mesh);
  }

  private keep(link: string, layer: Layer, object: Object3D): void {
    const layers = this.parts.get(link) ?? new Map<Layer, Object3D[]>();
    layers.set(layer, [...(layers.get(layer) ?? []), object]);
    this.parts.set(link, layers);
  }

  /** The median of the sizes of links, which one shape that is far too large does not change. */
  private ordinarySize(): number {
    const sizes = [...this.links.values()]
      .map((link) => this.bounds(link, true))
      .flatMap((box) => (box.isEmpty() ? [] : [box.getSize(new Vector3()).length()]))
      .sort((a, b) => a - b);
    const joined = this.model.joints.map((joint) =>
      new Vector3(joint.pose[12], joint.pose[13], joint.pose[14]).length(),
    );
    const size = sizes.length ? sizes[sizes.length >> 1] : Math.max(...joined, 0.3) / 2;
    return Math.min(Math.max(size * 0.6, 0.01), 2);
  }

  /** Makes what a layer shows of a link, when it is first shown. */
  private build(name: string, layer: Layer): Object3D[] {
    const link = this.zero.get(name) as Link;
    const group = this.links.get(name) as Group;
    const made: Object3D[] = [];
    const add = (object: Object3D, to = group): void => {
      object.userData.isMarker = true;
      to.add(object);
      made.push(object);
    };
    if (layer === "axes")
      for (const joint of this.model.joints) if (joint.child === name && moves(joint)) this.addAxis(joint, add);
    if (layer === "inertias" && link.inertia) add(inertiaOf(link.inertia, this.unit));
    if (layer === "frames") {
      add(new Group().add(frameOf(new Matrix4().toArray(), this.unit)));
      for (const frame of link.frames) add(frameOf(frame.pose, this.unit * 0.7));
    }
    if (layer === "sensors")
      for (const sensor of link.sensors) add(placed(fieldOf(sensor, this.unit), sensor.pose));
    if (layer === "lights") for (const light of link.lights) add(lightOf(light, this.unit));
    if (layer === "empty links" && !link.shapes.length) {
      add(emptyLinkOf(this.unit));
      made[0].userData.isMarker = false;
    }
    const known = this.parts.get(name) ?? new Map<Layer, Object3D[]>();
    this.parts.set(name, known.set(layer, [...(known.get(layer) ?? []), ...made]));
    return made;
  }

  private addAxis(joint: Joint, add: (object: Object3D, to?: Group) => void): void {
    const at = (link: string): Matrix4 => {
      const zero = this.zero.get(link);
      const back = zero ? new Matrix4().fromArray(zero.pose).invert() : new Matrix4();
      return back.multiply(new Matrix4().fromArray(joint.pose));
    };
    for (const axis of joint.axes) {
      add(placed(arrowOf(axis, this.unit), at(joint.child).toArray()));
      const range = placed(rangeOf(joint, axis, this.unit), at(joint.parent).toArray());
      add(range, this.links.get(joint.parent) ?? this.group);
    }
  }
}
