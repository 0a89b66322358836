// Conversions into new documents, with what they lose.

import * as vscode from "vscode";
import type { Diagnostic, LanguageClient } from "vscode-languageclient/node";
import { ask } from "./server";

interface Converted {
  text: string;
  language: string;
  verified: boolean;
  verdict: string;
  losses: { uri: string; diagnostic: Diagnostic }[];
}

export class Conversions implements vscode.Disposable {
  private readonly losses = vscode.languages.createDiagnosticCollection("sdfcheck: losses");

  dispose(): void {
    this.losses.dispose();
  }

  /** Converts a document, shows the result beside it and its losses as problems of the source. */
  async convert(client: LanguageClient, uri: vscode.Uri, to?: string): Promise<void> {
    const done = await ask<Converted>(client, "sdfcheck.convert", uri, to ? { to } : {});
    this.losses.clear();
    const all = new Map<string, Diagnostic[]>();
    for (const { uri: at, diagnostic } of done.losses) all.set(at, [...(all.get(at) ?? []), diagnostic]);
    for (const [at, found] of all)
      this.losses.set(
        client.protocol2CodeConverter.asUri(at),
        await client.protocol2CodeConverter.asDiagnostics(found),
      );
    const document = await vscode.workspace.openTextDocument({ content: done.text, language: done.language });
    await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside });
    const count = done.losses.length;
    const lost = count ? `; ${count} ${count === 1 ? "loss is" : "losses are"} listed under Problems` : "";
    const text = `${done.verified ? `Verified: ${done.verdict}` : "Not verified"}${lost}.`;
    void (done.verified && !count ? vscode.window.showInformationMessage(text) : vscode.window.showWarningMessage(text));
  }
}
