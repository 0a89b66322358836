// The robot that follows its text: what the server sends is drawn, what a person does is told to the server.

import type { Object3D } from "three";
import type { Mesh, Page, Place } from "./data";
import type { Viewer } from "./main";
import { Meshes } from "./meshes";
import type { Pointer } from "./pointer";
import type { Stage } from "./stage";

/** What the page tells the server. */
export type Word =
  | { kind: "ready" }
  | ({ kind: "picked"; finding?: number } & Place)
  | { kind: "arguments"; values: Record<string, string> }
  | { kind: "meshes"; keys: string[] };
export type Say = (word: Word) => void;

/** What the server sends. */
type News =
  | { kind: "robot"; page: Page; note: string }
  | { kind: "note"; note: string }
  | ({ kind: "mesh"; key: string } & Pick<Mesh, "format" | "data" | "files">)
  | { kind: "cursor"; places: Place[] };

interface Editor {
  postMessage(word: Word): void;
}
declare function acquireVsCodeApi(): Editor;

/** Connects with the server, by events over HTTP or by the editor that shows the page. */
function connected(how: "http" | "editor", take: (news: News) => void, lost: (isLost: boolean) => void): Say {
  if (how === "editor") {
    const editor = acquireVsCodeApi();
    addEventListener("message", (event: MessageEvent<News>) => take(event.data));
    return (word) => editor.postMessage(word);
  }
  const events = new EventSource("events");
  events.onmessage = (event: MessageEvent<string>) => take(JSON.parse(event.data) as News);
  events.onopen = () => lost(false);
  events.onerror = () => lost(true);
  return (word) => {
    const body = JSON.stringify(word);
    const headers = { "Content-Type": "application/json" };
    fetch("say", { method: "POST", headers, body }).catch(() => lost(true));
  };
}

/** Shows the robot on a stage, each in a new `View`, and again whenever the server sends one. */
export function follow(how: "http" | "editor", stage: Stage, pointer: Pointer, View: typeof Viewer): void {
  const known = new Map<string, Object3D | null>();
  const waited = new Set<string>();
  const note = document.getElementById("note") as HTMLElement;
  let viewer: Viewer | null = null;
  let latest: Page | null = null;
  let words = "";
  let queue = Promise.resolve();

  const tell = (isLost: boolean): void => {
    note.textContent = isLost ? "The editor has ended the connection; this is the last robot." : words;
    note.hidden = !note.textContent;
  };
  const draw = async (page: Page): Promise<void> => {
    const meshes = new Meshes(page.meshes, known);
    await meshes.load();
    if (page !== latest) return; // a newer one waits
    const kept = viewer?.kept() ?? null;
    stage.clear();
    viewer = new View({ ...page, live: how }, stage, meshes, pointer, kept, say);
    viewer.finish();
    Object.assign(window, { viewer });
    document.documentElement.dataset.ready = String(Number(document.documentElement.dataset.ready ?? 0) + 1);
    const missing = page.meshes.flatMap(({ key }) => (key && !known.has(key) && !waited.has(key) ? [key] : []));
    for (const key of missing) waited.add(key);
    if (missing.length) say({ kind: "meshes", keys: missing });
  };
  const learn = async (mesh: Mesh): Promise<void> => {
    await new Meshes([mesh], known).load();
    waited.delete(mesh.key ?? "");
    if (latest && !waited.size) await draw(latest);
  };
  const take = (news: News): void => {
    if (news.kind === "robot" || news.kind === "note") {
      words = news.note;
      tell(false);
    }
    if (news.kind === "robot") {
      latest = news.page;
      const title = document.querySelector("h1");
      if (title) title.textContent = news.page.scenes[0]?.file ?? "";
    }
    queue = queue.then(async () => {
      if (news.kind === "robot") await draw(news.page);
      else if (news.kind === "mesh") await learn({ name: news.key, ...news });
      else if (news.kind === "cursor") viewer?.point(news.places);
    });
  };
  const say = connected(how, take, tell);
  say({ kind: "ready" });
}
