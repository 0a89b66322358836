import assert from "node:assert/strict";
import { chmodSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { beforeEach, test } from "node:test";
import type * as api from "vscode";
import { activate, deactivate } from "../src/extension";
import { SCHEME } from "../src/expanded";
import { server } from "./client";
import { documentOf, editor, events, NEVER, Position, Uri, window, workspace } from "./vscode";

const manifest = JSON.parse(readFileSync("package.json", "utf8")) as {
  contributes: { commands: { command: string }[]; menus: Record<string, { command: string }[]> };
};
const FILE = Uri.file("/robots/r.urdf.xacro");
const PLACE = { start: { line: 3, character: 4 }, end: { line: 3, character: 8 } };

let context: api.ExtensionContext;

async function begin(): Promise<void> {
  context = { subscriptions: [] } as unknown as api.ExtensionContext;
  await activate(context);
}

async function run(name: string, ...given: unknown[]): Promise<void> {
  await editor.commands.get(name)?.(...given);
}

beforeEach(async () => {
  await deactivate();
  for (const part of context?.subscriptions ?? []) part.dispose();
  server.made.length = server.asked.length = 0;
  server.answers.clear();
  server.fails = "";
  for (const list of [editor.executed, editor.messages, editor.lines, editor.shown, editor.panels, editor.documents])
    list.length = 0;
  editor.problems.clear();
  editor.settings.clear();
  editor.settings.set("sdfcheck.command", "sdfcheck");
  editor.answer = undefined;
  window.activeTextEditor = { document: documentOf(FILE, "urdf") } as api.TextEditor;
  window.visibleTextEditors = [];
});

test("all commands of the manifest are there, and menus name no others", async () => {
  await begin();
  const contributed = manifest.contributes.commands.map(({ command }) => command);
  for (const name of contributed) assert.ok(editor.commands.has(name), name);
  for (const item of Object.values(manifest.contributes.menus).flat()) assert.ok(contributed.includes(item.command));
});

test("the server is started, and learns which commands the editor has", async () => {
  await begin();
  const [client] = server.made;
  assert.deepEqual(client.options, { command: "sdfcheck", args: ["server"] });
  assert.equal(editor.status.text, "$(check) sdfcheck");
  const able = {} as Parameters<(typeof client.features)[0]["fillClientCapabilities"] & object>[0];
  for (const feature of client.features) feature.fillClientCapabilities(able);
  assert.deepEqual(able.experimental, { commands: ["sdfcheck.references"] });
});

test("without the program there is a message that says what to do", async () => {
  editor.settings.delete("sdfcheck.command");
  const path = process.env.PATH;
  process.env.PATH = mkdtempSync(join(tmpdir(), "empty-"));
  try {
    editor.answer = "How to Install";
    await begin();
  } finally {
    process.env.PATH = path;
  }
  assert.match(editor.messages[0], /not installed.*pip install 'sdfcheck\[lsp\]'/);
  assert.match(editor.lines[0], /looked for in/);
  assert.equal(editor.executed[0][0], "workbench.action.openWalkthrough");
  assert.equal(server.made.length, 0);
  await run("sdfcheck.view");
  assert.match(editor.messages[1], /does not run/);
});

test("the program of the workspace is used", async () => {
  const folder = mkdtempSync(join(tmpdir(), "workspace-"));
  const { mkdirSync } = await import("node:fs");
  mkdirSync(join(folder, ".venv", "bin"), { recursive: true });
  writeFileSync(join(folder, ".venv", "bin", "sdfcheck"), "");
  editor.settings.delete("sdfcheck.command");
  workspace.workspaceFolders = [{ uri: Uri.file(folder) } as unknown as api.WorkspaceFolder];
  await begin();
  workspace.workspaceFolders = undefined;
  assert.equal(server.made[0].options.command, join(folder, ".venv", "bin", "sdfcheck"));
});

test("a server that does not start says why in its own words", { skip: process.platform === "win32" }, async () => {
  const file = join(mkdtempSync(join(tmpdir(), "broken-")), "sdfcheck");
  writeFileSync(file, "#!/bin/sh\necho 'the language server needs pygls' >&2\nexit 2\n");
  chmodSync(file, 0o755);
  editor.settings.set("sdfcheck.command", file);
  server.fails = "connection closed";
  await begin();
  assert.match(editor.messages[0], /does not start: the language server needs pygls/);
});

test("the robot is beside its text: messages pass in both directions", async () => {
  await begin();
  server.answers.set("sdfcheck.robotPage", { html: "<p>robot</p>" });
  await run("sdfcheck.view");
  const [panel] = editor.panels;
  assert.equal(panel.webview.html, "<p>robot</p>");
  assert.deepEqual(server.asked[0].arguments, [{ uri: String(FILE) }]);
  const news = { kind: "note", note: "x" };
  server.made[0].notifications.get("sdfcheck/robot")?.({ uri: String(FILE), message: news });
  server.made[0].notifications.get("sdfcheck/robot")?.({ uri: "file:///other", message: "not for it" });
  assert.deepEqual(panel.posted, [news]);
  server.answers.set("sdfcheck.robotSay", { uri: String(FILE), range: PLACE });
  window.visibleTextEditors = [{ document: { uri: FILE }, viewColumn: 7 } as unknown as api.TextEditor];
  panel.received.fire({ kind: "picked" });
  await new Promise((done) => setTimeout(done, 5));
  assert.deepEqual(server.asked[1].arguments, [{ uri: String(FILE), message: { kind: "picked" } }]);
  const [{ document, options }] = editor.shown;
  assert.equal(document, String(FILE));
  assert.equal((options as { viewColumn: number }).viewColumn, 7);
  await run("sdfcheck.view");
  assert.equal(editor.panels.length, 1);
  assert.equal(panel.revealed, 1);
  panel.dispose();
  await run("sdfcheck.view");
  assert.equal(editor.panels.length, 2);
});

test("the cursor is told while a robot is shown, and once for quick moves", async () => {
  await begin();
  const move = (line: number): void =>
    events.selection.fire({
      textEditor: { document: { uri: FILE } },
      selections: [{ active: { line, character: 2 } }],
    } as unknown as api.TextEditorSelectionChangeEvent);
  move(1);
  await new Promise((done) => setTimeout(done, 100));
  assert.equal(server.asked.length, 0);
  server.answers.set("sdfcheck.robotPage", { html: "" });
  await run("sdfcheck.view");
  for (const line of [1, 2, 3]) move(line);
  await new Promise((done) => setTimeout(done, 100));
  assert.deepEqual(
    server.asked.slice(1).map((asked) => [asked.command, asked.arguments[0].position]),
    [["sdfcheck.cursor", { line: 3, character: 2 }]],
  );
});

test("a server that starts again shows its robots again", async () => {
  await begin();
  server.answers.set("sdfcheck.robotPage", { html: "old" });
  await run("sdfcheck.view");
  server.answers.set("sdfcheck.robotPage", { html: "new" });
  await run("sdfcheck.restart");
  assert.equal(server.made.length, 2);
  assert.equal(server.made[0].isRunning(), false);
  assert.equal(editor.panels[0].webview.html, "new");
});

test("the expanded text leads back", async () => {
  await begin();
  const text = '<robot name="r">\n  <!-- <no> -->\n  <link name="a > b"/>\n</robot>\n';
  const place = (line: number) => ({
    uri: "file:///robots/macros.xacro",
    range: { start: { line, character: 3 }, end: { line, character: 7 } },
  });
  server.answers.set("sdfcheck.expand", {
    text,
    language: "urdf",
    places: [
      { first: 0, last: 3, location: place(0) },
      { first: 2, last: 2, location: place(40) },
    ],
  });
  await run("sdfcheck.showExpanded");
  const uri = editor.shown[0].document;
  assert.ok(uri.startsWith(`${SCHEME}:`));
  const document = editor.documents.find((each) => String(each.uri) === uri) as api.TextDocument;
  assert.equal(document.getText(), text);
  const links = (await editor.providers.links?.provideDocumentLinks(document, NEVER)) ?? [];
  assert.deepEqual(
    links.map(({ range, target }) => [range.start.line, range.start.character, range.end.character, String(target)]),
    [
      [0, 1, 6, "file:///robots/macros.xacro#L1,4"],
      [2, 3, 7, "file:///robots/macros.xacro#L41,4"],
    ],
  );
  const at = new Position(2, 10) as api.Position;
  const found = (await editor.providers.definition?.provideDefinition(document, at, NEVER)) as api.Location;
  assert.equal(found.range.start.line, 40);
});

test("a conversion is shown with its losses", async () => {
  await begin();
  const loss = { message: "lost" };
  server.answers.set("sdfcheck.convert", {
    text: "<sdf/>",
    language: "sdformat",
    verified: true,
    verdict: "2 links",
    losses: [{ uri: String(FILE), diagnostic: loss }],
  });
  await run("sdfcheck.convertDocument");
  assert.equal(editor.shown[0].document, "untitled://1");
  assert.deepEqual(editor.problems.get(String(FILE)), [loss]);
  assert.equal(editor.messages[0], "Verified: 2 links; 1 loss is listed under Problems.");
});

test("what cannot be done is said", async () => {
  await begin();
  server.answers.set("sdfcheck.convert", new Error("looks like a picture"));
  await run("sdfcheck.convertDocument");
  assert.equal(editor.messages[0], "sdfcheck: looks like a picture");
  window.activeTextEditor = undefined;
  await run("sdfcheck.view");
  window.activeTextEditor = { document: documentOf(Uri.file("/x.py"), "python") } as api.TextEditor;
  await run("sdfcheck.view");
  assert.deepEqual(editor.messages.slice(1), Array(2).fill("Open a robot description first."));
});

test("lines above definitions show their places", async () => {
  await begin();
  await run("sdfcheck.references", String(FILE), PLACE.start, [{ uri: String(FILE), range: PLACE }]);
  const [command, uri, position, places] = editor.executed[0] as [string, Uri, Position, unknown[]];
  assert.equal(command, "editor.action.showReferences");
  assert.equal(String(uri), String(FILE));
  assert.equal(position.line, 3);
  assert.equal(places.length, 1);
});

test("settings are passed on, and another program is started", async () => {
  await begin();
  const change = (section: string): void =>
    events.configuration.fire({ affectsConfiguration: (each: string) => each === section });
  change("sdfcheck");
  assert.deepEqual(server.made[0].sent, [["workspace/didChangeConfiguration", { settings: {} }]]);
  change("python.defaultInterpreterPath");
  await new Promise((done) => setTimeout(done, 5));
  assert.equal(server.made.length, 2);
});
