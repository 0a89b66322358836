import { execFile } from "child_process";
import * as path from "path";
import { promisify } from "util";
import * as vscode from "vscode";
import { LanguageClient, LanguageClientOptions, ServerOptions, State } from "vscode-languageclient/node";

const run = promisify(execFile);

let client: LanguageClient | undefined;
let status: vscode.StatusBarItem;
let output: vscode.OutputChannel;

function command(): string {
  return vscode.workspace.getConfiguration("sdfcheck").get<string>("command") || "sdfcheck";
}

/** Starts the server, and shows how it is in the status bar. */
async function start(): Promise<void> {
  const server: ServerOptions = { command: command(), args: ["server"] };
  const options: LanguageClientOptions = {
    documentSelector: [
      { scheme: "file", language: "sdformat" },
      { scheme: "file", language: "urdf" },
      { scheme: "untitled", language: "sdformat" },
      { scheme: "untitled", language: "urdf" },
      { scheme: "file", language: "xml", pattern: "**/*.{sdf,world,urdf,xacro}" },
      { scheme: "file", pattern: "**/model.config" },
    ],
    initializationOptions: vscode.workspace.getConfiguration("sdfcheck"),
    outputChannel: output,
  };
  client = new LanguageClient("sdfcheck", "sdfcheck", server, options);
  client.onDidChangeState(({ newState }) => {
    status.text = newState === State.Running ? "$(check) sdfcheck" : "$(sync) sdfcheck";
  });
  try {
    await client.start();
  } catch (error) {
    status.text = "$(error) sdfcheck";
    const chosen = await vscode.window.showErrorMessage(
      `sdfcheck does not start: ${error}. Install it with: pip install 'sdfcheck[lsp]'`,
      "Settings",
    );
    if (chosen) {
      await vscode.commands.executeCommand("workbench.action.openSettings", "sdfcheck.command");
    }
  }
}

async function stop(): Promise<void> {
  const old = client;
  client = undefined;
  if (old?.isRunning()) {
    await old.stop();
  }
}

/** The file in the editor, saved; undefined where there is none. */
async function savedFile(): Promise<string | undefined> {
  const document = vscode.window.activeTextEditor?.document;
  if (document === undefined || document.isUntitled) {
    void vscode.window.showInformationMessage("Open a robot description first.");
    return undefined;
  }
  await document.save();
  return document.fileName;
}

/** What the program prints; its complaints are shown. */
async function sdfcheck(...args: string[]): Promise<string | undefined> {
  try {
    return (await run(command(), args, { maxBuffer: 1 << 28 })).stdout;
  } catch (error) {
    const { stderr, message } = error as { stderr?: string; message: string };
    output.appendLine(stderr || message);
    output.show(true);
    return undefined;
  }
}

/** Converts SDFormat to URDF, and URDF and xacro to SDFormat, into an untitled document. */
async function convert(): Promise<void> {
  const file = await savedFile();
  if (file === undefined) {
    return;
  }
  const isSdf = [".sdf", ".world"].includes(path.extname(file));
  const text = await sdfcheck("convert", isSdf ? "sdf-to-urdf" : "urdf-to-sdf", file);
  if (text !== undefined) {
    const language = isSdf ? "urdf" : "sdformat";
    await vscode.window.showTextDocument(await vscode.workspace.openTextDocument({ content: text, language }));
  }
}

/** Shows the robot beside its text, and again whenever the file is saved. */
async function view(): Promise<void> {
  const file = await savedFile();
  const page = file && (await sdfcheck("view", file));
  if (!file || !page) {
    return;
  }
  const panel = vscode.window.createWebviewPanel(
    "sdfcheck.view",
    path.basename(file),
    { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
    { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
  );
  panel.webview.html = page;
  const saved = vscode.workspace.onDidSaveTextDocument(async (document) => {
    const text = document.fileName === file ? await sdfcheck("view", file) : undefined;
    if (text) {
      panel.webview.html = text;
    }
  });
  panel.onDidDispose(() => saved.dispose());
}

async function graph(): Promise<void> {
  const file = await savedFile();
  const text = file && (await sdfcheck("graph", "joints", file));
  if (text) {
    output.appendLine(text);
    output.show(true);
  }
}

async function fixAll(): Promise<void> {
  await vscode.commands.executeCommand("editor.action.codeAction", {
    kind: "source.fixAll.sdfcheck",
    apply: "first",
  });
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  output = vscode.window.createOutputChannel("sdfcheck");
  status = vscode.window.createStatusBarItem(vscode.StatusBarAlignment.Right, 0);
  status.command = "sdfcheck.output";
  status.text = "$(sync) sdfcheck";
  status.show();
  const restart = async () => {
    await stop();
    await start();
  };
  context.subscriptions.push(
    output,
    status,
    vscode.commands.registerCommand("sdfcheck.restart", restart),
    vscode.commands.registerCommand("sdfcheck.fixAll", fixAll),
    vscode.commands.registerCommand("sdfcheck.convert", convert),
    vscode.commands.registerCommand("sdfcheck.view", view),
    vscode.commands.registerCommand("sdfcheck.graph", graph),
    vscode.commands.registerCommand("sdfcheck.output", () => output.show()),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      if (change.affectsConfiguration("sdfcheck.command")) {
        await restart();
      } else if (change.affectsConfiguration("sdfcheck")) {
        await client?.sendNotification("workspace/didChangeConfiguration", { settings: {} });
      }
    }),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await stop();
}
