// The expanded text beside its source: a document that cannot be edited, in which each element leads back.

import * as vscode from "vscode";
import type { LanguageClient, Location } from "vscode-languageclient/node";
import { ask } from "./server";

export const SCHEME = "sdfcheck-expanded";

interface Expanded {
  text: string;
  language: string;
  places: { first: number; last: number; location: Location }[];
}

export class ExpandedTexts
  implements vscode.TextDocumentContentProvider, vscode.DocumentLinkProvider, vscode.DefinitionProvider, vscode.Disposable
{
  private readonly changes = new vscode.EventEmitter<vscode.Uri>();
  private readonly known = new Map<string, Expanded>();
  private readonly parts: vscode.Disposable[];
  private timer: NodeJS.Timeout | undefined;
  readonly onDidChange = this.changes.event;

  constructor(private readonly client: () => LanguageClient | undefined) {
    this.parts = [
      this.changes,
      vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
      vscode.languages.registerDocumentLinkProvider({ scheme: SCHEME }, this),
      vscode.languages.registerDefinitionProvider({ scheme: SCHEME }, this),
      vscode.workspace.onDidChangeTextDocument(({ document }) => this.later(document.uri)),
    ];
  }

  dispose(): void {
    clearTimeout(this.timer);
    for (const part of this.parts) part.dispose();
  }

  /** Shows what a document expands to; throws with the reason where it cannot be. */
  async show(source: vscode.Uri): Promise<void> {
    const uri = source.with({ scheme: SCHEME, query: String(source) });
    await this.read(uri);
    const document = await vscode.workspace.openTextDocument(uri);
    const language = this.known.get(String(uri))?.language ?? "xml";
    await vscode.languages.setTextDocumentLanguage(document, language);
    await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside, preview: true });
  }

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.known.get(String(uri))?.text ?? "";
  }

  /** The name of each element leads to where it was written. */
  provideDocumentLinks(document: vscode.TextDocument): vscode.DocumentLink[] {
    const found = this.known.get(String(document.uri));
    const client = this.client();
    if (!found || !client || document.getText() !== found.text) return [];
    const links: vscode.DocumentLink[] = [];
    const starts = elementStarts(found.text);
    for (const [number, { location }] of found.places.entries()) {
      const start = starts[number];
      if (!start) continue;
      const { line, character } = location.range.start;
      const target = client.protocol2CodeConverter.asUri(location.uri).with({ fragment: `L${line + 1},${character + 1}` });
      const range = new vscode.Range(start.line, start.from, start.line, start.to);
      links.push(new vscode.DocumentLink(range, target));
    }
    return links;
  }

  /** The innermost element around a place, where it was written. */
  provideDefinition(document: vscode.TextDocument, position: vscode.Position): vscode.Location | undefined {
    const client = this.client();
    const places = this.known.get(String(document.uri))?.places ?? [];
    const around = places.filter(({ first, last }) => first <= position.line && position.line <= last);
    const inner = around.sort((a, b) => a.last - a.first - (b.last - b.first))[0];
    return inner && client?.protocol2CodeConverter.asLocation(inner.location);
  }

  private async read(uri: vscode.Uri): Promise<void> {
    const client = this.client();
    if (!client) throw new Error("the server does not run");
    this.known.set(String(uri), await ask<Expanded>(client, "sdfcheck.expand", vscode.Uri.parse(uri.query)));
    this.changes.fire(uri);
  }

  /** Expands again what is shown, soon after a text has changed. */
  private later(changed: vscode.Uri): void {
    if (changed.scheme === SCHEME || !this.known.size) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      for (const document of vscode.workspace.textDocuments)
        if (document.uri.scheme === SCHEME) this.read(document.uri).catch(() => undefined); // the last one stays
    }, 300);
  }
}

/** The names of the start tags of a text, in order. */
function elementStarts(text: string): { line: number; from: number; to: number }[] {
  const found: { line: number; from: number; to: number }[] = [];
  const markup = /<!--[\s\S]*?-->|<!\[CDATA\[[\s\S]*?\]\]>|<[?!/][^>]*>|<([^\s/<>!?"']+)(?:[^<>"']|"[^"]*"|'[^']*')*>/g;
  let line = 0;
  let begin = 0;
  let at = 0;
  for (const match of text.matchAll(markup)) {
    for (let end = text.indexOf("\n", at); end >= 0 && end < match.index; end = text.indexOf("\n", at)) {
      line++;
      begin = at = end + 1;
    }
    const from = match.index - begin + 1;
    if (match[1]) found.push({ line, from, to: from + match[1].length });
  }
  return found;
}
