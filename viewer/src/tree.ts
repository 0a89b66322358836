// The links and joints of all models as a tree that can be searched.

import type { Model, Page, Place } from "./data";
import { counted, made } from "./made";
import type { Manner } from "./robot";

/** A model, a link, or the joint that carries the next link, on the level of that. */
interface Row {
  kind: "model" | "link" | "joint";
  level: number;
  place: Place;
  name: string;
  note: string;
  above: number;
  hasMore: boolean;
}

export interface TreeActions {
  select(place: Place): void;
  toggle(place: Place): void;
  mannerOf(place: Place): Manner;
}

const MANY = 20; // models, from which each is folded

export class Tree {
  readonly element = made("div", { class: "tree" });
  readonly search = made("input", { type: "search", id: "search", placeholder: "Search links and joints ( / )", "aria-label": "Search links and joints", autocomplete: "off", spellcheck: "false" });
  private readonly list = made("div", { role: "tree", tabindex: "0", id: "tree", "aria-label": "Links and joints" });
  private readonly rows: Row[];
  /** The rows that are shown, by their number in the tree. */
  private shown = new Map<number, HTMLElement>();
  private chosen = new Set<number>();
  private at = -1;

  constructor(
    page: Page,
    private readonly actions: TreeActions,
    private readonly folded: Set<string>,
  ) {
    this.rows = rowsOf(page);
    this.search.addEventListener("input", () => this.draw());
    this.search.addEventListener("keydown", (event) => this.searched(event));
    this.list.addEventListener("keydown", (event) => this.pressed(event));
    this.list.addEventListener("click", (event) => this.clicked(event));
    this.list.addEventListener("dblclick", () => this.fold(this.at));
    this.element.append(this.search, this.list);
    this.draw();
  }

  /** Shows which rows are selected. */
  highlight(places: Place[], reveal: boolean): void {
    const wanted = new Set(places.map(({ model, part }) => `${model ?? ""}\n${part ?? ""}`));
    const anywhere = new Set(places.flatMap(({ model, part }) => (model === null && part !== null ? [part] : [])));
    this.chosen = new Set();
    this.rows.forEach(({ place: { model, part } }, number) => {
      if (wanted.has(`${model ?? ""}\n${part ?? ""}`) || (part !== null && anywhere.has(part))) this.chosen.add(number);
    });
    const [first] = this.chosen;
    if (first !== undefined && reveal) {
      for (let above = this.rows[first].above; above >= 0; above = this.rows[above].above)
        this.folded.delete(idOf(this.rows[above]));
      this.at = first;
    }
    this.draw();
    if (reveal && first !== undefined) this.shown.get(first)?.scrollIntoView({ block: "nearest" });
  }

  /** Draws the rows that are not folded away, or those that the search finds with what they hang on. */
  draw(): void {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = words.length ? this.found(words) : null;
    const open: boolean[] = [];
    this.shown = new Map();
    this.rows.forEach((row, number) => {
      const isOpen = row.above < 0 || open[row.above];
      open[number] = isOpen && !this.folded.has(idOf(row));
      if (found ? found.has(number) : isOpen) this.shown.set(number, this.rowOf(row, number, Boolean(found)));
    });
    const top = this.list.scrollTop;
    if (this.shown.size) this.list.replaceChildren(...this.shown.values());
    else this.list.replaceChildren(made("div", { role: "treeitem", class: "none" }, words.length ? "Nothing has such a name." : "No links."));
    this.list.scrollTop = top;
    this.mark();
  }

  private found(words: string[]): Set<number> {
    const found = new Set<number>();
    this.rows.forEach(({ name, note }, number) => {
      const text = `${name} ${note}`.toLowerCase();
      if (!words.every((word) => text.includes(word))) return;
      for (let at = number; at >= 0 && !found.has(at); at = this.rows[at].above) found.add(at);
    });
    return new Set([...found].sort((a, b) => a - b));
  }

  private rowOf(row: Row, number: number, isSearch: boolean): HTMLElement {
    const manner = this.actions.mannerOf(row.place);
    const isOpen = isSearch || !this.folded.has(idOf(row));
    const element = made("div", {
      role: "treeitem", id: `row-${number}`, class: `row ${row.kind} ${manner}`, "data-level": String(Math.min(row.level, 16)),
      "aria-level": String(row.level + 1), "aria-selected": String(this.chosen.has(number)),
      "data-model": row.place.model ?? "", "data-part": row.place.part ?? "", title: row.name,
      ...(row.hasMore ? { "aria-expanded": String(isOpen) } : {}),
    });
    element.append(
      made("span", { class: "fold", "aria-hidden": "true" }, row.hasMore ? (isOpen ? "▾" : "▸") : ""),
      made("span", { class: "name" }, row.name || "(no name)"),
      made("span", { class: "kind" }, manner === "hidden" ? "hidden" : row.note),
    );
    if (row.kind !== "joint")
      element.append(made("span", { class: "eye", "aria-hidden": "true", title: "Hide or show" }, manner === "hidden" ? "○" : "●"));
    return element;
  }

  private mark(): void {
    for (const row of this.list.querySelectorAll(".at")) row.classList.remove("at");
    const row = this.shown.get(this.at);
    row?.classList.add("at");
    if (row) this.list.setAttribute("aria-activedescendant", row.id);
    else this.list.removeAttribute("aria-activedescendant");
  }

  private fold(number: number, close = !this.folded.has(idOf(this.rows[number]))): void {
    if (!this.rows[number]?.hasMore) return;
    if (close) this.folded.add(idOf(this.rows[number]));
    else this.folded.delete(idOf(this.rows[number]));
    this.draw();
  }

  private clicked(event: MouseEvent): void {
    const target = event.target as HTMLElement;
    const row = target.closest<HTMLElement>(".row");
    if (!row) return;
    this.at = Number(row.id.slice("row-".length));
    if (target.className === "fold" && target.textContent) this.fold(this.at);
    else if (target.className === "eye") this.actions.toggle(this.rows[this.at].place);
    else this.actions.select(this.rows[this.at].place);
  }

  private searched(event: KeyboardEvent): void {
    if (event.key === "Escape") {
      this.search.value = "";
      this.draw();
      this.list.focus();
    } else if (event.key === "ArrowDown" || event.key === "Enter") {
      event.preventDefault();
      const words = this.search.value.toLowerCase().trim();
      this.at = [...this.shown.keys()].find((number) => this.rows[number].name.toLowerCase().includes(words)) ?? -1;
      this.list.focus();
      this.mark();
      if (event.key === "Enter" && this.at >= 0) this.actions.select(this.rows[this.at].place);
    }
  }

  private pressed(event: KeyboardEvent): void {
    const numbers = [...this.shown.keys()];
    const index = numbers.indexOf(this.at);
    const row = this.rows[this.at] as Row | undefined;
    const isOpen = this.shown.get(this.at)?.getAttribute("aria-expanded") === "true";
    const go = (number: number | undefined): void => {
      if (number === undefined || number < 0) return;
      this.at = number;
      this.mark();
      this.shown.get(number)?.scrollIntoView({ block: "nearest" });
    };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "ArrowDown") go(numbers[Math.min(index + 1, numbers.length - 1)]);
    else if (event.key === "ArrowUp") go(numbers[Math.max(index - 1, 0)]);
    else if (event.key === "Home") go(numbers[0]);
    else if (event.key === "End") go(numbers[numbers.length - 1]);
    else if (event.key === "ArrowRight") {
      if (row?.hasMore && !isOpen) this.fold(this.at, false);
      else if (row?.hasMore) go(numbers[index + 1]);
    } else if (event.key === "ArrowLeft") {
      if (row?.hasMore && isOpen) this.fold(this.at, true);
      else if (row) go(row.above);
    } else if ((event.key === "Enter" || event.key === " ") && row) this.actions.select(row.place);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

function idOf(row: Row): string {
  return `${row.place.model ?? ""}\n${row.place.part ?? ""}`;
}

/** What is folded at first: models, where there are many. */
export function foldedAtFirst(page: Page): Set<string> {
  const models = page.scenes.flatMap((scene) => scene.models);
  return new Set(models.length > MANY ? models.map((model) => `${model.name}\n`) : []);
}

function rowsOf(page: Page): Row[] {
  const rows: Row[] = [];
  const names = new Set<string>();
  const isOne = page.scenes.length === 1 && page.scenes[0].models.length === 1;
  page.scenes.forEach(({ file, models }, index) => {
    for (const model of models) {
      if (isOne) addLinks(rows, model, -1);
      else if (!names.has(model.name)) {
        // The same model in two files: one row for both.
        names.add(model.name);
        const note = index ? `only in ${file}` : counted(model.links.length, "link");
        const place = { model: model.name, part: null };
        const hasMore = model.links.length > 0;
        rows.push({ kind: "model", level: 0, place, name: model.name, note, above: -1, hasMore });
        addLinks(rows, model, rows.length - 1);
      }
    }
  });
  return rows;
}

/** The links as they hang on one another, without recursion: chains may be long. */
function addLinks(rows: Row[], model: Model, root: number): void {
  const below = new Map<string, Model["joints"]>();
  const carried = new Set<string>();
  const byName = new Map(model.links.map((link) => [link.name, link]));
  for (const joint of model.joints) {
    if (carried.has(joint.child) || joint.child === joint.parent) continue;
    carried.add(joint.child);
    below.set(joint.parent, [...(below.get(joint.parent) ?? []), joint]);
  }
  const listed = new Set<string>();
  type Waiting = [link: string, above: number, joint: Model["joints"][number] | null];
  const roots = model.links.filter(({ name }) => !carried.has(name)).map(({ name }): Waiting => [name, root, null]);
  const fixed = (below.get("world") ?? []).map((joint): Waiting => [joint.child, root, joint]);
  const waiting = [...roots, ...fixed].reverse();
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const [name, above, joint] = next;
    const link = byName.get(name);
    if (listed.has(name) || !link) continue;
    listed.add(name);
    const level = above < 0 ? 0 : rows[above].level + 1;
    const row = (kind: Row["kind"], part: string, note: string, hasMore: boolean): Row => ({
      kind, level, place: { model: model.name, part }, name: part, note, above, hasMore,
    });
    if (joint) rows.push(row("joint", joint.name, joint.kind, false));
    const children = below.get(name) ?? [];
    rows.push(row("link", name, link.shapes.length ? "" : "no shape", children.length > 0));
    const number = rows.length - 1;
    for (const child of [...children].reverse()) waiting.push([child.child, number, child]);
  }
}
