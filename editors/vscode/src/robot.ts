// The robot beside its text: a panel with the page of the server, and the messages between the two.

import * as path from "path";
import * as vscode from "vscode";
import type { LanguageClient, Location } from "vscode-languageclient/node";
import { ask, reveal } from "./server";

/** The notification with what is for a page. */
export const NEWS = "sdfcheck/robot";
const PAUSE = 60; // ms between a move of the cursor and its mark

export class Robots implements vscode.Disposable {
  private readonly panels = new Map<string, { uri: vscode.Uri; panel: vscode.WebviewPanel }>();
  private readonly watched: vscode.Disposable;
  private timer: NodeJS.Timeout | undefined;

  constructor(private readonly client: () => LanguageClient | undefined) {
    this.watched = vscode.window.onDidChangeTextEditorSelection((change) => this.moved(change));
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.watched.dispose();
    for (const { panel } of [...this.panels.values()]) panel.dispose();
  }

  /** Takes what a server sends, and shows again what was shown before it started. */
  async connect(client: LanguageClient): Promise<void> {
    client.onNotification(NEWS, ({ uri, message }: { uri: string; message: unknown }) => {
      const key = String(client.protocol2CodeConverter.asUri(uri));
      void this.panels.get(key)?.panel.webview.postMessage(message);
    });
    for (const { uri, panel } of this.panels.values()) await this.fill(client, uri, panel);
  }

  /** Shows the robot of a document. */
  async show(uri: vscode.Uri): Promise<void> {
    const client = this.client();
    if (!client) return;
    const known = this.panels.get(String(uri));
    if (known) {
      known.panel.reveal(undefined, true);
      return;
    }
    const panel = vscode.window.createWebviewPanel(
      "sdfcheck.view",
      path.basename(uri.path),
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
    );
    this.panels.set(String(uri), { uri, panel });
    panel.onDidDispose(() => this.panels.delete(String(uri)));
    panel.webview.onDidReceiveMessage((message: unknown) => this.said(uri, message));
    await this.fill(client, uri, panel);
  }

  private async fill(client: LanguageClient, uri: vscode.Uri, panel: vscode.WebviewPanel): Promise<void> {
    panel.webview.html = (await ask<{ html: string }>(client, "sdfcheck.robotPage", uri)).html;
  }

  /** A message of the page; the server answers with the place to which it leads. */
  private async said(uri: vscode.Uri, message: unknown): Promise<void> {
    const client = this.client();
    const place = client && (await ask<Location | null>(client, "sdfcheck.robotSay", uri, { message }));
    if (client && place) await reveal(client, place);
  }

  private moved(change: vscode.TextEditorSelectionChangeEvent): void {
    if (!this.panels.size) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      const client = this.client();
      const { line, character } = change.selections[0].active;
      const position = { line, character };
      if (client) void ask(client, "sdfcheck.cursor", change.textEditor.document.uri, { position });
    }, PAUSE);
  }
}
