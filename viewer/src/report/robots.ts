// The robots of a run, one at a time, each in a frame of its own: the page that `sdfcheck view` writes.

import { made, path, prose } from "../made";
import type { Report } from "./data";
import { fragmentOf } from "./filter";

/** What stands for the file's name: see sdfcheck/report/content.py. */
const TITLE = /\ue000/g;

export class Robots {
  readonly element = made("div", { class: "robots" });
  private shown: string | null = null;

  constructor(private readonly report: Report) {}

  /** Shows the robot of a file, or the first one. */
  show(file: string | undefined): void {
    const wanted = file !== undefined && this.report.robots.includes(file) ? file : (this.report.robots[0] ?? "");
    if (wanted === this.shown) return;
    this.shown = wanted;
    this.element.replaceChildren(this.links(wanted));
    if (!wanted) return;
    // A frame shares the policy of this page, and nothing else.
    const frame = made("iframe", { title: `The robot of ${wanted}`, sandbox: "allow-scripts allow-popups" });
    frame.srcdoc = this.pageOf(wanted);
    this.element.append(frame);
  }

  private links(wanted: string): HTMLElement {
    const { robots, notDrawn } = this.report;
    return made("ul", {}, ...robots.map((file) =>
      made("li", {}, made("a", {
        href: fragmentOf({ view: "robots", filter: { file } }), ...(file === wanted ? { "aria-current": "true" } : {}),
      }, ...path(file)))), ...notDrawn.map(({ file, reason }) =>
      made("li", { class: "faint" }, ...path(file), ": ", ...prose(reason))));
  }

  private pageOf(file: string): string {
    const [before, after] = JSON.parse(text("viewer")) as [string, string];
    const title = made("p", {}, file).innerHTML;
    return before.replace(TITLE, () => title) + text(`robot-${this.report.robots.indexOf(file)}`) + after;
  }
}

function text(id: string): string {
  return document.getElementById(id)!.textContent!;
}
