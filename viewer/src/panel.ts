// What is beside the picture: switches, sliders, the tree of links, findings, differences.

import type { Finding, Joint, Page } from "./data";
import { moves } from "./kinematics";
import { LAYERS, type Layer, type Robot } from "./robot";

type Tag = keyof HTMLElementTagNameMap;

/** An element with text: names of the description never become markup. */
function made<K extends Tag>(tag: K, text = "", attributes: Record<string, string> = {}): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  element.textContent = text;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

function section(title: string, open = true): HTMLElement {
  const details = made("details");
  details.open = open;
  details.append(made("summary", title));
  return details;
}

export interface Actions {
  layer(layer: Layer, visible: boolean): void;
  moved(robot: Robot): void;
  select(name: string): void;
}

const SHOWN: readonly Layer[] = ["visuals", "axes"];

export function fill(panel: HTMLElement, page: Page, robots: Robot[], notes: string[], actions: Actions): void {
  panel.append(switches(actions));
  if (notes.length) {
    const list = section("Notes");
    list.append(...notes.map((note) => made("p", note, { class: "note" })));
    panel.append(list);
  }
  if (page.findings.length) panel.append(findings(page.findings, actions));
  if (page.differences.length) {
    const list = section(`Differences (${page.differences.length})`);
    for (const { text, part } of page.differences) list.append(entry(text, part, actions));
    panel.append(list);
  }
  for (const robot of robots) {
    const joints = robot.model.joints.filter(moves);
    if (joints.length) {
      const list = section(`Joints of ${robot.model.name} (${joints.length})`);
      list.append(...joints.flatMap((joint) => sliders(joint, robot, actions)));
      const reset = made("button", "All to zero", { type: "button" });
      reset.addEventListener("click", () => {
        robot.positions.clear();
        for (const input of list.querySelectorAll("input")) {
          input.value = "0";
          input.dispatchEvent(new Event("input"));
        }
        actions.moved(robot);
      });
      list.append(reset);
      panel.append(list);
    }
    panel.append(tree(robot, actions));
  }
}

function switches(actions: Actions): HTMLElement {
  const set = made("fieldset");
  set.append(made("legend", "Show"));
  for (const layer of LAYERS) {
    const label = made("label");
    const box = made("input", "", { type: "checkbox", id: `show-${layer}` });
    box.checked = SHOWN.includes(layer);
    box.addEventListener("change", () => actions.layer(layer, box.checked));
    actions.layer(layer, box.checked);
    label.append(box, ` ${layer}`);
    set.append(label);
  }
  return set;
}

function sliders(joint: Joint, robot: Robot, actions: Actions): HTMLElement[] {
  return joint.axes.slice(0, joint.kind === "universal" || joint.kind === "revolute2" ? 2 : 1).map((axis, index) => {
    const row = made("label", `${joint.name}${index ? " (2)" : ""} `, { class: "slider" });
    if (axis.mimic) {
      row.append(made("em", `follows ${axis.mimic.leader}`));
      return row;
    }
    const [low, high] = [axis.lower ?? -Math.PI, axis.upper ?? Math.PI];
    const input = made("input", "", {
      type: "range", min: String(Math.min(low, high)), max: String(Math.max(low, high)), step: "any", value: "0",
    });
    const shown = made("output", "0.00");
    input.addEventListener("input", () => {
      const positions = robot.positions.get(joint.name) ?? [0, 0];
      positions[index] = Number(input.value);
      robot.positions.set(joint.name, positions);
      shown.textContent = `${Number(input.value).toFixed(2)} ${joint.kind === "prismatic" ? "m" : "rad"}`;
      actions.moved(robot);
    });
    row.append(input, shown);
    return row;
  });
}

function tree(robot: Robot, actions: Actions): HTMLElement {
  const { model } = robot;
  const details = section(`Links of ${model.name} (${model.links.length})`, model.links.length <= 60);
  const below = new Map<string, string[]>();
  const carried = new Set<string>();
  for (const joint of model.joints)
    if (!carried.has(joint.child) && joint.child !== joint.parent) {
      carried.add(joint.child);
      below.set(joint.parent, [...(below.get(joint.parent) ?? []), joint.child]);
    }
  const drawn = new Set<string>();
  const list = (names: string[]): HTMLElement => {
    const items = made("ul");
    for (const name of names) {
      if (drawn.has(name)) continue;
      drawn.add(name);
      const item = made("li");
      const link = model.links.find((one) => one.name === name);
      item.append(entry(link && !link.shapes.length ? `${name} (no shape)` : name, name, actions));
      const children = below.get(name);
      if (children) item.append(list(children));
      items.append(item);
    }
    return items;
  };
  const roots = model.links.map((link) => link.name).filter((name) => !carried.has(name));
  details.append(list([...roots, ...(below.get("world") ?? [])]));
  return details;
}

function findings(all: Finding[], actions: Actions): HTMLElement {
  const list = section(`Findings (${all.length})`);
  for (const finding of all) {
    const row = entry(`${finding.severity} ${finding.code}: ${finding.message} (${finding.place})`, finding.part, actions);
    row.classList.add(finding.severity);
    list.append(row);
  }
  return list;
}

/** A line that selects the part it is about, if it is about one. */
function entry(text: string, part: string | null, actions: Actions): HTMLElement {
  if (part === null) return made("p", text);
  const button = made("button", text, { type: "button", class: "entry", "data-part": part });
  button.addEventListener("click", () => actions.select(part));
  return button;
}
