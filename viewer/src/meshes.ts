// Meshes as three.js loads them, each file once.

import {
  BoxGeometry,
  type BufferGeometry,
  Group,
  LoadingManager,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
  SRGBColorSpace,
} from "three";
import { ColladaLoader } from "three/addons/loaders/ColladaLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { MTLLoader } from "three/addons/loaders/MTLLoader.js";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import { TGALoader } from "three/addons/loaders/TGALoader.js";
import type { Mesh as File } from "./data";
import { COLORS } from "./shapes";

const WHITE = "data:image/gif;base64,R0lGODdhAQABAIAAAP///////ywAAAAAAQABAAACAkQBADs=";

function bytes(data: string): ArrayBuffer {
  const text = atob(data);
  const result = new Uint8Array(text.length);
  for (let index = 0; index < text.length; index++) result[index] = text.charCodeAt(index);
  return result.buffer;
}

/** The page loads nothing from elsewhere: of what a mesh names, only what is embedded with it; the rest is white. */
function manager(file: File): LoadingManager {
  const made = new LoadingManager();
  made.setURLModifier((url) => {
    if (/^(data|blob):/.test(url)) return url;
    return file.files?.[lastOf(url)] ?? file.files?.[lastOf(decoded(url))] ?? WHITE;
  });
  made.addHandler(/\.tga$/i, new TGALoader(made));
  return made;
}

function lastOf(name: string): string {
  return name.split(/[/\\]/).pop() ?? "";
}

function decoded(url: string): string {
  try {
    return decodeURIComponent(url);
  } catch {
    return url;
  }
}

/** A box of 0.1 m in the place of a mesh that is not shown. */
function placeholder(): Object3D {
  const material = new MeshLambertMaterial({ color: COLORS.missing, transparent: true, opacity: 0.5 });
  return new Group().add(new Mesh(new BoxGeometry(0.1, 0.1, 0.1), material));
}

function ofStl(buffer: ArrayBuffer): Object3D {
  const isText = new TextDecoder("latin1").decode(buffer.slice(0, 512)).trimStart().startsWith("solid");
  const faces = buffer.byteLength >= 84 ? new DataView(buffer).getUint32(80, true) : 0;
  const fits = 84 + faces * 50 <= buffer.byteLength;
  if (!isText && (faces === 0 || !fits)) throw new Error("not an STL file");
  return new Mesh(new STLLoader().parse(buffer), new MeshLambertMaterial({ color: COLORS.visual }));
}

function ofObj(text: string, file: File, own: LoadingManager): Object3D {
  const loader = new OBJLoader(own);
  const [library] = Object.entries(file.files ?? {}).filter(([name]) => name.toLowerCase().endsWith(".mtl"));
  if (library) loader.setMaterials(new MTLLoader(own).parse(new TextDecoder().decode(bytes(library[1].split(",")[1])), ""));
  return loader.parse(text);
}

function ofCollada(text: string, own: LoadingManager): Object3D {
  const xml = new DOMParser().parseFromString(text, "application/xml");
  if (xml.getElementsByTagName("parsererror").length) throw new Error("not well-formed");
  // RViz and Gazebo take the axes as they are, whichever is up.
  const asItIs = text.replace(/<up_axis>\s*\w+\s*<\/up_axis>/, "");
  const made = new ColladaLoader(own).parse(asItIs, "");
  if (!made) throw new Error("no scene");
  return made.scene;
}

async function ofGltf(buffer: ArrayBuffer, own: LoadingManager): Promise<Object3D> {
  const made = await new GLTFLoader(own).parseAsync(buffer, "");
  return new Group().add(made.scene.rotateX(Math.PI / 2)); // glTF has y up
}

async function read(file: File, loaded: () => void): Promise<Object3D> {
  const buffer = bytes(file.data ?? "");
  const own = manager(file);
  own.onLoad = loaded;
  if (file.format === "stl") return ofStl(buffer);
  if (file.format === "gltf") return ofGltf(buffer, own);
  const text = new TextDecoder().decode(buffer);
  return withColorsAlone(file.format === "dae" ? ofCollada(text, own) : ofObj(text, file, own));
}

/** Takes pictures away that are not embedded, as they are not of colors. */
function withColorsAlone(mesh: Object3D): Object3D {
  mesh.traverse((part) => {
    for (const material of materialsOf(part)) {
      const { map } = material;
      for (const name of ["bumpMap", "normalMap", "specularMap", "lightMap", "aoMap", "alphaMap", "displacementMap"])
        if (name in material) Object.assign(material, { [name]: null });
      if (map) map.colorSpace = SRGBColorSpace;
    }
  });
  return mesh;
}

/** The materials of an object, as those that they have in common with others. */
export function materialsOf(part: Object3D): MeshLambertMaterial[] {
  const { material } = part as Mesh<BufferGeometry, MeshLambertMaterial | MeshLambertMaterial[]>;
  return material ? [material].flat() : [];
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

const SLICE = 60; // ms, after which the browser may draw for the first time; later it waits longer

/** What shapes refer to by number. */
export class Meshes {
  private readonly loaded: (Object3D | null | undefined)[];
  private readonly broken: string[] = [];
  /** Called when pictures have arrived. */
  onPicture: () => void = () => {};

  /** `known`: meshes that were read before, by their keys; null for those that cannot be. */
  constructor(
    private readonly files: File[],
    private readonly known = new Map<string, Object3D | null>(),
  ) {
    this.loaded = files.map(() => undefined);
  }

  /**
   * Reads files, those in `first` before others; what cannot be read becomes a box, and a note.
   *
   * `shown` is called with the numbers of those that were read, again and again.
   */
  async load(first = new Set<number>(), shown: (numbers: number[]) => void = () => {}): Promise<void> {
    const numbers = [...this.files.keys()].sort((a, b) => Number(first.has(b)) - Number(first.has(a)));
    let done: number[] = [];
    let begun = performance.now();
    let slice = SLICE;
    for (const number of numbers) {
      this.loaded[number] = await this.read(this.files[number]);
      done.push(number);
      if (performance.now() - begun < slice) continue;
      shown(done);
      slice = 4 * SLICE;
      done = [];
      await new Promise((resolve) => setTimeout(resolve)); // the browser stays awake
      begun = performance.now();
    }
    shown(done);
  }

  private async read(file: File): Promise<Object3D | null> {
    const { key = "" } = file;
    let mesh = this.known.get(key) ?? null;
    if (this.known.has(key) || (key && !file.data)) {
      if (this.known.has(key) && !mesh) this.broken.push(`${file.name}: cannot be read`);
      return mesh;
    }
    try {
      if (!file.missing) mesh = check(await read(file, () => this.onPicture()));
    } catch (error) {
      this.broken.push(`${file.name}: cannot be read (${error instanceof Error ? error.message : error})`);
    }
    if (key) this.known.set(key, mesh);
    return mesh;
  }

  /** Whether it was looked at. */
  isRead(number: number): boolean {
    return this.loaded[number] !== undefined;
  }

  /** Whether there is a mesh to draw. */
  has(number: number): boolean {
    return Boolean(this.loaded[number]);
  }

  /** A copy at a scale; the box in the place of what is not shown has no scale. */
  copy(number: number, scale: number[]): Object3D {
    const mesh = this.loaded[number];
    if (!mesh) return placeholder();
    const [x = 1, y = 1, z = 1] = scale;
    const holder = new Group().add(mesh.clone());
    holder.scale.set(x, y, z);
    return holder;
  }

  /** A sentence for each file that is not shown. */
  notes(): string[] {
    const missing = this.files.flatMap(({ name, missing, notes }) => [
      ...(missing ? [`${name}: ${missing}`] : []),
      ...(notes ?? []).map((note) => `${name}: ${note}`),
    ]);
    return [...missing, ...this.broken];
  }
}
