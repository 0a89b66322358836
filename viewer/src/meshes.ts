// Meshes as three.js loads them, each file once.

import { BoxGeometry, type BufferGeometry, Group, Mesh, MeshLambertMaterial, type Object3D } from "three";
import { ColladaLoader } from "three/addons/loaders/ColladaLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import type { Mesh as File } from "./data";

function bytes(data: string): ArrayBuffer {
  const text = atob(data);
  const result = new Uint8Array(text.length);
  for (let index = 0; index < text.length; index++) result[index] = text.charCodeAt(index);
  return result.buffer;
}

/** A box of 0.1 m in the place of a mesh that is not shown. */
export function placeholder(): Object3D {
  const material = new MeshLambertMaterial({ color: 0xb060c0, transparent: true, opacity: 0.5 });
  return new Mesh(new BoxGeometry(0.1, 0.1, 0.1), material);
}

async function read(file: File): Promise<Object3D> {
  if (!file.data) return placeholder();
  const buffer = bytes(file.data);
  switch (file.format) {
    case "stl": {
      const geometry: BufferGeometry = new STLLoader().parse(buffer);
      return new Mesh(geometry, new MeshLambertMaterial({ color: 0xb8bcc4 }));
    }
    case "obj":
      return new OBJLoader().parse(new TextDecoder().decode(buffer));
    case "dae": {
      const made = new ColladaLoader().parse(new TextDecoder().decode(buffer), "");
      return made?.scene ?? placeholder();
    }
    default: {
      const made = await new GLTFLoader().parseAsync(buffer, "");
      return made.scene;
    }
  }
}

/** Loads what shapes refer to by number; a file that cannot be read is named in `broken`. */
export class Meshes {
  readonly broken: string[] = [];
  private readonly loaded = new Map<number, Promise<Object3D>>();

  constructor(private readonly files: File[]) {}

  async get(number: number): Promise<Object3D> {
    let found = this.loaded.get(number);
    if (!found) {
      found = read(this.files[number]).catch(() => {
        this.broken.push(this.files[number].name);
        return placeholder();
      });
      this.loaded.set(number, found);
    }
    const copy = new Group();
    copy.add((await found).clone());
    return copy;
  }

  missing(): string[] {
    return this.files.filter((file) => file.missing).map((file) => `${file.name}: ${file.missing}`);
  }
}
