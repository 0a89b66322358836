// What is shown, as the fragment of the address: every state of the page is a link.

import { kindOf, type Finding, type Report } from "./data";

export const VIEWS = ["summary", "findings", "rules", "files", "robots"] as const;
export type View = (typeof VIEWS)[number];

export const FIXES: Record<string, string> = {
  safe: "Safe fix", unsafe: "Unsafe fix", manual: "No safe fix",
};

const NAMES = ["q", "severity", "rule", "file", "consumer", "fix"] as const;
export type Name = (typeof NAMES)[number];

export interface State {
  view: View;
  filter: Partial<Record<Name, string>>;
}

export function stateOf(fragment: string): State {
  const given = new URLSearchParams(fragment.replace(/^#/, ""));
  const filter: State["filter"] = {};
  for (const name of NAMES) {
    const value = given.get(name);
    if (value) filter[name] = value;
  }
  const asked = VIEWS.find((view) => view === given.get("view"));
  return { view: asked ?? (Object.keys(filter).length ? "findings" : "summary"), filter };
}

export function fragmentOf({ view, filter }: State): string {
  const all = new URLSearchParams();
  if (view !== "findings" || !Object.keys(filter).length) all.set("view", view);
  for (const name of NAMES) {
    const value = filter[name];
    if (value) all.set(name, value);
  }
  return `#${all.toString()}`;
}

/** A link to the findings that a filter leaves. */
export function linkTo(filter: State["filter"]): string {
  return fragmentOf({ view: "findings", filter });
}

/** Picks findings; texts to search are made once. */
export class Search {
  private readonly texts: string[] = [];

  constructor(private readonly report: Report) {}

  found(filter: State["filter"]): Finding[] {
    const words = (filter.q ?? "").toLowerCase().split(/\s+/).filter(Boolean);
    return this.report.findings.filter((finding, number) =>
      this.fits(finding, filter) && words.every((word) => this.text(number).includes(word)));
  }

  private fits(finding: Finding, { severity, rule, file, consumer, fix }: State["filter"]): boolean {
    if (severity && kindOf(finding) !== severity) return false;
    if (rule && this.report.rules[finding.rule]!.code !== rule) return false;
    if (file && this.report.places[finding.file] !== file) return false;
    if (consumer && !this.report.reactions[finding.affects ?? 0]!.some((each) =>
      each.consumer === consumer && each.verdict !== "accept")) return false;
    if (fix === "safe" || fix === "unsafe") return finding.fix !== undefined && finding.fix.safe === (fix === "safe");
    return fix !== "manual" || !finding.fix?.safe;
  }

  private text(number: number): string {
    const finding = this.report.findings[number]!;
    const { code, name } = this.report.rules[finding.rule]!;
    return (this.texts[number] ??=
      `${code} ${name} ${this.report.places[finding.file]}:${finding.line} ${finding.message}`.toLowerCase());
  }
}
