// The page: reads its data, draws the robots, connects the panel.

import { Box3, Group, type Object3D, Vector3 } from "three";
import { follow, type Say } from "./follow";
import { Crowd } from "./crowd";
import type { Joint, Model, Moment, Page, Place, Shape } from "./data";
import { counterpart, differing, farthest, moved } from "./difference";
import { ofJoint, ofLink, ofModel } from "./inspect";
import { label, meters } from "./labels";
import { made } from "./made";
import { lightOf } from "./markers";
import { Meshes } from "./meshes";
import { type Actions, type Deed, Panel, Tools, type Unfolded } from "./panel";
import { type Hand, movedBy, Pointer } from "./pointer";
import { LAYERS, type Layer, type Manner, Robot } from "./robot";
import { type Look, Palette } from "./shapes";
import { movable, type Moved } from "./sliders";
import { type Hit, Stage, VIEWS } from "./stage";
import { fragmentOf, key, type Mode, type State, stateOf } from "./state";

/** A file as it is drawn. */
interface Drawn {
  group: Group;
  robots: Robot[];
  lights: Object3D[];
  crowd: [string, Object3D][];
}

/** Two models that are compared, and what is different in them. */
interface Pair {
  first: Robot;
  second: Robot;
  shapes: Set<Shape>;
  inertias: Set<string>;
  /** Links that are elsewhere now. */
  moved: Map<string, number>;
}

const SEVERAL = 300; // shapes, beyond which those of a kind are drawn together
const OFTEN = 300; // ms: the address changes no more often
const OF_SELECTED: Layer[] = ["inertias", "frames", "axes", "sensors", "empty links"];

/** What a person has set, so that the next robot is shown in the same way. */
export interface Kept extends State {
  unfolded: Unfolded;
}

const COLORS = { error: "#a50000", warning: "#8f5200", info: "#1864ab" };

export class Viewer implements Actions, Hand {
  private readonly scenes: Drawn[];
  private readonly robots: Robot[];
  private readonly byModel: Map<string, Robot>;
  private readonly pairs: Pair[] = [];
  private readonly panel: Panel;
  private readonly tools: Tools;
  /** What is shown at first. */
  private readonly plain: Set<Layer>;
  private state: State;
  /** The layer of the selected part that a finding is about. */
  private about: string | null = null;
  private written = 0;
  private timer: ReturnType<typeof setTimeout> | null = null;
  isMoving = false;
  isMeasuring = false;

  /** `kept`: what a person has set before; `say`: tells the server, if the robot follows its text. */
  constructor(
    private readonly page: Page,
    private readonly stage: Stage,
    private readonly meshes: Meshes,
    private readonly pointer: Pointer,
    kept: Kept | null = null,
    private readonly say: Say = () => {},
  ) {
    const shapes = shapesOf(page);
    const palette = new Palette();
    this.scenes = page.scenes.map((scene) => {
      const group = new Group();
      stage.content.add(group);
      const crowd = shapes > SEVERAL ? new Crowd(group, shapes <= page.mostShapes) : null;
      const robots = scene.models.map((model) => new Robot(model, meshes, palette, crowd));
      for (const robot of robots) group.add(robot.group);
      const lights = scene.lights.map((light) => lightOf(light, 0.5));
      for (const light of lights) group.add(light);
      return { group, robots, lights, crowd: crowd?.build() ?? [] };
    });
    this.robots = this.scenes.flatMap((scene) => scene.robots);
    this.byModel = new Map([...this.robots].reverse().map((robot) => [robot.model.name, robot]));
    this.compare();
    this.plain = this.shownAtFirst();
    this.state = kept ?? stateOf(this.hasAddress ? location.hash : "", this.plain, this.linkKeys());
    this.panel = new Panel(document.getElementById("panel") as HTMLElement, page, this);
    this.tools = new Tools(document.getElementById("tools") as HTMLElement, layersOf(page), Object.keys(VIEWS), this.toggles(), this);
    this.panel.fill(this.sliders(), this.state.mode);
    pointer.hand = this;
    document.onkeydown = (event) => this.pressed(event);
    stage.onLook = () => this.legend();
    stage.onTurn = () => this.remember();
    meshes.onPicture = () => stage.draw();
    this.restore(this.state);
    if (kept) this.panel.unfold(kept.unfolded);
    else if (this.hasAddress) window.onhashchange = () => this.restore(stateOf(location.hash, this.plain, this.linkKeys()));
  }

  /** Draws meshes that were read since. */
  grow(numbers: number[]): void {
    if (!this.robots.filter((robot) => robot.fill(numbers)).length) return;
    this.paint();
    this.stage.look();
    this.stage.drawNow();
    performance.mark("picture");
  }

  /** Is called when all meshes are there. */
  finish(): void {
    for (const robot of this.robots) robot.finish();
    this.panel.tell([...this.page.scenes.flatMap((scene) => scene.notes), ...this.meshes.notes()]);
    this.arrange();
    if (this.page.live) this.markFindings();
    this.point(this.state.places, this.state.places.length > 0 && !this.page.live);
    this.stage.look();
    this.stage.drawNow();
    this.legend();
  }

  /** Numbers of the meshes of shapes that are shown. */
  wanted(): Set<number> {
    const shown = new Set<string>([...this.state.layers].map((layer) => layer.slice(0, -1)));
    const shapes = this.robots.flatMap((robot) => robot.model.links.flatMap((link) => link.shapes));
    return new Set(shapes.flatMap(({ role, mesh }) => (mesh !== null && shown.has(role) ? [mesh] : [])));
  }

  /** What a person has set. */
  kept(): Kept {
    const positions = new Map(this.robots.map((robot) => [robot.model.name, robot.positions]));
    return { ...this.state, positions, unfolded: this.panel.unfolded() };
  }

  private get hasAddress(): boolean {
    return !this.page.live && location.protocol !== "about:";
  }

  private linkKeys(): string[] {
    return this.robots.flatMap(({ model }) => model.links.map((link) => key(model.name, link.name)));
  }

  /** Shows what a person had set. */
  private restore(state: State): void {
    this.state = state;
    for (const robot of this.robots) {
      const joints = new Set(robot.model.joints.map((joint) => joint.name));
      robot.positions.clear();
      for (const [name, values] of state.positions.get(robot.model.name) ?? [])
        if (joints.has(name)) robot.positions.set(name, values);
      robot.move();
    }
    for (const pair of this.pairs) pair.moved = moved(pair.first.model, pair.second.model, pair.first.positions);
    for (const layer of LAYERS) this.show(layer, state.layers.has(layer));
    this.tools.setLayers(state.layers);
    this.panel.refresh();
    this.setManners();
    this.arrange();
    this.stage.setFlat(state.isFlat);
    this.stage.resize();
    if (state.camera) this.stage.see(state.camera);
    this.point(state.places, true);
    this.showToggles();
    this.stage.drawNow();
  }

  /** Writes what is set into the address, soon. */
  private remember(): void {
    this.state.camera = this.stage.isHeld ? this.stage.seen() : null;
    if (!this.hasAddress || this.timer) return;
    const wait = Math.max(0, this.written + OFTEN - performance.now());
    const write = (): void => {
      this.timer = null;
      this.written = performance.now();
      history.replaceState(null, "", `#${fragmentOf(this.kept(), this.plain, this.linkKeys())}`);
    };
    if (wait) this.timer = setTimeout(write, wait);
    else write();
  }

  // What the panel asks for.

  layer(layer: Layer, visible: boolean): void {
    if (visible) this.state.layers.add(layer);
    else this.state.layers.delete(layer);
    this.show(layer, visible);
    this.setManners(layer);
    this.paint();
    this.stage.look();
    this.stage.draw();
    this.remember();
  }

  view(name: string): void {
    this.stage.look(VIEWS[name], true);
    this.stage.isHeld = name !== "Fit";
    this.remember();
  }

  arrangeAs(mode: Mode): void {
    this.state.mode = mode;
    this.arrange();
    this.view("Fit");
  }

  select(place: Place, layer: string | null = null, finding?: number, moment?: Moment): void {
    this.about = layer;
    this.recall(place.model, moment);
    this.point([place]);
    this.say({ kind: "picked", ...place, ...(finding === undefined ? {} : { finding }) });
    this.remember();
  }

  choose(values: Record<string, string>): void {
    this.say({ kind: "arguments", values });
  }

  mannerOf({ model, part }: Place): Manner {
    const { hidden, faint } = this.state;
    if (!hidden.size && !faint.size) return "shown";
    const keys = part === null ? [...(this.byModel.get(model ?? "")?.links.keys() ?? [])] : [part];
    if (keys.length && keys.every((link) => hidden.has(key(model ?? "", link)))) return "hidden";
    return keys.length && keys.every((link) => faint.has(key(model ?? "", link))) ? "faint" : "shown";
  }

  do(deed: Deed, place?: Place): void {
    const places = place ? [place] : this.state.places;
    const keys = places.flatMap((each) => this.linksOf(each).map(([robot, link]) => key(robot.model.name, link)));
    const { hidden, faint } = this.state;
    if (deed === "zoom") {
      const bounds = places.length ? this.boundsOf(places[0]) : null;
      if (bounds) this.stage.lookAt(bounds);
    } else if (deed === "show all") {
      hidden.clear();
      faint.clear();
    } else if (deed === "isolate" && keys.length) {
      const others = this.linkKeys().filter((link) => !keys.includes(link));
      const isAlone = others.every((link) => hidden.has(link));
      hidden.clear();
      if (!isAlone) for (const link of others) hidden.add(link);
    } else {
      const set = deed === "hide" ? hidden : faint;
      const isIn = keys.every((link) => set.has(link));
      for (const link of keys)
        if (isIn) set.delete(link);
        else set.add(link);
    }
    this.setManners();
    this.paint();
    this.panel.drawTree();
    this.showToggles();
    this.stage.draw();
    this.remember();
  }

  // What the pointer asks for.

  pick(hit: Hit | null): void {
    const robot = hit?.link.userData.robot as Robot | undefined;
    if (robot) this.select({ model: robot.model.name, part: hit?.link.userData.link as string });
    else if (!this.page.live) this.deselect();
  }

  name({ link }: Hit): string {
    const robot = link.userData.robot as Robot;
    const name = link.userData.link as string;
    const joint = robot.model.joints.find((each) => each.child === name);
    const model = this.robots.length > 1 ? `${robot.model.name}: ` : "";
    const moves = this.isMoving ? movedBy(robot, name) : null;
    if (this.isMoving) return moves ? `${name}: drag to move ${moves.joint.name}` : `${name}: no joint moves it`;
    return `${model}${name}${joint ? ` — ${joint.name} (${joint.kind})` : ""}`;
  }

  moved(robot: Robot, joint: Joint): void {
    const pair = this.pairs.find(({ first, second }) => first === robot || second === robot);
    if (pair?.second === robot) pair.first.positions.set(joint.name, robot.positions.get(joint.name) ?? []);
    this.follow(pair?.first ?? robot, pair);
    this.panel.refresh();
  }

  measured(words: string): void {
    this.tools.measured.textContent = words;
  }

  /** Puts a robot to where it is when something happens, and marks where; no point without a moment. */
  private recall(model: string | null, moment?: Moment): void {
    for (const robot of this.robots) robot.mark([]);
    const robot = this.byModel.get(model ?? "");
    if (!moment || !robot) return;
    robot.positions.clear();
    for (const [joint, position] of Object.entries(moment.positions)) robot.positions.set(joint, [position, 0]);
    robot.mark(moment.points);
    this.follow(robot, this.pairs.find(({ first }) => first === robot));
    this.panel.refresh();
  }

  private deselect(): void {
    this.about = null;
    this.recall(null);
    this.point([]);
    this.remember();
  }

  private toggles(): Record<string, [hint: string, action: () => void]> {
    return {
      Orthographic: ["Draw without perspective (P)", () => this.flatten()],
      "Move joints": ["Drag links to move their joints (J); Shift and drag does it, too", () => this.toggle("isMoving")],
      Measure: ["Measure between two points (M)", () => this.toggle("isMeasuring")],
      "Show all": ["Show hidden links again (A)", () => this.do("show all")],
    };
  }

  private showToggles(): void {
    this.tools.setSwitch("Orthographic", this.stage.isFlat);
    this.tools.setSwitch("Move joints", this.isMoving);
    this.tools.setSwitch("Measure", this.isMeasuring);
    this.tools.setSwitch("Show all", this.state.hidden.size + this.state.faint.size > 0 || null);
  }

  private flatten(): void {
    this.state.isFlat = !this.stage.isFlat;
    this.stage.setFlat(this.state.isFlat);
    this.showToggles();
    this.remember();
  }

  private toggle(tool: "isMoving" | "isMeasuring"): void {
    const isOn = !this[tool];
    this.isMoving = this.isMeasuring = false;
    this[tool] = isOn;
    this.pointer.clear();
    this.measured(this.isMeasuring ? "Choose two points." : "");
    this.showToggles();
  }

  private pressed(event: KeyboardEvent): void {
    const { target } = event;
    const isTyping =
      target instanceof HTMLSelectElement || (target instanceof HTMLInputElement && !["range", "checkbox", "radio"].includes(target.type));
    if (isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
    const deeds: Record<string, () => void> = {
      h: () => this.do("hide"),
      i: () => this.do("isolate"),
      t: () => this.do("faint"),
      z: () => this.do("zoom"),
      a: () => this.do("show all"),
      f: () => this.view("Fit"),
      p: () => this.flatten(),
      m: () => this.toggle("isMeasuring"),
      j: () => this.toggle("isMoving"),
      "/": () => this.panel.seek(),
      Escape: () => {
        if (this.isMeasuring) this.toggle("isMeasuring");
        else if (this.isMoving) this.toggle("isMoving");
        else this.deselect();
      },
    };
    const deed = deeds[event.key] ?? deeds[event.key.toLowerCase()];
    if (!deed) return;
    event.preventDefault();
    deed();
  }

  /** Marks parts, in the picture and in the lists. */
  point(places: Place[], reveal = true): void {
    this.state.places = places;
    this.revealSelected();
    this.stage.mark(
      places.flatMap((place): [string, Box3][] => {
        const bounds = this.boundsOf(place);
        return bounds ? [[place.part ?? place.model ?? "", bounds]] : [];
      }),
    );
    this.panel.highlight(places, reveal);
    this.inspect();
  }

  /** Shows inertia, frame and axis of selected links, their collisions if there is nothing else, and what a finding is about. */
  private revealSelected(): void {
    const revealed = new Map<Robot, Map<string, Layer[]>>();
    for (const place of this.state.places)
      if (place.part !== null)
        for (const [robot, link] of this.linksOf(place)) {
          const layers = robot.links.has(place.part) ? [...OF_SELECTED] : (["frames", "axes"] as Layer[]);
          const shapes = robot.model.links.find(({ name }) => name === link)?.shapes ?? [];
          if (!shapes.some((shape) => shape.role === "visual")) layers.push("collisions");
          if (this.about) layers.push(this.about as Layer);
          revealed.set(robot, (revealed.get(robot) ?? new Map<string, Layer[]>()).set(link, layers));
        }
    for (const robot of this.robots) robot.reveal(revealed.get(robot) ?? new Map());
    this.stage.draw();
  }

  /** Shows what is known of the first of the selected parts. */
  private inspect(): void {
    const [place] = this.state.places as (Place | undefined)[];
    const robot = place && this.robots.find(({ model, links }) =>
      place.model === null ? links.has(place.part ?? "") : model.name === place.model);
    if (!place || !robot) return this.panel.inspect("", [], false);
    const { model, positions } = robot;
    const link = model.links.find((each) => each.name === place.part);
    const joint = model.joints.find((each) => each.name === place.part);
    if (link) this.panel.inspect(link.name, ofLink(model, link, positions, this.page.meshes), true);
    else if (joint) this.panel.inspect(joint.name, ofJoint(model, joint, positions), true);
    else this.panel.inspect(model.name, ofModel(model), true);
  }

  /** The links of a place, of a joint its child, of a model all. */
  private linksOf({ model, part }: Place): [Robot, string][] {
    const robots = this.robots.filter((robot) => model === null || robot.model.name === model);
    return robots.flatMap((robot): [Robot, string][] => {
      const links = part === null ? [...robot.links.values()] : [robot.linkOf(part)];
      return links.flatMap((link): [Robot, string][] => (link ? [[robot, link.userData.link as string]] : []));
    });
  }

  /** What a part takes up; null where there is no such part. */
  private boundsOf(place: Place): Box3 | null {
    const bounds = new Box3();
    let found = false;
    for (const { group, robots } of this.scenes) {
      if (!group.visible) continue;
      for (const robot of robots) {
        if (place.model !== null && robot.model.name !== place.model) continue;
        const links = place.part === null ? [...robot.links.values()] : [robot.linkOf(place.part)];
        for (const link of links)
          if (link) {
            const own = robot.bounds(link);
            bounds.union(own.isEmpty() ? new Box3().expandByPoint(link.getWorldPosition(new Vector3())) : own);
            found = true;
          }
        if (found) break;
      }
      if (found) break;
    }
    return found ? bounds : null;
  }

  /** Writes the codes of findings on the links that they are about. */
  private markFindings(): void {
    const codes = new Map<Group, { robot: Robot; words: Set<string>; color: string }>();
    for (const { model, part, code, severity } of this.page.findings)
      for (const robot of this.robots) {
        const link = part !== null && robot.model.name === model ? robot.linkOf(part) : undefined;
        if (!link || severity === "info") continue;
        const known = codes.get(link) ?? { robot, words: new Set(), color: COLORS[severity] };
        known.words.add(code);
        codes.set(link, known);
      }
    for (const [link, { robot, words, color }] of codes) {
      const box = robot.bounds(link);
      const mark = label(`⚠ ${[...words].join(" ")}`, color);
      if (!box.isEmpty()) box.getCenter(mark.position).applyMatrix4(link.matrixWorld.clone().invert());
      mark.userData.finding = link.userData.link;
      link.add(mark);
    }
  }

  /** Where the camera is and what it looks at. For tests, as what follows. */
  camera(): number[] {
    return this.stage.seen();
  }

  /** Where the middle of a link is on the screen. */
  onScreen(part: string): number[] {
    const bounds = this.boundsOf({ model: null, part });
    return bounds ? this.stage.onScreen(bounds.getCenter(new Vector3())) : [];
  }

  /** The points that are marked. */
  points(): number[][] {
    return this.robots.flatMap((robot) => robot.marked());
  }

  /** The words on the links, by link. */
  findingMarks(): string[] {
    const found: string[] = [];
    this.stage.content.traverse((part) => {
      if (part.userData.finding !== undefined) found.push(part.userData.finding as string);
    });
    return found;
  }

  // How it comes about.

  private compare(): void {
    if (this.scenes.length < 2) return;
    const [before, after] = this.scenes.map((scene) => scene.robots);
    const models = (robots: Robot[]): Model[] => robots.map((robot) => robot.model);
    for (const first of before) {
      const other = counterpart(first.model, models(after), models(before));
      const second = after.find((robot) => robot.model === other);
      if (!second) continue;
      const { shapes, inertias } = differing(first.model, second.model, this.page.meshes);
      this.pairs.push({ first, second, shapes, inertias, moved: moved(first.model, second.model, new Map()) });
    }
  }

  /** Only what consumers of the robot see, and what differs; where nothing would be seen, what there is. */
  private shownAtFirst(): Set<Layer> {
    const links = this.robots.flatMap((robot) => robot.model.links);
    const has = (role: Shape["role"]): boolean => links.some((link) => link.shapes.some((shape) => shape.role === role));
    const shown = new Set<Layer>(["visuals"]);
    const differs = this.pairs.some(({ shapes }) => [...shapes].some((shape) => shape.role === "collision"));
    if (!has("visual") || differs) shown.add("collisions");
    if (!has("visual") && !has("collision")) shown.add("empty links");
    return shown;
  }

  private sliders(): Moved[] {
    const paired = new Set(this.pairs.map((pair) => pair.second));
    return this.scenes
      .flatMap(({ robots }) => robots)
      .filter((robot) => !paired.has(robot))
      .map((robot) => {
        const pair = this.pairs.find((one) => one.first === robot);
        const { positions } = robot;
        return {
          model: robot.model,
          joints: movable(robot.model, pair?.second.model),
          positions,
          changed: () => this.follow(robot, pair),
          differMost: pair ? () => this.differMost(pair, positions) : null,
        };
      });
  }

  /** Puts links where the positions of joints say. */
  private follow(robot: Robot, pair: Pair | undefined): void {
    robot.move();
    if (pair) {
      pair.second.positions.clear();
      for (const [name, values] of robot.positions) pair.second.positions.set(name, [...values]);
      pair.second.move();
      pair.moved = moved(robot.model, pair.second.model, robot.positions);
      this.paint();
    }
    this.inspect();
    this.stage.draw();
    this.remember();
  }

  private differMost(pair: Pair, positions: Map<string, number[]>): string {
    const found = farthest(pair.first.model, pair.second.model);
    if (!found.link) return "Their links are in the same places in all configurations that were tried.";
    positions.clear();
    for (const [name, values] of found.positions) positions.set(name, values);
    return `${found.link} is up to ${meters(found.distance)} m apart`;
  }

  private show(layer: Layer, visible: boolean): void {
    for (const { robots, lights, crowd } of this.scenes) {
      for (const robot of robots) robot.show(layer, visible);
      for (const [own, mesh] of crowd) if (own === layer) mesh.visible = visible;
      if (layer === "lights") for (const light of lights) light.visible = visible;
    }
  }

  private setManners(layer?: Layer): void {
    const { hidden, faint } = this.state;
    const has = layer === undefined || layer === "visuals" || layer === "collisions";
    if (!has) return;
    for (const robot of this.robots)
      robot.setManners((link) => {
        const name = key(robot.model.name, link);
        return hidden.has(name) ? "hidden" : faint.has(name) ? "faint" : "shown";
      });
  }

  /** Puts two robots beside or over each other, and shows which are asked for. */
  private arrange(): void {
    const [first, second] = this.scenes;
    if (second) {
      first.group.visible = this.state.mode !== "only the second";
      second.group.visible = this.state.mode !== "only the first";
      second.group.position.set(0, 0, 0);
      second.group.updateMatrixWorld(true);
      if (this.state.mode === "side by side") {
        const [a, b] = [first, second].map((scene) => this.taken(scene));
        const wide = [a, b].flatMap((box) => box.getSize(new Vector3()).toArray().slice(0, 2));
        second.group.position.y = a.max.y - b.min.y + Math.max(...wide) * 0.7;
      }
      second.group.updateMatrixWorld(true);
    }
    this.paint();
  }

  /** What the robots of a scene take up. */
  private taken(scene: Drawn): Box3 {
    const all = new Box3();
    for (const robot of scene.robots) for (const link of robot.links.values()) all.union(robot.bounds(link, true));
    if (all.isEmpty()) all.set(new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 1));
    return all;
  }

  private paint(): void {
    const isOver = this.state.mode === "over each other";
    const seeThrough = isOver || this.state.layers.has("inertias") || this.state.layers.has("collisions");
    const paired = new Map<Robot, [Pair, Look]>();
    for (const pair of this.pairs) {
      paired.set(pair.first, [pair, "before"]);
      paired.set(pair.second, [pair, "after"]);
    }
    this.scenes.forEach(({ robots }, index) => {
      for (const robot of robots) {
        const [pair, marked] = paired.get(robot) ?? [null, index ? "after" : "before"];
        const differs = (link: string, shape: Shape): boolean =>
          this.scenes.length > 1 && (!pair || pair.shapes.has(shape) || pair.moved.has(link));
        robot.paint((link, shape) => (differs(link, shape) ? (marked as Look) : "own"), seeThrough);
      }
    });
  }

  private legend(): void {
    const legend = document.getElementById("legend") as HTMLElement;
    const lines = [`grid: ${meters(this.stage.cell)} m`];
    const marks = this.page.scenes.length > 1 ? ["before", "after"] : [];
    legend.replaceChildren(
      ...[...lines, ...marks].map((text, index) => {
        const line = document.createElement("span");
        line.className = text;
        line.textContent = index ? `different in ${this.page.scenes[index - 1].file}` : text;
        return line;
      }),
    );
  }

  /** Draws; returns how many drawing calls that took. For tests, as what follows. */
  draw(): number {
    return this.stage.drawNow();
  }

  /** The size of the selected part. */
  size(): number[] {
    return this.stage.marked?.getSize(new Vector3()).toArray() ?? [];
  }

  /** Shapes that are marked as different, each as its role and link. */
  marked(scene: number): string[] {
    const robots = new Set(this.scenes[scene].robots);
    return this.pairs.flatMap((pair) =>
      [pair.first, pair.second].flatMap((robot) =>
        robots.has(robot)
          ? robot.model.links.flatMap((link) =>
              link.shapes.flatMap((shape) =>
                pair.shapes.has(shape) || pair.moved.has(link.name) ? [`${shape.role} ${link.name}`] : [],
              ),
            )
          : [],
      ),
    );
  }

  /** The poses of the links of each robot in its frame, as they are drawn, by model. */
  poses(scene = 0): Record<string, Record<string, number[]>> {
    return Object.fromEntries(
      this.scenes[scene].robots.map(({ model, links }) => [
        model.name,
        Object.fromEntries([...links].map(([name, link]) => [name, link.matrix.toArray()])),
      ]),
    );
  }
}

function shapesOf(page: Page): number {
  const links = page.scenes.flatMap((scene) => scene.models).flatMap((model) => model.links);
  return links.reduce((sum, link) => sum + link.shapes.length, 0);
}

/** The layers that show something of these robots. */
function layersOf(page: Page): Layer[] {
  const models = page.scenes.flatMap((scene) => scene.models);
  const links = models.flatMap((model) => model.links);
  const has: Record<Layer, () => boolean> = {
    visuals: () => true,
    collisions: () => links.some((link) => link.shapes.some((shape) => shape.role === "collision")),
    inertias: () => links.some((link) => link.inertia),
    axes: () => models.some((model) => model.joints.some((joint) => joint.axes.length)),
    frames: () => true,
    sensors: () => links.some((link) => link.sensors.length),
    lights: () => page.scenes.some((scene) => scene.lights.length) || links.some((link) => link.lights.length),
    "empty links": () => links.some((link) => !link.shapes.length),
  };
  return LAYERS.filter((layer) => has[layer]());
}

/** The picture as paper has it: what a canvas shows is not printed everywhere. */
function print(stage: Stage): void {
  let picture: HTMLImageElement | null = null;
  addEventListener("beforeprint", () => {
    picture = made("img", { alt: "The robot", src: stage.picture() });
    stage.canvas.after(picture);
  });
  addEventListener("afterprint", () => picture?.remove());
}

/** Lets the panel be folded; until somebody chooses, it is where there is little room, also in a frame that gets its size later. */
function fold(button: HTMLButtonElement): void {
  const wide = matchMedia(`(min-width: ${ROOM}px)`);
  const set = (isOpen: boolean): void => {
    document.body.classList.toggle("folded", !isOpen);
    button.setAttribute("aria-expanded", String(isOpen));
  };
  const fit = (): void => set(wide.matches);
  button.addEventListener("click", () => {
    wide.removeEventListener("change", fit);
    set(document.body.classList.contains("folded"));
  });
  wide.addEventListener("change", fit);
  fit();
}

const ROOM = 821; // pixels, from which the panel fits beside the picture

async function start(page: Page): Promise<void> {
  fold(document.getElementById("fold") as HTMLButtonElement);
  const stage = new Stage(document.querySelector("canvas") as HTMLCanvasElement, shapesOf(page) <= page.mostShapes);
  const pointer = new Pointer(stage);
  (document.getElementById("no-webgl") as HTMLElement).hidden = stage.works;
  print(stage);
  if (page.live) {
    follow(page.live, stage, pointer, Viewer);
    return;
  }
  const meshes = new Meshes(page.meshes);
  const viewer = new Viewer(page, stage, meshes, pointer);
  Object.assign(window, { viewer });
  await meshes.load(viewer.wanted(), (numbers) => viewer.grow(numbers));
  viewer.finish();
  document.documentElement.dataset.ready = "true";
}

const data = document.getElementById("data")?.textContent;
if (data) void start(JSON.parse(data) as Page);
