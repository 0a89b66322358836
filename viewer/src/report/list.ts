// The findings that a filter leaves, file by file; no more rows than are looked at.

import { counted, made, path } from "../made";
import { type Finding, type Report } from "./data";
import { fill, row } from "./finding";
import { fragmentOf, linkTo } from "./filter";

const ROWS = 300;
/** So few findings are shown open. */
const OPEN = 12;

export class List {
  readonly element = made("div", { id: "findings" });
  private found: Finding[] = [];
  private shown = 0;
  private readonly more = made("button", { type: "button", class: "more-rows" });
  private group: HTMLElement | null = null;
  private file = -1;

  constructor(private readonly report: Report) {
    this.more.addEventListener("click", () => this.extend(ROWS));
  }

  show(found: Finding[]): void {
    this.found = found;
    this.shown = 0;
    this.file = -1;
    this.element.replaceChildren();
    this.extend(ROWS);
    if (found.length <= OPEN) this.openAll(true);
  }

  /** Opens or closes all that is shown. */
  openAll(open: boolean): void {
    this.rows().forEach((details, number) => {
      if (open) fill(details, this.report, this.found[number]!);
      details.open = open;
    });
  }

  /** Shows all, and all of it open, as paper has no way to ask for more. */
  unfold(): void {
    this.extend(this.found.length);
    this.openAll(true);
  }

  /** Moves the focus by a number of rows. */
  step(by: number): void {
    const rows = this.rows();
    const at = rows.findIndex((details) => details.contains(document.activeElement));
    const next = rows[at < 0 ? 0 : Math.min(Math.max(at + by, 0), rows.length - 1)];
    next?.querySelector("summary")?.focus();
  }

  private rows(): HTMLDetailsElement[] {
    return [...this.element.querySelectorAll<HTMLDetailsElement>("details.finding")];
  }

  private extend(number: number): void {
    this.more.remove();
    for (const finding of this.found.slice(this.shown, this.shown + number)) {
      if (finding.file !== this.file || this.group === null) {
        this.file = finding.file;
        const link = linkTo({ file: this.report.places[finding.file]! });
        const heading = made("h3", {}, made("a", { href: link }, ...path(this.report.places[finding.file]!)));
        const place = this.report.places[finding.file]!;
        if (this.report.robots.includes(place))
          heading.append(" ", made("a", { class: "robot", href: fragmentOf({ view: "robots", filter: { file: place } }) }, "robot"));
        this.group = made("section", {}, heading);
        this.element.append(this.group);
      }
      this.group.append(row(this.report, finding));
    }
    this.shown = Math.min(this.shown + number, this.found.length);
    const left = this.found.length - this.shown;
    if (left > 0) {
      this.more.textContent = `Show ${Math.min(ROWS, left)} more of ${counted(left, "finding")}`;
      this.element.append(this.more);
    }
  }
}
