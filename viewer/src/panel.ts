// What is beside the picture: switches, sliders, the tree of links, findings, differences.

import type { Argument, Difference, Finding, Joint, Model, Page, Place } from "./data";
import { moves } from "./kinematics";
import { LAYERS, type Layer } from "./robot";

/** An element with text: names of the description never become markup. */
function made<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  text = "",
  attributes: Record<string, string> = {},
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  element.textContent = text;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

function section(title: string, open = true): HTMLDetailsElement {
  const details = made("details");
  details.open = open;
  details.append(made("summary", title));
  return details;
}

/** How two robots are shown. */
export const MODES = ["side by side", "over each other", "only the first", "only the second"] as const;
export type Mode = (typeof MODES)[number];

/** A model with its sliders; those of a compared pair move both. */
export interface Moved {
  model: Model;
  joints: Joint[];
  positions: Map<string, number[]>;
  changed(): void;
  /** Goes to where two robots differ most; returns what to say about it. */
  differMost: (() => string) | null;
}

export interface Actions {
  layer(layer: Layer, visible: boolean): void;
  view(name: string): void;
  arrangeAs(mode: Mode): void;
  /** `finding`: the number of the finding that was chosen. */
  select(place: Place, layer?: string | null, finding?: number): void;
  choose(values: Record<string, string>): void;
}

/** What a person has opened and where the list was, so that a new one looks the same. */
export interface Unfolded {
  sections: Map<string, boolean>;
  top: number;
  focus: string;
}

const FEW = 60; // links of a model that are listed at once
const MANY = 20; // models, from which each is folded

export class Panel {
  private readonly boxes = new Map<Layer, HTMLInputElement>();

  constructor(
    private readonly panel: HTMLElement,
    private readonly page: Page,
    private readonly actions: Actions,
  ) {}

  fill(moved: Moved[], notes: string[], shown: Set<Layer>, views: string[]): void {
    const { page } = this;
    this.panel.replaceChildren(this.switches(shown), this.views(views));
    if (page.arguments?.length) this.panel.append(this.choices(page.arguments));
    if (page.scenes.length > 1) this.panel.append(this.modes());
    if (notes.length) {
      const list = section("Notes");
      list.append(...notes.map((note) => made("p", note, { class: "note" })));
      this.panel.append(list);
    }
    if (page.findings.length) this.panel.append(this.findings(page.findings));
    if (page.scenes.length > 1) this.panel.append(this.differences(page.differences));
    for (const one of moved) if (one.joints.length || one.differMost) this.panel.append(this.joints(one));
    const few = page.scenes.reduce((sum, scene) => sum + scene.models.length, 0) < MANY;
    page.scenes.forEach(({ file, models }, index) => {
      for (const model of models)
        this.panel.append(this.tree(model, few, index ? `${model.name} in ${file}` : model.name));
    });
  }

  unfolded(): Unfolded {
    const sections = new Map<string, boolean>();
    for (const details of this.panel.querySelectorAll("details")) sections.set(titleOf(details), details.open);
    return { sections, top: this.panel.scrollTop, focus: document.activeElement?.id ?? "" };
  }

  unfold({ sections, top, focus }: Unfolded): void {
    for (const details of this.panel.querySelectorAll("details"))
      details.open = sections.get(titleOf(details)) ?? details.open;
    this.panel.scrollTop = top;
    if (focus) document.getElementById(focus)?.focus({ preventScroll: true });
  }

  /** Switches a layer on, if it is one. */
  turnOn(layer: string): void {
    const box = this.boxes.get(layer as Layer);
    if (box && !box.checked) box.click();
  }

  /** Shows which lines are about the selected parts. */
  highlight(places: Place[], reveal = true): void {
    const chosen = new Set(places.map((place) => JSON.stringify([place.model ?? "", place.part ?? ""])));
    for (const button of this.panel.querySelectorAll<HTMLElement>(".entry"))
      button.setAttribute(
        "aria-pressed",
        String(chosen.has(JSON.stringify([button.dataset.model, button.dataset.part]))),
      );
    if (!reveal) return;
    const first = this.panel.querySelector<HTMLElement>(".entry[aria-pressed=true]");
    for (let at = first?.parentElement; at && at !== this.panel; at = at.parentElement)
      if (at instanceof HTMLDetailsElement) at.open = true;
    first?.scrollIntoView({ block: "nearest" });
  }

  private switches(shown: Set<Layer>): HTMLElement {
    const set = made("fieldset");
    set.append(made("legend", "Show"));
    for (const layer of LAYERS) {
      const row = made("label");
      const box = made("input", "", { type: "checkbox", id: `show-${layer.replace(" ", "-")}` });
      box.checked = shown.has(layer);
      box.addEventListener("change", () => this.actions.layer(layer, box.checked));
      this.boxes.set(layer, box);
      row.append(box, ` ${layer}`);
      set.append(row);
    }
    return set;
  }

  /** The arguments of xacro, with their values. */
  private choices(all: Argument[]): HTMLElement {
    const list = section("Arguments");
    for (const { name, value, choices } of all) {
      const row = made("label", `${name} `, { class: "argument" });
      const input = choices.length ? made("select") : made("input", "", { type: "text", spellcheck: "false" });
      input.id = `argument-${name}`;
      for (const choice of new Set([...choices, ...(choices.length ? [value] : [])]))
        input.append(made("option", choice, { value: choice }));
      input.value = value;
      input.addEventListener("change", () => this.actions.choose({ [name]: input.value }));
      row.append(input);
      list.append(row);
    }
    return list;
  }

  private views(names: string[]): HTMLElement {
    const row = made("div", "", { class: "views", role: "group", "aria-label": "Look from" });
    for (const name of names) {
      const button = made("button", name, { type: "button" });
      button.addEventListener("click", () => this.actions.view(name));
      row.append(button);
    }
    return row;
  }

  private modes(): HTMLElement {
    const set = made("fieldset");
    set.append(made("legend", "Two robots"));
    MODES.forEach((mode, index) => {
      const row = made("label");
      const button = made("input", "", { type: "radio", name: "mode", value: mode });
      button.checked = index === 0;
      button.addEventListener("change", () => this.actions.arrangeAs(mode));
      row.append(button, ` ${mode}`);
      set.append(row);
    });
    return set;
  }

  private joints(one: Moved): HTMLElement {
    const list = section(`Joints of ${one.model.name} (${one.joints.length})`);
    const rows: (() => void)[] = [];
    for (const joint of one.joints) list.append(...this.sliders(joint, one, rows));
    const refresh = (): void => {
      for (const row of rows) row();
      one.changed();
    };
    const reset = made("button", "All to zero", { type: "button" });
    reset.addEventListener("click", () => {
      one.positions.clear();
      refresh();
    });
    if (one.joints.length) list.append(reset);
    const { differMost } = one;
    if (differMost) {
      const button = made("button", "Where they differ most", { type: "button", class: "most" });
      const said = made("p", "", { role: "status" });
      button.addEventListener("click", () => {
        said.textContent = differMost();
        refresh();
      });
      list.append(button, said);
    }
    return list;
  }

  private sliders(joint: Joint, one: Moved, rows: (() => void)[]): HTMLElement[] {
    const count = joint.kind === "universal" || joint.kind === "revolute2" ? 2 : 1;
    return joint.axes.slice(0, count).map((axis, index) => {
      const row = made("label", `${joint.name}${index ? " (2)" : ""} `, { class: "slider" });
      if (axis.mimic) {
        row.append(made("em", `follows ${axis.mimic.leader}`));
        return row;
      }
      const wide = joint.kind === "prismatic" ? 1 : Math.PI;
      const [low, high] = [axis.lower ?? -wide, axis.upper ?? wide].sort((a, b) => a - b);
      const input = made("input", "", { type: "range", min: String(low), max: String(high), step: "any" });
      input.dataset.joint = joint.name;
      input.id = `joint-${one.model.name}-${joint.name}-${index}`;
      const shown = made("output");
      const show = (): void => {
        const position = one.positions.get(joint.name)?.[index] ?? 0;
        input.value = String(position);
        shown.textContent = `${position.toFixed(2)} ${joint.kind === "prismatic" ? "m" : "rad"}`;
      };
      input.addEventListener("input", () => {
        const positions = one.positions.get(joint.name) ?? [0, 0];
        positions[index] = Number(input.value);
        one.positions.set(joint.name, positions);
        show();
        one.changed();
      });
      show();
      rows.push(show);
      row.append(input, shown);
      return row;
    });
  }

  private tree(model: Model, open: boolean, name: string): HTMLElement {
    const details = section(`Links of ${name} (${model.links.length})`, open && model.links.length <= FEW);
    const fill = (): void => {
      if (details.childElementCount === 1) details.append(this.links(model));
    };
    if (details.open || model.links.length <= FEW) fill();
    else details.addEventListener("toggle", fill);
    return details;
  }

  /** The links as they hang on one another, without recursion: chains may be long. */
  private links(model: Model): HTMLElement {
    const below = new Map<string, string[]>();
    const carried = new Set<string>();
    for (const joint of model.joints) {
      if (carried.has(joint.child) || joint.child === joint.parent) continue;
      carried.add(joint.child);
      const known = below.get(joint.parent);
      if (known) known.push(joint.child);
      else below.set(joint.parent, [joint.child]);
    }
    const byName = new Map(model.links.map((link) => [link.name, link]));
    const roots = model.links.map((link) => link.name).filter((name) => !carried.has(name));
    const list = made("ul");
    const listed = new Set<string>();
    const waiting = [...roots, ...(below.get("world") ?? [])].map((name): [string, number] => [name, 0]).reverse();
    for (let next = waiting.pop(); next; next = waiting.pop()) {
      const [name, depth] = next;
      const link = byName.get(name);
      if (listed.has(name) || !link) continue;
      listed.add(name);
      const item = made("li", "", { "data-depth": String(Math.min(depth, 12)) });
      item.append(this.entry(link.shapes.length ? name : `${name} (no shape)`, { model: model.name, part: name }));
      list.append(item);
      for (const child of [...(below.get(name) ?? [])].reverse()) waiting.push([child, depth + 1]);
    }
    return list;
  }

  private findings(all: Finding[]): HTMLElement {
    const list = section(`${this.page.heading} (${all.length})`);
    for (const [number, finding] of all.entries()) {
      const row = this.entry(
        `${finding.severity} ${finding.code}: ${finding.message} (${finding.place})`,
        finding,
        finding.layer,
        this.page.live ? number : undefined,
      );
      row.classList.add(finding.severity);
      list.append(row);
    }
    return list;
  }

  private differences(all: Difference[]): HTMLElement {
    const list = section(`Differences (${all.length})`);
    for (const one of all) list.append(this.entry(one.text, one));
    if (!all.length) list.append(made("p", "none"));
    return list;
  }

  /** A line that selects the part it is about, if it is about one. */
  private entry(text: string, place: Place, layer: string | null = null, finding?: number): HTMLElement {
    if (place.part === null && place.model === null && finding === undefined) return made("p", text);
    const button = made("button", text, { type: "button", class: "entry", "aria-pressed": "false" });
    button.dataset.part = place.part ?? "";
    button.dataset.model = place.model ?? "";
    button.addEventListener("click", () =>
      this.actions.select({ model: place.model, part: place.part }, layer, finding),
    );
    return button;
  }
}

/** The title of a section, without numbers that change. */
function titleOf(details: HTMLDetailsElement): string {
  return (details.querySelector("summary")?.textContent ?? "").replace(/ \(\d+\)$/, "");
}

/** The joints of a compared pair that have sliders: those of the first, and what only the second has. */
export function movable(first: Model, second: Model | undefined): Joint[] {
  const own = first.joints.filter(moves);
  const names = new Set(own.map((joint) => joint.name));
  return [...own, ...(second?.joints ?? []).filter((joint) => moves(joint) && !names.has(joint.name))];
}
