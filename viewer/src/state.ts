// What a person has set, also as the fragment of the address, so that it can be passed on.

import type { Place } from "./data";
import { LAYERS, type Layer } from "./robot";

/** How two robots are shown. */
export const MODES = ["side by side", "over each other", "only the first", "only the second"] as const;
export type Mode = (typeof MODES)[number];

export interface State {
  layers: Set<Layer>;
  mode: Mode;
  /** Model → the positions of its joints. */
  positions: Map<string, Map<string, number[]>>;
  places: Place[];
  /** Links, each as {@link key}: those that are not drawn, and those that let others be seen. */
  hidden: Set<string>;
  faint: Set<string>;
  /** Where the camera is, what it looks at, and how near; null: it shows all. */
  camera: number[] | null;
  isFlat: boolean;
}

/** A link as one word; names of outermost models have no `::` in them. */
export function key(model: string, link: string): string {
  return `${model}::${link}`;
}

function parted(word: string): [string, string] {
  const at = word.indexOf("::");
  return at < 0 ? ["", word] : [word.slice(0, at), word.slice(at + 2)];
}

/** The state as a fragment without `#`; `layers` are those that are shown at first, `links` the keys of all. */
export function fragmentOf(state: State, layers: Set<Layer>, links: string[]): string {
  const all = new URLSearchParams();
  const [place] = state.places;
  if (place?.model) all.set("model", place.model);
  if (place?.part) all.set("part", place.part);
  const shown = LAYERS.filter((layer) => state.layers.has(layer)).join();
  if (shown !== LAYERS.filter((layer) => layers.has(layer)).join()) all.set("show", shown);
  if (state.mode !== MODES[0]) all.set("mode", state.mode);
  for (const [model, joints] of state.positions)
    for (const [joint, values] of joints)
      if (values.some(Boolean)) all.append("at", `${key(model, joint)}=${values.map(short).join()}`);
  const { hidden } = state;
  if (hidden.size > links.length / 2) for (const link of links) if (!hidden.has(link)) all.append("only", link);
  if (hidden.size <= links.length / 2) for (const link of hidden) all.append("hide", link);
  for (const link of state.faint) all.append("faint", link);
  if (state.camera) all.set("camera", state.camera.map(short).join());
  if (state.isFlat) all.set("flat", "1");
  return all.toString();
}

function short(number: number): number {
  return Number(number.toPrecision(5));
}

function numbers(text: string): number[] {
  return text.split(",").map(Number).filter(Number.isFinite);
}

/** What a fragment says; `layers` are shown where it names none. */
export function stateOf(fragment: string, layers: Set<Layer>, links: string[]): State {
  const given = new URLSearchParams(fragment.replace(/^#/, ""));
  const positions: State["positions"] = new Map();
  for (const text of given.getAll("at")) {
    const at = text.lastIndexOf("=");
    const [model, joint] = parted(text.slice(0, at));
    const known = positions.get(model) ?? new Map<string, number[]>();
    known.set(joint, numbers(text.slice(at + 1)));
    positions.set(model, known);
  }
  const shown = given.get("show");
  const camera = numbers(given.get("camera") ?? "");
  const only = new Set(given.getAll("only"));
  const place = { model: given.get("model"), part: given.get("part") };
  return {
    layers: shown === null ? new Set(layers) : new Set(LAYERS.filter((layer) => shown.split(",").includes(layer))),
    mode: MODES.find((mode) => mode === given.get("mode")) ?? MODES[0],
    positions,
    places: place.model === null && place.part === null ? [] : [place],
    hidden: new Set(only.size ? links.filter((link) => !only.has(link)) : given.getAll("hide")),
    faint: new Set(given.getAll("faint")),
    camera: camera.length === 7 ? camera : null,
    isFlat: given.has("flat"),
  };
}
