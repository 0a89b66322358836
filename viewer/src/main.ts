// The page: reads its data, draws the robots, connects the panel.

import { Box3, Group, type Object3D, Vector3 } from "three";
import { follow, type Say } from "./follow";
import { Crowd } from "./crowd";
import type { Model, Page, Place, Shape } from "./data";
import { counterpart, differing, farthest, moved } from "./difference";
import { label, meters } from "./labels";
import { lightOf } from "./markers";
import { Meshes } from "./meshes";
import { type Actions, type Mode, type Moved, movable, Panel, type Unfolded } from "./panel";
import { LAYERS, type Layer, Robot } from "./robot";
import { type Look, Palette } from "./shapes";
import { Stage, VIEWS } from "./stage";

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
const MANY = 200; // joints or links, beyond which what marks them is not shown unasked

/** What a person has set, so that the next robot is shown in the same way. */
export interface Kept {
  layers: Set<Layer>;
  mode: Mode;
  /** Model → the positions of its joints. */
  positions: Map<string, Map<string, number[]>>;
  places: Place[];
  unfolded: Unfolded;
}

const COLORS = { error: "#a50000", warning: "#8f5200", info: "#1864ab" };

export class Viewer implements Actions {
  private readonly scenes: Drawn[];
  private readonly pairs: Pair[] = [];
  private layers = new Set<Layer>(["visuals", "lights"]);
  private readonly panel: Panel;
  private mode: Mode = "side by side";
  private places: Place[] = [];

  /** `kept`: what a person has set before; `say`: tells the server, if the robot follows its text. */
  constructor(
    private readonly page: Page,
    private readonly stage: Stage,
    meshes: Meshes,
    kept: Kept | null = null,
    private readonly say: Say = () => {},
  ) {
    const models = page.scenes.flatMap((scene) => scene.models);
    const shapes = shapesOf(page);
    const palette = new Palette();
    if (models.reduce((sum, model) => sum + model.joints.length, 0) <= MANY) this.layers.add("axes");
    const empty = models.flatMap((model) => model.links).filter((link) => !link.shapes.length);
    if (empty.length <= MANY) this.layers.add("empty links");
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
    this.panel = new Panel(document.getElementById("panel") as HTMLElement, page, this);
    this.compare();
    this.showFindings();
    if (kept) this.keep(kept);
    const notes = [...page.scenes.flatMap((scene) => scene.notes), ...meshes.notes()];
    this.panel.fill(this.sliders(), notes, this.layers, Object.keys(VIEWS));
    for (const layer of LAYERS) this.show(layer, this.layers.has(layer));
    this.arrange();
    if (page.live) this.markFindings();
    stage.onLook = () => this.legend();
    if (kept) {
      this.panel.unfold(kept.unfolded);
      this.point(kept.places, false);
      this.legend();
    } else stage.resize();
    stage.draw();
    stage.onPick = (link) => {
      const robot = link.userData.robot as Robot;
      this.select({ model: robot.model.name, part: link.userData.link as string });
    };
  }

  /** What a person has set. */
  kept(): Kept {
    const robots = this.scenes.flatMap((scene) => scene.robots);
    const { layers, mode, places } = this;
    const positions = new Map(robots.map((robot) => [robot.model.name, robot.positions]));
    return { layers, mode, places, positions, unfolded: this.panel.unfolded() };
  }

  private keep(kept: Kept): void {
    this.layers = kept.layers;
    this.mode = kept.mode;
    for (const robot of this.scenes.flatMap((scene) => scene.robots)) {
      const joints = new Set(robot.model.joints.map((joint) => joint.name));
      for (const [name, values] of kept.positions.get(robot.model.name) ?? [])
        if (joints.has(name)) robot.positions.set(name, values);
      robot.move();
    }
  }

  // What the panel asks for.

  layer(layer: Layer, visible: boolean): void {
    if (visible) this.layers.add(layer);
    else this.layers.delete(layer);
    this.show(layer, visible);
    this.paint();
    this.stage.look();
    this.stage.draw();
  }

  view(name: string): void {
    this.stage.look(VIEWS[name], true);
  }

  arrangeAs(mode: Mode): void {
    this.mode = mode;
    this.arrange();
    this.stage.look(VIEWS.Fit, true);
  }

  select(place: Place, layer: string | null = null, finding?: number): void {
    if (layer) this.panel.turnOn(layer);
    this.point([place]);
    this.say({ kind: "picked", ...place, ...(finding === undefined ? {} : { finding }) });
    if (this.page.live) return;
    const chosen = Object.entries(place).filter((entry): entry is [string, string] => entry[1] !== null);
    if (location.protocol !== "about:") history.replaceState(null, "", `#${new URLSearchParams(chosen)}`);
  }

  choose(values: Record<string, string>): void {
    this.say({ kind: "arguments", values });
  }

  /** Marks parts, in the picture and in the lists. */
  point(places: Place[], reveal = true): void {
    this.places = places;
    this.stage.mark(
      places.flatMap((place): [string, Box3][] => {
        const bounds = this.boundsOf(place);
        return bounds ? [[place.part ?? place.model ?? "", bounds]] : [];
      }),
    );
    this.panel.highlight(places, reveal);
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
      for (const robot of this.scenes.flatMap((scene) => scene.robots)) {
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
      if ([...shapes].some((shape) => shape.role === "collision")) this.layers.add("collisions");
      if (inertias.size) this.layers.add("inertias");
    }
  }

  /** Shows what findings are about, where it is not shown anyway. */
  private showFindings(): void {
    for (const { layer, severity } of this.page.findings)
      if (severity !== "info" && (layer === "inertias" || layer === "collisions" || layer === "sensors"))
        this.layers.add(layer);
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
          changed: () => this.moved(robot, pair),
          differMost: pair ? () => this.differMost(pair, positions) : null,
        };
      });
  }

  private moved(robot: Robot, pair: Pair | undefined): void {
    robot.move();
    if (pair) {
      pair.second.positions.clear();
      for (const [name, values] of robot.positions) pair.second.positions.set(name, [...values]);
      pair.second.move();
      pair.moved = moved(robot.model, pair.second.model, robot.positions);
      this.paint();
    }
    this.stage.draw();
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

  /** Puts two robots beside or over each other, and shows which are asked for. */
  private arrange(): void {
    const [first, second] = this.scenes;
    if (second) {
      first.group.visible = this.mode !== "only the second";
      second.group.visible = this.mode !== "only the first";
      second.group.position.set(0, 0, 0);
      second.group.updateMatrixWorld(true);
      if (this.mode === "side by side") {
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
    for (const robot of scene.robots) for (const link of robot.links.values()) all.union(robot.bounds(link));
    if (all.isEmpty()) all.set(new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 1));
    return all;
  }

  private paint(): void {
    const isOver = this.mode === "over each other";
    const seeThrough = isOver || this.layers.has("inertias") || this.layers.has("collisions");
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

async function start(page: Page): Promise<void> {
  const stage = new Stage(document.querySelector("canvas") as HTMLCanvasElement, shapesOf(page) <= page.mostShapes);
  (document.getElementById("no-webgl") as HTMLElement).hidden = stage.works;
  if (page.live) {
    follow(page.live, stage, Viewer);
    return;
  }
  const meshes = new Meshes(page.meshes);
  await meshes.load();
  const viewer = new Viewer(page, stage, meshes);
  const chosen = new URLSearchParams(location.hash.slice(1));
  if (chosen.has("part") || chosen.has("model"))
    viewer.select({ model: chosen.get("model"), part: chosen.get("part") });
  Object.assign(window, { viewer });
  document.documentElement.dataset.ready = "true";
}

const data = document.getElementById("data")?.textContent;
if (data) void start(JSON.parse(data) as Page);
