// The page: reads its data, draws the robots, connects the panel.

import {
  AmbientLight, Box3, Box3Helper, Color, DirectionalLight, GridHelper, Group, Object3D, PerspectiveCamera, Raycaster,
  Scene as World, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Page } from "./data";
import { Meshes } from "./meshes";
import { fill } from "./panel";
import { type Layer, Robot } from "./robot";

Object3D.DEFAULT_UP.set(0, 0, 1); // as robots have it

const TINTS = [null, 0xe8590c];

function start(page: Page): void {
  const canvas = document.querySelector("canvas") as HTMLCanvasElement;
  const panel = document.getElementById("panel") as HTMLElement;
  const meshes = new Meshes(page.meshes);
  const shapes = page.scenes.flatMap((one) => one.models).flatMap((model) => model.links)
    .reduce((sum, link) => sum + link.shapes.length, 0);
  const robots = page.scenes.flatMap((one, index) =>
    one.models.map((model) => new Robot(model, meshes, TINTS[index] ?? null, shapes <= page.mostShapes)));

  const world = new World();
  world.background = new Color(matchMedia("(prefers-color-scheme: dark)").matches ? 0x1b1e23 : 0xf4f5f7);
  world.add(new AmbientLight(0xffffff, 1.4), new DirectionalLight(0xffffff, 1.6));
  world.children[1].position.set(2, -3, 5);
  const stage = new Group();
  for (const robot of robots) stage.add(robot.group);
  world.add(stage);

  const bounds = new Box3().setFromObject(stage);
  if (bounds.isEmpty()) bounds.set(new Vector3(-0.5, -0.5, 0), new Vector3(0.5, 0.5, 1));
  const size = Math.min(Math.max(bounds.getSize(new Vector3()).length(), 0.2), 200);
  const grid = new GridHelper(Math.ceil(size * 2), Math.min(Math.ceil(size * 2), 40), 0x888888, 0xbbbbbb);
  grid.rotateX(Math.PI / 2);
  world.add(grid);

  const camera = new PerspectiveCamera(45, 1, size / 1000, size * 50);
  const middle = bounds.getCenter(new Vector3());
  camera.position.copy(middle).add(new Vector3(1, -1, 0.7).multiplyScalar(size));

  let renderer: WebGLRenderer | null = null;
  try {
    renderer = new WebGLRenderer({ canvas, antialias: true });
  } catch {
    (document.getElementById("no-webgl") as HTMLElement).hidden = false;
  }
  let waiting = false;
  const draw = (): void => {
    if (waiting || !renderer) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      renderer?.render(world, camera);
    });
  };
  const controls = new OrbitControls(camera, canvas);
  controls.target.copy(middle);
  controls.addEventListener("change", draw);
  controls.update();
  const resize = (): void => {
    const { clientWidth, clientHeight } = canvas.parentElement as HTMLElement;
    renderer?.setSize(clientWidth, clientHeight);
    camera.aspect = clientWidth / Math.max(clientHeight, 1);
    camera.updateProjectionMatrix();
    draw();
  };
  addEventListener("resize", resize);
  document.addEventListener("drawn", draw);

  let marker: Box3Helper | null = null;
  const select = (name: string): void => {
    if (marker) world.remove(marker);
    marker = null;
    const link = robots.map((robot) => robot.links.get(name) ?? robot.links.get(
      robot.model.joints.find((joint) => joint.name === name)?.child ?? "")).find(Boolean);
    if (link) {
      const box = new Box3().setFromObject(link);
      marker = new Box3Helper(box.isEmpty() ? new Box3(new Vector3(), new Vector3()) : box, new Color(0xf08c00));
      world.add(marker);
    }
    for (const button of panel.querySelectorAll("button[data-part]"))
      button.classList.toggle("selected", button.getAttribute("data-part") === name);
    panel.querySelector("button.selected")?.scrollIntoView({ block: "nearest" });
    history.replaceState(null, "", `#${new URLSearchParams({ part: name })}`);
    draw();
  };

  const notes = [...page.scenes.flatMap((one) => one.notes), ...meshes.missing()];
  fill(panel, page, robots, notes, {
    layer: (layer: Layer, visible: boolean) => {
      for (const robot of robots) robot.show(layer, visible);
      draw();
    },
    moved: (robot: Robot) => {
      robot.move();
      for (const other of robots)
        if (other !== robot && other.model.name === robot.model.name) {
          for (const [name, value] of robot.positions) other.positions.set(name, [...value]);
          other.move();
        }
      draw();
    },
    select,
  });

  let pressed = new Vector2();
  canvas.addEventListener("pointerdown", (event) => (pressed = new Vector2(event.clientX, event.clientY)));
  canvas.addEventListener("pointerup", (event) => {
    if (pressed.distanceTo(new Vector2(event.clientX, event.clientY)) > 4) return;
    const box = canvas.getBoundingClientRect();
    const at = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    const ray = new Raycaster();
    ray.setFromCamera(at, camera);
    for (let hit: Object3D | null = ray.intersectObject(stage, true).find((one) => one.object.visible)?.object ?? null; hit; hit = hit.parent)
      if (typeof hit.userData.link === "string") {
        select(hit.userData.link);
        return;
      }
  });

  resize();
  const chosen = new URLSearchParams(location.hash.slice(1)).get("part");
  if (chosen) select(chosen);
  document.documentElement.dataset.ready = String(robots.length);
}

const data = document.getElementById("data")?.textContent;
if (data) start(JSON.parse(data) as Page);
