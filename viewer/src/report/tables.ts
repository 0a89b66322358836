// The summary, and the tables of rules and files.

import { counted, made, path, prose } from "../made";
import { KIND_NAMES, KINDS, kindOf, type Finding, type Kind, type Report } from "./data";
import { linkTo, type State } from "./filter";

type Cell = Node | string | number;

export function summary(report: Report): Node[] {
  const tiles = KINDS.map((kind) => [kind, report.findings.filter((each) => kindOf(each) === kind).length] as const);
  const fixable = report.findings.filter((each) => each.fix?.safe).length;
  const parts: Node[] = [
    made("h2", { class: "unseen" }, "Summary"),
    made("ul", { class: "tiles" },
      ...tiles.filter(([kind, number]) => kind !== "missing" || number).map(([kind, number]) =>
        tile(number, KIND_NAMES[kind], kind, { severity: kind })),
      tile(fixable, "Safe fixes", "fix", { fix: "safe" }),
      made("li", {}, made("b", {}, report.files.toLocaleString("en")), " Files"),
    ),
  ];
  if (!report.findings.length) parts.push(made("p", { class: "clear" }, report.closing));
  if (report.sections.length) parts.push(made("h2", {}, "What to do first"));
  for (const { heading, fixable: isFixable, rows } of report.sections)
    parts.push(made("h3", {}, ...prose(heading)), table(["Findings", "Rule", "Files"], rows.map((row) => {
      const rule = report.rules[row.rule]!;
      const filter = { rule: rule.code, severity: row.severity, fix: isFixable ? "safe" : "manual" };
      return [row.count, ruleCell(report, row.rule, filter), row.files];
    })));
  parts.push(...consumers(report));
  if (report.missing.length)
    parts.push(made("h2", {}, "Not found here"), made("pre", { class: "plain", tabindex: "0" }, report.missing.join("\n")));
  if (report.skipped.length)
    parts.push(made("h2", {}, "Skipped"), table(["File", "Reason"], report.skipped.map((each) => [each.file, each.reason])));
  return parts;
}

function tile(number: number, name: string, kind: string, filter: State["filter"]): HTMLLIElement {
  const words = [made("b", {}, number.toLocaleString("en")), ` ${name}`];
  return made("li", { class: kind }, number ? made("a", { href: linkTo(filter) }, ...words) : made("span", {}, ...words));
}

function consumers(report: Report): Node[] {
  const found = new Map<string, { refused: Set<number>; concerned: number }>();
  for (const finding of report.findings)
    for (const { consumer, verdict } of report.reactions[finding.affects ?? 0]!) {
      if (verdict === "accept") continue;
      const entry = found.get(consumer) ?? { refused: new Set(), concerned: 0 };
      entry.concerned += 1;
      if (verdict === "reject") entry.refused.add(finding.file);
      found.set(consumer, entry);
    }
  if (!found.size) return [];
  const rows = [...found].sort().map(([name, { refused, concerned }]): Cell[] =>
    [made("a", { href: linkTo({ consumer: name }) }, name), concerned, refused.size]);
  return [made("h2", {}, "Consumers"), table(["Consumer", "Findings", "Files that it refuses"], rows)];
}

export function rules(report: Report): Node[] {
  const byRule = grouped(report.findings, (each) => each.rule);
  const rows = [...byRule].sort((a, b) => b[1].length - a[1].length).map(([rule, found]): Cell[] => [
    ruleCell(report, rule, { rule: report.rules[rule]!.code }), ...numbers(found),
    new Set(found.map((each) => each.file)).size, found.filter((each) => each.fix?.safe).length || "",
  ]);
  return [made("h2", {}, `${counted(byRule.size, "rule")} with findings`),
    table(["Rule", ...KINDS.map((kind) => KIND_NAMES[kind]), "Files", "Safe fixes"], rows)];
}

export function files(report: Report): Node[] {
  const byFile = grouped(report.findings, (each) => each.file);
  const gravity = (found: Finding[]): number[] => KINDS.map((kind) => found.filter((each) => kindOf(each) === kind).length);
  const rows = [...byFile]
    .map(([file, found]) => ({ file, found, gravity: gravity(found) }))
    .sort((a, b) => KINDS.reduce((order, _, at) => order || b.gravity[at]! - a.gravity[at]!, 0) || a.file - b.file)
    .map(({ file, found }): Cell[] => {
      const link = made("a", { href: linkTo({ file: report.places[file]! }) }, ...path(report.places[file]!));
      return [link, ...numbers(found)];
    });
  const clean = Math.max(report.files - byFile.size, 0);
  return [made("h2", {}, `${counted(byFile.size, "file")} with findings`),
    ...(clean ? [made("p", {}, `${counted(clean, "file")} without findings.`)] : []),
    ...(report.files > report.mostRobots
      ? [made("p", {}, ...prose("`sdfcheck view FILE` shows the robot of one of them in three dimensions."))] : []),
    table(["File", ...KINDS.map((kind) => KIND_NAMES[kind])], rows)];
}

function numbers(found: Finding[]): Cell[] {
  return KINDS.map((kind: Kind) => {
    const number = found.filter((each) => kindOf(each) === kind).length;
    return number ? made("span", { class: kind }, number.toLocaleString("en")) : "";
  });
}

function ruleCell(report: Report, number: number, filter: State["filter"]): Node {
  const rule = report.rules[number]!;
  return made("div", {}, made("a", { href: linkTo(filter) }, `${rule.code} ${rule.name}`),
    made("div", { class: "faint" }, ...prose(rule.summary)));
}

function grouped<T>(all: T[], key: (each: T) => number): Map<number, T[]> {
  const groups = new Map<number, T[]>();
  for (const each of all) {
    const group = groups.get(key(each));
    if (group) group.push(each);
    else groups.set(key(each), [each]);
  }
  return groups;
}

/** A table; columns without words are of numbers. */
function table(heads: string[], rows: Cell[][]): HTMLElement {
  const isNumber = heads.map((_, at) => rows.every((row) => !isWords(row[at]!)));
  const kind = (at: number): Record<string, string> => (isNumber[at] ? { class: "number" } : {});
  return made("div", { class: "scrolled" }, made("table", {},
    made("thead", {}, made("tr", {}, ...heads.map((head, at) => made("th", { scope: "col", ...kind(at) }, head)))),
    made("tbody", {}, ...rows.map((row) => made("tr", {}, ...row.map((cell, at) =>
      made("td", kind(at), typeof cell === "number" ? cell.toLocaleString("en") : cell)))))));
}

function isWords(cell: Cell): boolean {
  return typeof cell === "string" ? cell !== "" : typeof cell !== "number" && cell.nodeName !== "SPAN";
}
