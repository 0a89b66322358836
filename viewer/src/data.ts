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
  effort: number | null;
  velocity: number | null;
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
  material: string | null;
  mesh: number | null;
}

export interface Inertia {
  /** ixx, iyy, izz, ixy, ixz, iyz about the center of mass, along the axes of the link (kg·m²). */
  moments: number[];
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
    | { kind: "scan"; from: number; to: number; down: number; up: number; near: number; far: number }
    | null;
}

export interface Light {
  name: string;
  type: string;
  pose: Transform;
  direction: [number, number, number];
  color: [number, number, number];
  angle: number;
}

export interface Link {
  name: string;
  pose: Transform;
  place: string;
  shapes: Shape[];
  mass: number | null;
  inertia: Inertia | null;
  sensors: Sensor[];
  lights: Light[];
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
  lights: Light[];
  notes: string[];
}

export interface Mesh {
  name: string;
  missing?: string;
  format?: "stl" | "obj" | "dae" | "gltf";
  data?: string;
  /** Material libraries and pictures that it names, by the last part of their names, as addresses with data in them. */
  files?: Record<string, string>;
  notes?: string[];
  /** Of a robot that follows its text: what to ask the server for. */
  key?: string;
}

/** A link, joint or model that something is about; null in `part` is the model. */
export interface Place {
  model: string | null;
  part: string | null;
}

export interface Finding extends Place {
  severity: "error" | "warning" | "info";
  code: string;
  name: string;
  message: string;
  place: string;
  url: string | null;
  /** The layer that shows what it is about. */
  layer: string | null;
  moment?: Moment;
}

/** A robot while something happens: where its joints are, those that are not named at zero; points of its model. */
export interface Moment {
  positions: Record<string, number>;
  points: [number, number, number][];
}

export interface Difference extends Place {
  text: string;
}

/** An argument of xacro; `choices` are the values that make sense, where they are known. */
export interface Argument {
  name: string;
  value: string;
  choices: string[];
}

export interface Page {
  scenes: Scene[];
  meshes: Mesh[];
  findings: Finding[];
  /** What the findings are: "Findings", or the losses of a conversion. */
  heading: string;
  differences: Difference[];
  mostShapes: number;
  /** Where the robot follows its text: how the page and the server talk. */
  live?: "http" | "editor";
  arguments?: Argument[];
}
