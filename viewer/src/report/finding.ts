// One finding: a line that opens to its code, its fix and what consumers do about it.

import { made, prose } from "../made";
import { kindOf, type Finding, type Fix, type Piece, type Report } from "./data";
import { linkTo } from "./filter";

/** What the text report paints, by the codes of a terminal: see sdfcheck/report/colors.py. */
const INKS: Record<string, string> = {
  "1;31": "error", "1;33": "warning", "1;36": "info", "1": "strong", "1;34": "gutter", "34": "label", "2": "faint",
};

export function row(report: Report, finding: Finding): HTMLDetailsElement {
  const rule = report.rules[finding.rule]!;
  const kind = kindOf(finding);
  const details = made("details", { class: `finding ${kind}` },
    made("summary", {},
      made("span", { class: "place" }, `${finding.line}:${finding.column}`),
      made("span", { class: "severity" }, kind === "missing" ? "not found" : finding.severity),
      made("span", { class: "message" }, ...prose(finding.message)),
      made("span", { class: "code" }, rule.code),
    ));
  details.addEventListener("toggle", () => fill(details, report, finding), { once: true });
  return details;
}

/** Writes what is in a line that is opened; at the first time only. */
export function fill(details: HTMLDetailsElement, report: Report, finding: Finding): void {
  if (details.childElementCount > 1) return;
  const rule = report.rules[finding.rule]!;
  const body = made("div", { class: "body" });
  for (const frame of finding.frames ?? []) {
    if (frame.place) body.append(made("p", { class: "elsewhere" }, frame.place));
    body.append(made("pre", { class: "frame", tabindex: "0", role: "group", "aria-label": "Lines of code" },
      ...painted(frame.text)));
  }
  if (finding.fix) body.append(...fixed(finding.fix, finding.line));
  if (finding.help) body.append(made("p", {}, made("strong", {}, "Help: "), ...prose(finding.help)));
  if (rule.remedy) body.append(remedy(rule.remedy));
  for (const origin of finding.origins ?? []) body.append(made("p", {}, made("strong", {}, "Note: "), origin));
  const reactions = report.reactions[finding.affects ?? 0]!;
  if (reactions.length)
    body.append(made("ul", { class: "reactions", "aria-label": "What consumers do" }, ...reactions.map((each) =>
      made("li", { class: each.verdict }, made("strong", {}, each.consumer), ` ${each.words}`))));
  body.append(made("p", { class: "more" },
    rule.page
      ? made("a", { href: rule.page, rel: "noreferrer" }, `${rule.code} ${rule.name}`)
      : made("code", {}, `sdfcheck rule ${rule.name}`),
    " ", ...prose(rule.summary), " ", made("a", { href: linkTo({ rule: rule.code }) }, "All of this rule")));
  details.append(body);
}

function remedy(text: string): HTMLElement {
  const parts = text.split(/^```\w*\n([^]*?)^```$/m).flatMap((part, at): HTMLElement[] =>
    at % 2
      ? [made("pre", { tabindex: "0", role: "group", "aria-label": "Example" }, part.trimEnd())]
      : part.split(/\n\n+/).filter((each) => each.trim()).map((each) => made("p", {}, ...prose(each.trim()))));
  return made("details", { class: "remedy" }, made("summary", {}, "How to fix it"), ...parts);
}

function painted(text: string): (Node | string)[] {
  const pieces: (Node | string)[] = [];
  let ink = "0";
  text.split(/\x1b\[([\d;]*)m/).forEach((piece, at) => {
    if (at % 2) ink = piece;
    else if (piece) pieces.push(INKS[ink] ? made("span", { class: INKS[ink] }, piece) : piece);
  });
  return pieces;
}

function fixed(fix: Fix, line: number): Node[] {
  return [
    made("p", {}, made("strong", {}, "Fix: "), ...prose(fix.title), ` (${fix.safe ? "safe" : "unsafe"})`),
    ...fix.hunks.flatMap((hunk) => [
      ...(hunk.line === line ? [] : [made("p", { class: "elsewhere" }, `line ${hunk.line}`)]),
      made("pre", { class: "fix", tabindex: "0", role: "group", "aria-label": `The fix, from line ${hunk.line} on` },
        ...difference(hunk.pieces)),
    ]),
  ];
}

/** The lines before and after, as differences are usually written. */
function difference(pieces: Piece[]): Node[] {
  const before = lines(pieces, "+").filter((each) => each.changed).map((each) => made("div", {}, "- ", ...each.pieces));
  const after = lines(pieces, "-").map((each) => made("div", {}, each.changed ? "+ " : "  ", ...each.pieces));
  return [...before, ...after];
}

interface Line {
  pieces: (Node | string)[];
  changed: boolean;
}

function lines(pieces: Piece[], hidden: "-" | "+"): Line[] {
  let line: Line = { pieces: [], changed: false };
  const all = [line];
  for (const [kind, text] of pieces) {
    // Whole lines that are gone or new leave their neighbours as they are.
    if (kind === hidden) line.changed ||= line.pieces.length > 0 || !text.endsWith("\n");
    else
      text.split("\n").forEach((part, at) => {
        if (at) all.push((line = { pieces: [], changed: false }));
        if (part) line.pieces.push(kind === "=" ? part : made(kind === "-" ? "del" : "ins", {}, part));
        line.changed ||= kind !== "=" && part !== "";
      });
  }
  return all;
}
