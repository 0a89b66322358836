// The editor, as far as the extension uses it: each part has the type of the published API, and notes what is done.

import type * as api from "vscode";

/** What happened, and what the editor answers. */
export const editor = {
  commands: new Map<string, (...given: unknown[]) => unknown>(),
  executed: [] as unknown[][],
  messages: [] as string[],
  answer: undefined as string | undefined,
  lines: [] as string[],
  status: {} as { text: string },
  settings: new Map<string, unknown>(),
  documents: [] as api.TextDocument[],
  shown: [] as { document: string; options: unknown }[],
  panels: [] as Panel[],
  problems: new Map<string, readonly api.Diagnostic[]>(),
  providers: {} as {
    content?: api.TextDocumentContentProvider;
    links?: api.DocumentLinkProvider;
    definition?: api.DefinitionProvider;
  },
};

type Listener<T> = (event: T) => unknown;

export class EventEmitter<T> {
  private readonly listeners = new Set<Listener<T>>();
  readonly event: api.Event<T> = (listener) => {
    this.listeners.add(listener);
    return { dispose: () => this.listeners.delete(listener) };
  };
  fire(event: T): void {
    for (const listener of this.listeners) listener(event);
  }
  dispose(): void {
    this.listeners.clear();
  }
}

export const events = {
  selection: new EventEmitter<api.TextEditorSelectionChangeEvent>(),
  text: new EventEmitter<api.TextDocumentChangeEvent>(),
  configuration: new EventEmitter<api.ConfigurationChangeEvent>(),
  trust: new EventEmitter<void>(),
};

type Parts = { scheme: string; authority: string; path: string; query: string; fragment: string };

export class Uri implements Parts {
  private constructor(
    readonly scheme: string,
    readonly authority: string,
    readonly path: string,
    readonly query: string,
    readonly fragment: string,
  ) {}
  static parse(text: string): Uri {
    const [, scheme, authority, path, query, fragment] =
      /^([\w-]+):(?:\/\/([^/?#]*))?([^?#]*)(?:\?([^#]*))?(?:#(.*))?$/.exec(text) ?? [];
    return new Uri(scheme, authority ?? "", path, decodeURIComponent(query ?? ""), fragment ?? "");
  }
  static file(path: string): Uri {
    return new Uri("file", "", path, "", "");
  }
  get fsPath(): string {
    return this.path;
  }
  with(change: Partial<Parts>): Uri {
    const { scheme, authority, path, query, fragment } = { ...this, ...change } as Parts;
    return new Uri(scheme, authority, path, query, fragment);
  }
  toString(): string {
    const query = this.query ? `?${encodeURIComponent(this.query)}` : "";
    return `${this.scheme}://${this.authority}${this.path}${query}${this.fragment ? `#${this.fragment}` : ""}`;
  }
  toJSON(): string {
    return this.toString();
  }
}

export class Position {
  constructor(
    readonly line: number,
    readonly character: number,
  ) {}
}

export class Range {
  readonly start: Position;
  readonly end: Position;
  constructor(line: number, from: number, last: number, to: number) {
    this.start = new Position(line, from);
    this.end = new Position(last, to);
  }
}

export class DocumentLink {
  constructor(
    readonly range: Range,
    readonly target?: Uri,
  ) {}
}

export enum ViewColumn {
  Beside = -2,
  One = 1,
}

export enum StatusBarAlignment {
  Left = 1,
  Right = 2,
}

/** A document with a text; enough of one for the extension. */
export function documentOf(uri: Uri, languageId: string, text = ""): api.TextDocument {
  const found: Partial<api.TextDocument> = {
    uri: uri as unknown as api.Uri,
    languageId,
    getText: () => text,
    save: () => Promise.resolve(true),
  };
  editor.documents.push(found as api.TextDocument);
  return found as api.TextDocument;
}

export class Panel {
  readonly posted: unknown[] = [];
  readonly received = new EventEmitter<unknown>();
  readonly closed = new EventEmitter<void>();
  revealed = 0;
  readonly webview = {
    html: "",
    postMessage: (message: unknown) => {
      this.posted.push(message);
      return Promise.resolve(true);
    },
    onDidReceiveMessage: this.received.event,
  };
  readonly onDidDispose = this.closed.event;
  constructor(
    readonly title: string,
    readonly options: unknown,
  ) {}
  reveal(): void {
    this.revealed++;
  }
  dispose(): void {
    this.closed.fire();
  }
}

const say = (message: string): Promise<undefined> => {
  editor.messages.push(message);
  return Promise.resolve(editor.answer as undefined);
};

export const window = {
  activeTextEditor: undefined as api.TextEditor | undefined,
  visibleTextEditors: [] as api.TextEditor[],
  createOutputChannel: (() => ({
    appendLine: (line: string) => editor.lines.push(line),
    show: () => editor.executed.push(["output"]),
    dispose: () => {},
  })) as unknown as typeof api.window.createOutputChannel,
  createStatusBarItem: (() =>
    Object.assign(editor.status, { show: () => {}, dispose: () => {} })) as unknown as typeof api.window.createStatusBarItem,
  showErrorMessage: say as typeof api.window.showErrorMessage,
  showInformationMessage: say as typeof api.window.showInformationMessage,
  showWarningMessage: say as typeof api.window.showWarningMessage,
  showTextDocument: ((document: api.TextDocument | Uri, options: unknown) => {
    editor.shown.push({ document: String("uri" in document ? document.uri : document), options });
    return Promise.resolve();
  }) as unknown as typeof api.window.showTextDocument,
  createWebviewPanel: ((_: string, title: string, __: unknown, options: unknown) => {
    const panel = new Panel(title, options);
    editor.panels.push(panel);
    return panel;
  }) as unknown as typeof api.window.createWebviewPanel,
  onDidChangeTextEditorSelection: events.selection.event,
};

export const workspace = {
  isTrusted: true,
  workspaceFolders: undefined as readonly api.WorkspaceFolder[] | undefined,
  textDocuments: editor.documents,
  getConfiguration: ((section: string) => ({
    get: (name: string) => editor.settings.get(`${section}.${name}`),
  })) as unknown as typeof api.workspace.getConfiguration,
  openTextDocument: ((given: Uri | { content: string; language: string }) => {
    if ("content" in given) return Promise.resolve(documentOf(Uri.parse("untitled:1"), given.language, given.content));
    const known = editor.documents.find((each) => String(each.uri) === String(given));
    const text = String(editor.providers.content?.provideTextDocumentContent(given as unknown as api.Uri, NEVER) ?? "");
    return Promise.resolve(known ?? documentOf(given, "plaintext", text));
  }) as unknown as typeof api.workspace.openTextDocument,
  registerTextDocumentContentProvider: ((_: string, provider: api.TextDocumentContentProvider) => {
    editor.providers.content = provider;
    return { dispose: () => {} };
  }) as typeof api.workspace.registerTextDocumentContentProvider,
  onDidChangeTextDocument: events.text.event,
  onDidChangeConfiguration: events.configuration.event,
  onDidGrantWorkspaceTrust: events.trust.event,
};

export const NEVER = { isCancellationRequested: false } as api.CancellationToken;

export const languages = {
  createDiagnosticCollection: (() => ({
    clear: () => editor.problems.clear(),
    set: (uri: Uri, found: readonly api.Diagnostic[]) => editor.problems.set(String(uri), found),
    dispose: () => {},
  })) as unknown as typeof api.languages.createDiagnosticCollection,
  registerDocumentLinkProvider: ((_: api.DocumentSelector, provider: api.DocumentLinkProvider) => {
    editor.providers.links = provider;
    return { dispose: () => {} };
  }) as typeof api.languages.registerDocumentLinkProvider,
  registerDefinitionProvider: ((_: api.DocumentSelector, provider: api.DefinitionProvider) => {
    editor.providers.definition = provider;
    return { dispose: () => {} };
  }) as typeof api.languages.registerDefinitionProvider,
  setTextDocumentLanguage: ((document: api.TextDocument) =>
    Promise.resolve(document)) as typeof api.languages.setTextDocumentLanguage,
};

export const commands = {
  registerCommand: ((name: string, work: (...given: unknown[]) => unknown) => {
    if (editor.commands.has(name)) throw new Error(`command '${name}' already exists`);
    editor.commands.set(name, work);
    return { dispose: () => editor.commands.delete(name) };
  }) as typeof api.commands.registerCommand,
  executeCommand: ((...given: unknown[]) => {
    editor.executed.push(given);
    return Promise.resolve();
  }) as typeof api.commands.executeCommand,
};
