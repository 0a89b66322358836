// The language server, and questions to it.

import * as vscode from "vscode";
import {
  ExecuteCommandRequest,
  type FeatureState,
  LanguageClient,
  type LanguageClientOptions,
  type Location,
  type StaticFeature,
} from "vscode-languageclient/node";

export const REFERENCES = "sdfcheck.references";
export const LANGUAGES = ["sdformat", "urdf", "srdf"];

/** Tells the server which commands the editor has. */
const commands: StaticFeature = {
  fillClientCapabilities: (able) => {
    able.experimental = { ...(able.experimental as object | undefined), commands: [REFERENCES] };
  },
  initialize: () => {},
  getState: (): FeatureState => ({ kind: "static" }),
  clear: () => {},
};

export function makeClient(command: string, output: vscode.OutputChannel): LanguageClient {
  const options: LanguageClientOptions = {
    documentSelector: [
      ...LANGUAGES.flatMap((language) => ["file", "untitled"].map((scheme) => ({ scheme, language }))),
      { scheme: "file", language: "xml", pattern: "**/*.{sdf,world,urdf,xacro,srdf}" },
      { scheme: "file", pattern: "**/model.config" },
    ],
    initializationOptions: vscode.workspace.getConfiguration("sdfcheck"),
    outputChannel: output,
  };
  const client = new LanguageClient("sdfcheck", "sdfcheck", { command, args: ["server"] }, options);
  client.registerFeature(commands);
  return client;
}

/** Asks the server to do something about a document. */
export async function ask<T>(
  client: LanguageClient,
  command: string,
  uri: vscode.Uri,
  given: Record<string, unknown> = {},
): Promise<T> {
  const about = { uri: client.code2ProtocolConverter.asUri(uri), ...given };
  return (await client.sendRequest(ExecuteCommandRequest.type, { command, arguments: [about] })) as T;
}

/** Opens a place beside the view that leads there: where its text is visible, else in the first column. */
export async function reveal(client: LanguageClient, place: Location): Promise<void> {
  const { uri, range } = client.protocol2CodeConverter.asLocation(place);
  const visible = vscode.window.visibleTextEditors.find((editor) => String(editor.document.uri) === String(uri));
  await vscode.window.showTextDocument(uri, {
    selection: range,
    viewColumn: visible?.viewColumn ?? vscode.ViewColumn.One,
  });
}
