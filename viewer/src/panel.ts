// What is beside the picture: the tree, the selected part, sliders, findings, differences, notes; and the tools above it.

import type { Argument, Difference, Finding, Moment, Page, Place } from "./data";
import type { Fact } from "./inspect";
import { made, prose } from "./made";
import type { Layer, Manner } from "./robot";
import { type Moved, Sliders } from "./sliders";
import { MODES, type Mode } from "./state";
import { foldedAtFirst, Tree, type TreeActions } from "./tree";

/** What can be done to selected links. */
export type Deed = "hide" | "isolate" | "faint" | "zoom" | "show all";

export interface Actions {
  layer(layer: Layer, visible: boolean): void;
  view(name: string): void;
  arrangeAs(mode: Mode): void;
  /** `finding`: the number of the finding that was chosen; `moment`: when it happens. */
  select(place: Place, layer?: string | null, finding?: number, moment?: Moment): void;
  choose(values: Record<string, string>): void;
  do(deed: Deed, place?: Place): void;
  mannerOf(place: Place): Manner;
}

/** What a person has opened and where the list was, so that a new one looks the same. */
export interface Unfolded {
  sections: Map<string, boolean>;
  folded: Set<string>;
  search: string;
  top: number;
  focus: string;
}

const FEW = 12; // findings or joints that are listed at once
const OF_A_KIND = 3; // notes that are listed at once

function section(title: string, open = true, kind = ""): HTMLDetailsElement {
  const details = made("details", kind ? { class: kind } : {}, made("summary", {}, title));
  details.open = open;
  return details;
}

export class Panel {
  private readonly folded: Set<string>;
  private tree: Tree | null = null;
  private readonly sliders: Sliders[] = [];
  private readonly about = made("section", { id: "inspector", "aria-label": "The selected part" });
  private notes = section("Notes");

  constructor(
    private readonly panel: HTMLElement,
    private readonly page: Page,
    private readonly actions: Actions,
  ) {
    this.folded = foldedAtFirst(page);
  }

  fill(moved: Moved[], mode: Mode): void {
    const { page } = this;
    this.tree = new Tree(page, this.treeActions(), this.folded);
    this.panel.replaceChildren();
    if (page.scenes.length > 1) this.panel.append(this.modes(mode));
    this.panel.append(this.tree.element, this.about);
    if (page.arguments?.length) this.panel.append(this.choices(page.arguments));
    if (page.scenes.length > 1) this.panel.append(this.differences(page.differences));
    for (const one of moved) if (one.joints.length || one.differMost) this.panel.append(this.joints(one));
    if (page.findings.length) this.panel.append(this.findings(page.findings));
    this.panel.append(this.notes);
    this.tell([]);
  }

  private treeActions(): TreeActions {
    return {
      select: (place) => this.actions.select(place),
      toggle: (place) => this.actions.do("hide", place),
      mannerOf: (place) => this.actions.mannerOf(place),
    };
  }

  unfolded(): Unfolded {
    const sections = new Map<string, boolean>();
    for (const details of this.panel.querySelectorAll("details")) sections.set(titleOf(details), details.open);
    const focus = document.activeElement?.id ?? "";
    return { sections, folded: this.folded, search: this.tree?.search.value ?? "", top: this.panel.scrollTop, focus };
  }

  unfold({ sections, folded, search, top, focus }: Unfolded): void {
    for (const details of this.panel.querySelectorAll("details"))
      details.open = sections.get(titleOf(details)) ?? details.open;
    this.folded.clear();
    for (const row of folded) this.folded.add(row);
    if (this.tree) this.tree.search.value = search;
    this.tree?.draw();
    this.panel.scrollTop = top;
    if (focus) document.getElementById(focus)?.focus({ preventScroll: true });
  }

  /** Puts the cursor into the search. */
  seek(): void {
    this.tree?.search.select();
  }

  /** Shows which links are hidden. */
  drawTree(): void {
    this.tree?.draw();
  }

  /** Shows the positions of joints as they are now. */
  refresh(): void {
    for (const one of this.sliders) one.refresh();
  }

  /** Lists what could not be shown; where many have one reason, folded. */
  tell(notes: string[]): void {
    const groups = new Map<string, string[]>();
    for (const note of notes) {
      const reason = note.slice(note.indexOf(": ") + 1).trim();
      groups.set(reason, [...(groups.get(reason) ?? []), note]);
    }
    this.notes.hidden = !notes.length;
    this.notes.replaceChildren(made("summary", {}, `Notes (${notes.length})`));
    for (const [reason, all] of groups) {
      const lines = all.map((note) => made("p", { class: "note" }, note));
      if (all.length <= OF_A_KIND) this.notes.append(...lines);
      else {
        const group = section(`${reason} (${all.length})`, false, "group");
        group.append(...lines);
        this.notes.append(group);
      }
    }
  }

  /** Shows which lines are about the selected parts. */
  highlight(places: Place[], reveal = true): void {
    this.tree?.highlight(places, reveal);
    const chosen = new Set(places.map((place) => JSON.stringify([place.model ?? "", place.part ?? ""])));
    for (const button of this.panel.querySelectorAll<HTMLElement>(".entry"))
      button.setAttribute(
        "aria-pressed",
        String(chosen.has(JSON.stringify([button.dataset.model, button.dataset.part]))),
      );
  }

  /** Shows what is known of the selected part; nothing is selected without facts. */
  inspect(name: string, facts: Fact[], isLink: boolean): void {
    this.about.hidden = !facts.length;
    const bar = made("div", { class: "buttons" });
    const add = (words: string, hint: string, action: () => void): void => {
      const button = made("button", { type: "button", title: hint }, words);
      button.addEventListener("click", action);
      bar.append(button);
    };
    if (isLink) {
      add("Hide", "Hide or show it (H)", () => this.actions.do("hide"));
      add("Isolate", "Hide all others, or show them again (I)", () => this.actions.do("isolate"));
      add("Fade", "Make it transparent, or solid again (T)", () => this.actions.do("faint"));
    }
    add("Zoom", "Look at it from near (Z)", () => this.actions.do("zoom"));
    const list = made("dl", {}, ...facts.flatMap(([what, value]) => [made("dt", {}, what), made("dd", {}, value)]));
    add("Copy", "Copy these lines", () => copy(name, facts, list));
    this.about.replaceChildren(made("h2", {}, name), bar, list);
  }

  /** The arguments of xacro, with their values. */
  private choices(all: Argument[]): HTMLElement {
    const list = section("Arguments");
    for (const { name, value, choices } of all) {
      const input = choices.length ? made("select") : made("input", { type: "text", spellcheck: "false" });
      input.id = `argument-${name}`;
      for (const choice of new Set([...choices, ...(choices.length ? [value] : [])]))
        input.append(made("option", { value: choice }, choice));
      input.value = value;
      input.addEventListener("change", () => this.actions.choose({ [name]: input.value }));
      list.append(made("label", { class: "argument" }, `${name} `, input));
    }
    return list;
  }

  private modes(chosen: Mode): HTMLElement {
    const set = made("fieldset", {}, made("legend", {}, "Two robots"));
    for (const mode of MODES) {
      const button = made("input", { type: "radio", name: "mode", value: mode });
      button.checked = mode === chosen;
      button.addEventListener("change", () => this.actions.arrangeAs(mode));
      set.append(made("label", {}, button, ` ${mode}`));
    }
    return set;
  }

  private joints(one: Moved): HTMLElement {
    const list = section(`Joints of ${one.model.name} (${one.joints.length})`, one.joints.length <= FEW || Boolean(one.differMost));
    const sliders = new Sliders(one, list, (joint) => this.actions.select({ model: one.model.name, part: joint }));
    this.sliders.push(sliders);
    if (list.open) sliders.fill();
    list.addEventListener("toggle", () => sliders.fill());
    return list;
  }

  /** The findings by rule, the gravest first. */
  private findings(all: Finding[]): HTMLElement {
    const list = section(`${this.page.heading} (${all.length})`);
    const groups = new Map<string, [number, Finding][]>();
    const gravity = ["error", "warning", "info"];
    const order = [...all.entries()].sort((a, b) => gravity.indexOf(a[1].severity) - gravity.indexOf(b[1].severity));
    for (const one of order) groups.set(one[1].code, [...(groups.get(one[1].code) ?? []), one]);
    for (const [code, found] of groups) {
      const { name, severity, url } = found[0][1];
      const group = section("", all.length <= FEW, `group ${severity}`);
      const title = group.firstChild as HTMLElement;
      title.append(made("span", {}, `${severity} ${code} ${name}`), ` (${found.length})`);
      if (url) group.append(made("a", { href: url, target: "_blank", rel: "noreferrer", class: "rule" }, `About ${code}`));
      for (const [number, finding] of found) {
        const words = [...prose(finding.message), ` (${finding.place})`];
        const { severity: kind, layer, moment } = finding;
        group.append(this.entry(words, finding, kind, layer, this.page.live ? number : undefined, moment));
      }
      list.append(group);
    }
    return list;
  }

  private differences(all: Difference[]): HTMLElement {
    const list = section(`Differences (${all.length})`);
    for (const one of all) list.append(this.entry([one.text], one));
    if (!all.length) list.append(made("p", {}, "none"));
    return list;
  }

  /** A line that selects the part it is about, if it is about one. */
  private entry(
    words: (Node | string)[], place: Place, kind = "", layer: string | null = null, finding?: number, moment?: Moment,
  ): HTMLElement {
    if (place.part === null && place.model === null && finding === undefined) return made("p", { class: kind }, ...words);
    const button = made("button", { type: "button", class: `entry ${kind}`, "aria-pressed": "false" }, ...words);
    button.dataset.part = place.part ?? "";
    button.dataset.model = place.model ?? "";
    button.addEventListener("click", () =>
      this.actions.select({ model: place.model, part: place.part }, layer, finding, moment),
    );
    return button;
  }
}

/** Puts facts into the clipboard; where that is not allowed, they are marked to be copied. */
function copy(name: string, facts: Fact[], list: HTMLElement): void {
  const text = [name, ...facts.map((fact) => fact.join("\t"))].join("\n");
  const mark = (): void => getSelection()?.selectAllChildren(list);
  if (navigator.clipboard) navigator.clipboard.writeText(text).catch(mark);
  else mark();
}

/** The title of a section, without numbers that change. */
function titleOf(details: HTMLDetailsElement): string {
  return (details.querySelector("summary")?.textContent ?? "").replace(/ \(\d+\)$/, "");
}

const HELP: Fact[] = [
  ["drag, wheel", "turn, zoom; with the right button: shift"],
  ["click", "select; Esc: nothing"],
  ["Shift and drag", "move the joint of a link"],
  ["H, I, T", "hide, isolate, fade the selected link"],
  ["A", "show all links again"],
  ["Z, F", "look at the selected part, at all"],
  ["P", "with or without perspective"],
  ["M", "measure between two points"],
  ["J", "drags move joints"],
  ["/", "search links and joints"],
];

/** The tools above the picture. */
export class Tools {
  readonly measured = made("span", { role: "status", id: "measured" });
  private readonly boxes = new Map<Layer, HTMLInputElement>();
  private readonly switches = new Map<string, HTMLButtonElement>();

  constructor(
    bar: HTMLElement,
    layers: readonly Layer[],
    views: string[],
    toggles: Record<string, [hint: string, action: () => void]>,
    actions: Actions,
  ) {
    const shown = made("div", { role: "group", "aria-label": "Show", class: "layers" });
    for (const layer of layers) {
      const box = made("input", { type: "checkbox", id: `show-${layer.replace(" ", "-")}` });
      box.addEventListener("change", () => actions.layer(layer, box.checked));
      this.boxes.set(layer, box);
      shown.append(made("label", {}, box, ` ${layer}`));
    }
    const looks = made("div", { role: "group", "aria-label": "Look from", class: "views" });
    for (const name of views) looks.append(this.button(name, "", () => actions.view(name)));
    const modes = made("div", { role: "group", "aria-label": "Tools", class: "modes" });
    for (const [name, [hint, action]] of Object.entries(toggles)) {
      const button = this.button(name, hint, action);
      this.switches.set(name, button);
      modes.append(button);
    }
    const help = section("Help", false, "help");
    help.append(made("dl", {}, ...HELP.flatMap(([keys, what]) => [made("dt", {}, keys), made("dd", {}, what)])));
    bar.replaceChildren(shown, looks, modes, help, this.measured);
  }

  private button(name: string, hint: string, action: () => void): HTMLButtonElement {
    const button = made("button", { type: "button", ...(hint ? { title: hint } : {}) }, name);
    button.addEventListener("click", action);
    return button;
  }

  setLayers(layers: Set<Layer>): void {
    for (const [layer, box] of this.boxes) box.checked = layers.has(layer);
  }

  /** Shows whether a tool is on; those that are not there now are left out. */
  setSwitch(name: string, isOn: boolean | null): void {
    const button = this.switches.get(name);
    if (!button) return;
    button.hidden = isOn === null;
    if (isOn !== null && name !== "Show all") button.setAttribute("aria-pressed", String(isOn));
  }
}
