import { execFile } from "child_process";
import { promisify } from "util";
import * as vscode from "vscode";
import { type LanguageClient, type Location, State } from "vscode-languageclient/node";
import { Conversions } from "./convert";
import { ExpandedTexts } from "./expanded";
import { find, type Found } from "./find";
import { Robots } from "./robot";
import { LANGUAGES, makeClient, REFERENCES } from "./server";

const run = promisify(execFile);
const INSTALL = "pip install 'sdfcheck[lsp]'";

let client: LanguageClient | undefined;
let status: vscode.StatusBarItem;
let output: vscode.OutputChannel;
let robots: Robots;

function setting(section: string, name: string): string {
  return vscode.workspace.getConfiguration(section).get<string>(name) ?? "";
}

function program(): Found {
  return find({
    command: setting("sdfcheck", "command"),
    folders: (vscode.workspace.workspaceFolders ?? []).map((folder) => folder.uri.fsPath),
    interpreter: setting("python", "defaultInterpreterPath"),
    isTrusted: vscode.workspace.isTrusted,
    environment: process.env,
    platform: process.platform,
  });
}

/** Starts the server, and shows how it is in the status bar. */
async function start(): Promise<void> {
  const { command, tried } = program();
  if (!command) {
    output.appendLine(`sdfcheck was looked for in:\n${tried.map((folder) => `  ${folder}`).join("\n")}`);
    await complain(`sdfcheck is not installed where this workspace looks for programs. Install it with: ${INSTALL}`);
    return;
  }
  const started = makeClient(command, output);
  client = started;
  started.onDidChangeState(({ newState }) => {
    status.text = newState === State.Running ? "$(check) sdfcheck" : "$(sync) sdfcheck";
    status.tooltip = command;
  });
  try {
    await started.start();
    await robots.connect(started);
  } catch (error) {
    client = undefined;
    await complain(`${command} does not start: ${await reason(command, error)}`);
  }
}

/** What the program itself says about why it does not run. */
async function reason(command: string, error: unknown): Promise<string> {
  try {
    await run(command, ["server", "--help"], { timeout: 10_000 });
    const asked = run(command, ["server"], { timeout: 10_000 });
    asked.child.stdin?.end();
    await asked;
  } catch (failure) {
    const { stderr, message } = failure as { stderr?: string; message: string };
    return (stderr || message).trim();
  }
  return error instanceof Error ? error.message : String(error);
}

/** Says why there is no server, and what to do. */
async function complain(text: string): Promise<void> {
  status.text = "$(error) sdfcheck";
  output.appendLine(text);
  const chosen = await vscode.window.showErrorMessage(text, "How to Install", "Settings");
  if (chosen === "Settings")
    await vscode.commands.executeCommand("workbench.action.openSettings", "sdfcheck.command");
  if (chosen === "How to Install")
    await vscode.commands.executeCommand("workbench.action.openWalkthrough", "sdfcheck.sdfcheck#start", false);
}

async function stop(): Promise<void> {
  const old = client;
  client = undefined;
  if (old?.isRunning()) await old.stop();
}

/** Does something about the document in the editor; what is in the way is shown. */
function about(work: (running: LanguageClient, uri: vscode.Uri) => Promise<unknown>): (given?: unknown) => Promise<void> {
  return async (given) => {
    const document = vscode.window.activeTextEditor?.document;
    const uri = given instanceof vscode.Uri ? given : document?.uri;
    if (uri === undefined || (document !== undefined && uri === document.uri && !isDescription(document))) {
      void vscode.window.showInformationMessage("Open a robot description first.");
      return;
    }
    if (client === undefined) {
      void vscode.window.showErrorMessage("The server of sdfcheck does not run: see the output.");
      return;
    }
    try {
      if (given instanceof vscode.Uri) await vscode.workspace.openTextDocument(given);
      await work(client, uri);
    } catch (error) {
      void vscode.window.showErrorMessage(`sdfcheck: ${error instanceof Error ? error.message : String(error)}`);
    }
  };
}

function isDescription(document: vscode.TextDocument): boolean {
  return LANGUAGES.includes(document.languageId) || /\.(sdf|world|urdf|urdf\.xml|xacro|srdf)$/.test(document.uri.path);
}

/** Prints the joints and links of the file; what the program complains of is shown. */
async function graph(uri: vscode.Uri): Promise<void> {
  const { command } = program();
  const document = vscode.workspace.textDocuments.find((each) => String(each.uri) === String(uri));
  await document?.save();
  const { stdout } = await run(command ?? "sdfcheck", ["graph", "joints", uri.fsPath], { maxBuffer: 1 << 28 });
  output.appendLine(stdout);
  output.show(true);
}

async function fixAll(): Promise<void> {
  await vscode.commands.executeCommand("editor.action.codeAction", {
    kind: "source.fixAll.sdfcheck",
    apply: "first",
  });
}

/** Shows the places that a line above a definition counts. */
async function references(uri: string, position: { line: number; character: number }, places: Location[]): Promise<void> {
  const convert = client?.protocol2CodeConverter;
  if (convert)
    await vscode.commands.executeCommand(
      "editor.action.showReferences",
      convert.asUri(uri),
      convert.asPosition(position),
      places.map((place) => convert.asLocation(place)),
    );
}

async function restart(): Promise<void> {
  await stop();
  await start();
}

async function configured(change: vscode.ConfigurationChangeEvent): Promise<void> {
  if (change.affectsConfiguration("sdfcheck.command") || change.affectsConfiguration("python.defaultInterpreterPath"))
    await restart();
  else if (change.affectsConfiguration("sdfcheck"))
    await client?.sendNotification("workspace/didChangeConfiguration", { settings: {} });
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  output = vscode.window.createOutputChannel("sdfcheck");
  status = vscode.window.createStatusBarItem(vscode.StatusBarAlignment.Right, 0);
  status.command = "sdfcheck.output";
  status.text = "$(sync) sdfcheck";
  status.show();
  const running = () => client;
  robots = new Robots(running);
  const expanded = new ExpandedTexts(running);
  const conversions = new Conversions();
  const commands: Record<string, (...given: never[]) => unknown> = {
    "sdfcheck.restart": restart,
    "sdfcheck.fixAll": fixAll,
    "sdfcheck.output": () => output.show(),
    "sdfcheck.view": about((_, uri) => robots.show(uri)),
    "sdfcheck.showExpanded": about((_, uri) => expanded.show(uri)),
    "sdfcheck.convertDocument": about((server, uri) => conversions.convert(server, uri)),
    "sdfcheck.graph": about((_, uri) => graph(uri)),
    [REFERENCES]: references,
  };
  context.subscriptions.push(
    output,
    status,
    robots,
    expanded,
    conversions,
    ...Object.entries(commands).map(([name, work]) => vscode.commands.registerCommand(name, work)),
    vscode.workspace.onDidChangeConfiguration(configured),
    vscode.workspace.onDidGrantWorkspaceTrust(() => (client ? undefined : start())),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await stop();
}
