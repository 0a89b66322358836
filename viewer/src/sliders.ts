// The sliders of a model's joints, with their limits and a number that can be typed.

import type { Joint, Model } from "./data";
import { digits, isAngle } from "./inspect";
import { moves } from "./kinematics";
import { made } from "./made";

/** A model with its sliders; those of a compared pair move both. */
export interface Moved {
  model: Model;
  joints: Joint[];
  positions: Map<string, number[]>;
  changed(): void;
  /** Goes to where two robots differ most; returns what to say about it. */
  differMost: (() => string) | null;
}

const DEGREES = 180 / Math.PI;

export class Sliders {
  private readonly rows: (() => void)[] = [];
  private isFilled = false;
  private inDegrees = false;

  /** `list`: what the sliders are put into, when they are asked for. */
  constructor(
    private readonly one: Moved,
    private readonly list: HTMLElement,
    private readonly select: (joint: string) => void,
  ) {}

  fill(): void {
    if (this.isFilled) return;
    this.isFilled = true;
    const { one, list } = this;
    const bar = made("div", { class: "buttons" });
    const add = (words: string, action: () => void, attributes: Record<string, string> = {}): HTMLElement => {
      const button = made("button", { type: "button", ...attributes }, words);
      button.addEventListener("click", action);
      bar.append(button);
      return button;
    };
    if (one.joints.length) {
      add("All to zero", () => {
        one.positions.clear();
        this.refresh();
        one.changed();
      });
      const unit = add("Degrees", () => {
        this.inDegrees = !this.inDegrees;
        unit.setAttribute("aria-pressed", String(this.inDegrees));
        this.refresh();
      }, { "aria-pressed": "false" });
    }
    const { differMost } = one;
    const said = made("p", { role: "status", class: "said" });
    if (differMost)
      add("Where they differ most", () => {
        said.textContent = differMost();
        this.refresh();
        one.changed();
      }, { class: "most" });
    list.append(bar, said);
    for (const joint of one.joints) list.append(...this.slidersOf(joint));
    this.refresh();
  }

  /** Shows the positions as they are now. */
  refresh(): void {
    for (const row of this.rows) row();
  }

  private slidersOf(joint: Joint): HTMLElement[] {
    const count = joint.kind === "universal" || joint.kind === "revolute2" ? 2 : 1;
    return joint.axes.slice(0, count).map((axis, index) => {
      const words = `${joint.name}${index ? " (2)" : ""}`;
      const name = made("button", { type: "button", class: "joint", title: words }, words);
      name.addEventListener("click", () => this.select(joint.name));
      const row = made("div", { class: "slider" }, name);
      if (axis.mimic) {
        row.append(made("em", {}, `follows ${axis.mimic.leader}`));
        return row;
      }
      return this.sliderOf(joint, index, words, row);
    });
  }

  private sliderOf(joint: Joint, index: number, words: string, row: HTMLElement): HTMLElement {
    const { one } = this;
    const axis = joint.axes[index];
    const wide = isAngle(joint) ? Math.PI : 1;
    const [low, high] = [axis.lower ?? -wide, axis.upper ?? wide].sort((a, b) => a - b);
    const input = made("input", { type: "range", min: String(low), max: String(high), step: "any", "aria-label": words });
    input.dataset.joint = joint.name;
    input.id = `joint-${one.model.name}-${joint.name}-${index}`;
    const number = made("input", { type: "number", step: "any", "aria-label": `${words}, as a number` });
    const unit = made("span", { class: "unit" });
    const ends = made("span", { class: "ends" });
    const reset = made("button", { type: "button", title: "Back to zero", "aria-label": `${words}: back to zero` }, "↺");
    const factor = (): number => (isAngle(joint) && this.inDegrees ? DEGREES : 1);
    const show = (): void => {
      const position = one.positions.get(joint.name)?.[index] ?? 0;
      const end = (bound: number | null, without: string): string => (bound === null ? without : digits(bound * factor()));
      input.value = String(position);
      number.value = String(Number((position * factor()).toFixed(factor() === 1 ? 4 : 2)));
      unit.textContent = isAngle(joint) ? (this.inDegrees ? "°" : "rad") : "m";
      ends.replaceChildren(made("span", {}, end(axis.lower, "−∞")), made("span", {}, end(axis.upper, "∞")));
      reset.disabled = position === 0;
    };
    const set = (position: number): void => {
      const positions = one.positions.get(joint.name) ?? [0, 0];
      positions[index] = position;
      one.positions.set(joint.name, positions);
      show();
      one.changed();
    };
    input.addEventListener("input", () => set(Number(input.value)));
    number.addEventListener("change", () => {
      const wanted = Number(number.value) / factor();
      const [least, most] = [axis.lower ?? -Infinity, axis.upper ?? Infinity].sort((a, b) => a - b);
      set(Number.isFinite(wanted) ? Math.min(Math.max(wanted, least), most) : 0);
    });
    reset.addEventListener("click", () => set(0));
    this.rows.push(show);
    row.append(input, made("span", { class: "number" }, number, unit), reset, ends);
    return row;
  }
}

/** The joints of a compared pair that have sliders: those of the first, and what only the second has. */
export function movable(first: Model, second: Model | undefined): Joint[] {
  const own = first.joints.filter(moves);
  const names = new Set(own.map((joint) => joint.name));
  return [...own, ...(second?.joints ?? []).filter((joint) => moves(joint) && !names.has(joint.name))];
}
