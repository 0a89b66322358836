// The page of the HTML report.

import { counted, made } from "../made";
import { KIND_NAMES, KINDS, kindOf, type Report } from "./data";
import { FIXES, fragmentOf, Search, stateOf, VIEWS, type Name, type State, type View } from "./filter";
import { List } from "./list";
import { Robots } from "./robots";
import { files, rules, summary } from "./tables";

const report = JSON.parse(document.getElementById("data")!.textContent!) as Report;
const main = document.getElementById("main")!;
const search = new Search(report);
const list = new List(report);
const robots = new Robots(report);
const sections = new Map<View, HTMLElement>();
const names: Record<View, string> = { summary: "Summary", findings: "Findings", rules: "Rules", files: "Files", robots: "Robots" };
let state = stateOf(location.hash);

const found = made("p", { role: "status", class: "found" });
const chip = made("button", { type: "button", class: "chip" });
const fields = new Map<Name, HTMLInputElement | HTMLSelectElement>();

function start(): void {
  for (const view of VIEWS) {
    if (view === "robots" && !report.robots.length && !report.notDrawn.length) continue;
    const section = made("section", { "data-view": view, "aria-label": names[view] });
    sections.set(view, section);
    main.append(section);
    document.getElementById("views")!.append(made("a", { href: `#view=${view}`, "data-view": view }, names[view]));
  }
  sections.get("findings")!.append(made("h2", { class: "unseen" }, "Findings"), filters(), list.element);
  sections.get("robots")?.append(made("h2", { class: "unseen" }, "Robots"), robots.element);
  document.getElementById("footer")!.append(
    `Made by sdfcheck ${report.version}. Keys: `, made("kbd", {}, "/"), " search, ", made("kbd", {}, "j"), " ",
    made("kbd", {}, "k"), " next and previous finding, ", made("kbd", {}, "Enter"), " open, ", made("kbd", {}, "Esc"),
    " leave the search.");
  addEventListener("hashchange", () => show(stateOf(location.hash)));
  addEventListener("keydown", pressed);
  addEventListener("beforeprint", () => {
    for (const view of VIEWS) if (view !== "robots") write(view);
    list.unfold();
  });
  show(state);
}

/** Tables are written when they are looked at. */
function write(view: View): void {
  const section = sections.get(view)!;
  if (view === "findings") list.show(search.found(state.filter));
  else if (view === "robots") robots.show(state.filter.file);
  else if (!section.childElementCount)
    section.append(...{ summary, rules, files }[view](report));
}

function show(wanted: State): void {
  state = sections.has(wanted.view) ? wanted : { ...wanted, view: "summary" };
  write(state.view);
  for (const [view, section] of sections) section.classList.toggle("current", view === state.view);
  for (const link of document.querySelectorAll<HTMLElement>("#views a"))
    if (link.dataset.view === state.view) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  for (const [name, field] of fields) if (field.value !== (state.filter[name] ?? "")) field.value = state.filter[name] ?? "";
  chip.hidden = !state.filter.file;
  const { file = "" } = state.filter;
  chip.replaceChildren(`in ${file} `, made("span", { "aria-hidden": "true" }, "×"));
  chip.setAttribute("aria-label", `Show all files, not only ${file}`);
  const left = search.found(state.filter).length;
  const all = report.findings.length;
  found.textContent = left === all ? counted(all, "finding") : `${left.toLocaleString("en")} of ${counted(all, "finding")}`;
}

/** A change of the form: the address follows, without a step back for each letter. */
function change(filter: State["filter"]): void {
  state = { view: "findings", filter };
  history.replaceState(null, "", fragmentOf(state));
  show(state);
}

function filters(): HTMLElement {
  const form = made("form", { class: "filters", role: "search" });
  form.addEventListener("submit", (event) => event.preventDefault());
  const input = made("input", { type: "search", placeholder: "Message, rule or file", autocomplete: "off" });
  form.append(labelled("Search", "q", input));
  form.append(labelled("Severity", "severity", options(KINDS
    .filter((kind) => report.findings.some((each) => kindOf(each) === kind)).map((kind) => [kind, KIND_NAMES[kind]]))));
  form.append(labelled("Rule", "rule", options(report.rules.map(({ code, name }): [string, string] =>
    [code, `${code} ${name}`]).sort())));
  const concerned = new Set(report.reactions.flat().filter((each) => each.verdict !== "accept").map((each) => each.consumer));
  form.append(labelled("Consumer", "consumer", options([...concerned].sort().map((name) => [name, name]))));
  form.append(labelled("Fix", "fix", options(Object.entries(FIXES))));
  chip.addEventListener("click", () => change({ ...state.filter, file: undefined }));
  const buttons = made("p", { class: "buttons" });
  for (const [words, action] of [
    ["Open all", () => list.openAll(true)], ["Close all", () => list.openAll(false)], ["Clear filters", () => change({})],
  ] as const) {
    const button = made("button", { type: "button" }, words);
    button.addEventListener("click", action);
    buttons.append(button);
  }
  form.append(made("div", { class: "line" }, found, chip, buttons));
  return form;
}

function labelled(words: string, name: Name, field: HTMLInputElement | HTMLSelectElement): HTMLLabelElement {
  fields.set(name, field);
  field.name = name;
  field.addEventListener("input", () => change({ ...state.filter, [name]: field.value || undefined }));
  return made("label", { class: `field-${name}` }, made("span", {}, words), field);
}

function options(pairs: [string, string][]): HTMLSelectElement {
  return made("select", {}, made("option", { value: "" }, "All"),
    ...pairs.map(([value, words]) => made("option", { value }, words)));
}

function pressed(event: KeyboardEvent): void {
  const input = fields.get("q")!;
  if (event.key === "Escape" && event.target === input) input.blur();
  const isTyping = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
  if (isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "/") {
    event.preventDefault();
    if (state.view !== "findings") location.hash = fragmentOf({ view: "findings", filter: state.filter });
    show({ view: "findings", filter: state.filter });
    input.focus();
  } else if (state.view === "findings" && (event.key === "j" || event.key === "k")) {
    list.step(event.key === "j" ? 1 : -1);
  }
}

start();
