// Meshes as three.js loads them, each file once.

import { BoxGeometry, Group, LoadingManager, Mesh, MeshLambertMaterial, type Object3D } from "three";
import { ColladaLoader } from "three/addons/loaders/ColladaLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import type { Mesh as File } from "./data";
import { label } from "./labels";
import { COLORS } from "./shapes";

const WHITE = "data:image/gif;base64,R0lGODdhAQABAIAAAP///////ywAAAAAAQABAAACAkQBADs=";

function bytes(data: string): ArrayBuffer {
  const text = atob(data);
  const result = new Uint8Array(text.length);
  for (let index = 0; index < text.length; index++) result[index] = text.charCodeAt(index);
  return result.buffer;
}

/** The page loads nothing from elsewhere: textures beside a mesh are white. */
function manager(): LoadingManager {
  const made = new LoadingManager();
  made.setURLModifier((url) => (/^(data|blob):/.test(url) ? url : WHITE));
  return made;
}

/** A box of 0.1 m in the place of a mesh that is not shown, with the file's name. */
function placeholder(name: string): Object3D {
  const material = new MeshLambertMaterial({ color: COLORS.missing, transparent: true, opacity: 0.5 });
  return new Group().add(new Mesh(new BoxGeometry(0.1, 0.1, 0.1), material), label(name, "#862e9c"));
}

function ofStl(buffer: ArrayBuffer): Object3D {
  const isText = new TextDecoder("latin1").decode(buffer.slice(0, 512)).trimStart().startsWith("solid");
  const faces = buffer.byteLength >= 84 ? new DataView(buffer).getUint32(80, true) : 0;
  const fits = 84 + faces * 50 <= buffer.byteLength;
  if (!isText && (faces === 0 || !fits)) throw new Error("not an STL file");
  return new Mesh(new STLLoader().parse(buffer), new MeshLambertMaterial({ color: COLORS.visual }));
}

function ofCollada(text: string): Object3D {
  const xml = new DOMParser().parseFromString(text, "application/xml");
  if (xml.getElementsByTagName("parsererror").length) throw new Error("not well-formed");
  // RViz and Gazebo take the axes as they are, whichever is up.
  const asItIs = text.replace(/<up_axis>\s*\w+\s*<\/up_axis>/, "");
  const made = new ColladaLoader(manager()).parse(asItIs, "");
  if (!made) throw new Error("no scene");
  return made.scene;
}

async function ofGltf(buffer: ArrayBuffer): Promise<Object3D> {
  const made = await new GLTFLoader(manager()).parseAsync(buffer, "");
  return new Group().add(made.scene.rotateX(Math.PI / 2)); // glTF has y up
}

async function read(file: File): Promise<Object3D> {
  const buffer = bytes(file.data ?? "");
  if (file.format === "stl") return ofStl(buffer);
  if (file.format === "gltf") return ofGltf(buffer);
  const text = new TextDecoder().decode(buffer);
  return file.format === "dae" ? ofCollada(text) : new OBJLoader(manager()).parse(text);
}

/** Throws unless there is something to draw, at places that are numbers. */
function check(mesh: Object3D): Object3D {
  let points = 0;
  mesh.traverse((part) => {
    const positions = (part as Mesh).geometry?.getAttribute("position");
    if (!positions) return;
    points += positions.count;
    for (let index = 0; index < positions.count; index++)
      if (!Number.isFinite(positions.getX(index) + positions.getY(index) + positions.getZ(index)))
        throw new Error("a vertex is not a number");
  });
  if (!points) throw new Error("no triangles");
  return mesh;
}

/** What shapes refer to by number. */
export class Meshes {
  private readonly loaded: (Object3D | null)[] = [];
  private readonly broken: string[] = [];

  /** `known`: meshes that were read before, by their keys; null for those that cannot be. */
  constructor(
    private readonly files: File[],
    private readonly known = new Map<string, Object3D | null>(),
  ) {}

  /** Reads all files; what cannot be read becomes a box with its name, and a note. */
  async load(): Promise<void> {
    for (const file of this.files) {
      const { key = "" } = file;
      let mesh = this.known.get(key) ?? null;
      if (this.known.has(key) || (key && !file.data)) {
        if (this.known.has(key) && !mesh) this.broken.push(`${file.name}: cannot be read`);
        this.loaded.push(mesh);
        continue;
      }
      try {
        if (!file.missing) mesh = check(await read(file));
      } catch (error) {
        this.broken.push(`${file.name}: cannot be read (${error instanceof Error ? error.message : error})`);
      }
      this.loaded.push(mesh);
      if (key) this.known.set(key, mesh);
      await new Promise((resolve) => setTimeout(resolve)); // the browser stays awake
    }
  }

  /** Whether there is a mesh to draw. */
  has(number: number): boolean {
    return Boolean(this.loaded[number]);
  }

  /** A copy at a scale; the box in the place of what is not shown has no scale. */
  copy(number: number, scale: number[]): Object3D {
    const mesh = this.loaded[number];
    if (!mesh) return placeholder(this.files[number].name);
    const [x = 1, y = 1, z = 1] = scale;
    const holder = new Group().add(mesh.clone());
    holder.scale.set(x, y, z);
    return holder;
  }

  /** A sentence for each file that is not shown. */
  notes(): string[] {
    return [...this.files.flatMap((file) => (file.missing ? [`${file.name}: ${file.missing}`] : [])), ...this.broken];
  }
}
