// What the page is given: see sdfcheck/report/content.py.

export type Severity = "error" | "warning" | "info";

export interface Frame {
  place: string;
  text: string;
}

/** Unchanged, taken out or put in. */
export type Piece = ["=" | "-" | "+", string];

export interface Fix {
  title: string;
  safe: boolean;
  hunks: { line: number; pieces: Piece[] }[];
}

export interface Finding {
  rule: number;
  severity: Severity;
  file: number;
  line: number;
  column: number;
  message: string;
  frames?: Frame[];
  fix?: Fix;
  help?: string;
  origins?: string[];
  missing?: boolean;
  affects?: number;
}

export interface Rule {
  code: string;
  name: string;
  summary: string;
  page: string | null;
  /** Markdown: paragraphs and blocks of code. */
  remedy: string;
}

export interface Reaction {
  consumer: string;
  verdict: "accept" | "warn" | "reject" | "not read";
  words: string;
}

export interface Row {
  rule: number;
  severity: Severity;
  count: number;
  files: number;
}

export interface Report {
  version: string;
  closing: string;
  files: number;
  fixed: number;
  suppressed: number;
  frames: number;
  findings: Finding[];
  places: string[];
  rules: Rule[];
  reactions: Reaction[][];
  sections: { heading: string; fixable: boolean; rows: Row[] }[];
  missing: string[];
  skipped: { file: string; reason: string }[];
  /** Files of which the page holds the robot. */
  robots: string[];
  /** Files whose robots are not drawn, and why. */
  notDrawn: { file: string; reason: string }[];
  /** Pages about more files hold none. */
  mostRobots: number;
}

/** What is counted: findings by severity, and apart from them those about the computer. */
export type Kind = Severity | "missing";

export const KINDS: readonly Kind[] = ["error", "warning", "info", "missing"];

export const KIND_NAMES: Record<Kind, string> = {
  error: "Errors", warning: "Warnings", info: "Infos", missing: "Not found here",
};

export function kindOf(finding: Finding): Kind {
  return finding.missing ? "missing" : finding.severity;
}
