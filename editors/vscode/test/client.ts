// The language client, without a server: it notes what it is asked for, and gives the answers of a test.

import type * as real from "vscode-languageclient/node";
import { Position, Range, Uri } from "./vscode";

export enum State {
  Stopped = 1,
  Starting = 3,
  Running = 2,
}

export const ExecuteCommandRequest = { type: "workspace/executeCommand" };

type Asked = { command: string; arguments: Record<string, unknown>[] };

/** For tests: what the server is like. */
export const server = {
  made: [] as LanguageClient[],
  asked: [] as Asked[],
  answers: new Map<string, unknown>(),
  fails: "",
};

export class LanguageClient {
  readonly notifications = new Map<string, (given: unknown) => void>();
  readonly sent: unknown[][] = [];
  private running = false;
  private listener: (change: { newState: State }) => void = () => {};
  readonly features: real.StaticFeature[] = [];

  constructor(
    readonly id: string,
    readonly name: string,
    readonly options: { command: string; args: string[] },
    readonly settings: real.LanguageClientOptions,
  ) {
    server.made.push(this);
  }
  registerFeature(feature: real.StaticFeature): void {
    this.features.push(feature);
  }
  onDidChangeState(listener: (change: { newState: State }) => void): void {
    this.listener = listener;
  }
  async start(): Promise<void> {
    if (server.fails) throw new Error(server.fails);
    this.running = true;
    this.listener({ newState: State.Running });
  }
  async stop(): Promise<void> {
    this.running = false;
  }
  isRunning(): boolean {
    return this.running;
  }
  onNotification(method: string, take: (given: unknown) => void): void {
    this.notifications.set(method, take);
  }
  async sendNotification(...given: unknown[]): Promise<void> {
    this.sent.push(given);
  }
  async sendRequest(_: unknown, asked: Asked): Promise<unknown> {
    server.asked.push(asked);
    const answer = server.answers.get(asked.command);
    if (answer instanceof Error) throw answer;
    return answer;
  }
  readonly code2ProtocolConverter = { asUri: (uri: Uri) => String(uri) };
  readonly protocol2CodeConverter = {
    asUri: (uri: string) => Uri.parse(uri),
    asPosition: ({ line, character }: real.Position) => new Position(line, character),
    asLocation: ({ uri, range }: real.Location) => ({
      uri: Uri.parse(uri),
      range: new Range(range.start.line, range.start.character, range.end.line, range.end.character),
    }),
    asDiagnostics: async (found: unknown[]) => found,
  };
}
