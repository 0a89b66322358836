// What sdfcheck/view/scene.py writes into the page.

/** A 4×4 transform as 16 numbers, column by column. */
export type Transform = number[];

export interface Mimic {
  leader: string;
  multiplier: number;
  offset: number;
  reference: number;
}

export interface Axis {
  direction: [number, number, number];
  lower: number | null;
  upper: number | null;
  mimic: Mimic | null;
}

export interface Joint {
  name: string;
  kind: string;
  parent: string;
  child: string;
  pose: Transform;
  pitch: number;
  axes: Axis[];
  place: string;
}

export interface Shape {
  role: "visual" | "collision";
  kind: string;
  name: string;
  size: number[];
  pose: Transform;
  color: [number, number, number, number] | null;
  mesh: number | null;
}

export interface Inertia {
  mass: number;
  pose: Transform;
  box: [number, number, number];
  isPossible: boolean;
}

export interface Sensor {
  name: string;
  type: string;
  pose: Transform;
  view:
    | { kind: "camera"; horizontal: number; aspect: number; near: number; far: number }
    | { kind: "scan"; from: number; to: number; near: number; far: number }
    | null;
}

export interface Link {
  name: string;
  pose: Transform;
  place: string;
  shapes: Shape[];
  inertia: Inertia | null;
  sensors: Sensor[];
  frames: { name: string; pose: Transform }[];
}

export interface Model {
  name: string;
  pose: Transform;
  links: Link[];
  joints: Joint[];
}

export interface Scene {
  file: string;
  models: Model[];
  notes: string[];
}

export interface Mesh {
  name: string;
  missing?: string;
  format?: "stl" | "obj" | "dae" | "gltf";
  data?: string;
}

export interface Finding {
  severity: "error" | "warning" | "info";
  code: string;
  name: string;
  message: string;
  place: string;
  url: string | null;
  part: string | null;
}

export interface Page {
  scenes: Scene[];
  meshes: Mesh[];
  findings: Finding[];
  differences: { text: string; part: string | null }[];
  mostShapes: number;
}
