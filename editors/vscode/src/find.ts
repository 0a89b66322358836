// Where the program is: what the settings say, else the environments of the workspace, else the path.

import { existsSync } from "fs";
import * as path from "path";

/** What the search goes by. */
export interface Around {
  /** The setting `sdfcheck.command`; empty to search. */
  command: string;
  folders: string[];
  /** The setting `python.defaultInterpreterPath`. */
  interpreter: string;
  /** Programs of the workspace are run only where its author is trusted. */
  isTrusted: boolean;
  environment: Record<string, string | undefined>;
  platform: string;
}

export interface Found {
  /** What to run; undefined where there is nothing. */
  command: string | undefined;
  /** Where it was looked for, for people. */
  tried: string[];
}

const ENVIRONMENTS = [".venv", "venv", ".pixi/envs/default", ".conda"];

export function find(around: Around, exists: (file: string) => boolean = existsSync): Found {
  const { command, folders, platform } = around;
  if (command) return { command: absolute(command, folders, exists), tried: [command] };
  const tried: string[] = [];
  for (const folder of places(around)) {
    const file = path.join(folder, platform === "win32" ? "sdfcheck.exe" : "sdfcheck");
    if (exists(file)) return { command: file, tried };
    tried.push(folder);
  }
  return { command: undefined, tried };
}

/** The folders of programs, in the order in which they count. */
function places(around: Around): string[] {
  const { folders, interpreter, environment, platform } = around;
  const bins = platform === "win32" ? ["Scripts", "bin"] : ["bin"];
  const found: string[] = [];
  if (around.isTrusted) {
    const given = interpreter.replace("${workspaceFolder}", folders[0] ?? "");
    if (path.isAbsolute(given)) found.push(path.dirname(given));
    else if (given.includes("/")) found.push(...folders.map((folder) => path.dirname(path.join(folder, given))));
    for (const folder of folders)
      for (const name of ENVIRONMENTS) for (const bin of bins) found.push(path.join(folder, name, bin));
  }
  for (const name of ["VIRTUAL_ENV", "CONDA_PREFIX"]) {
    const folder = environment[name];
    if (folder) for (const bin of bins) found.push(path.join(folder, bin));
  }
  found.push(...(environment.PATH ?? "").split(path.delimiter).filter((each) => path.isAbsolute(each)));
  return [...new Set(found)];
}

/** The setting as a path: relative ones are in the first folder that has them; a bare name is looked up by the system. */
function absolute(command: string, folders: string[], exists: (file: string) => boolean): string {
  const home = process.env.HOME ?? process.env.USERPROFILE ?? "";
  const given = command.replace(/^~(?=[/\\])/, home).replace("${workspaceFolder}", folders[0] ?? "");
  if (path.isAbsolute(given) || !/[/\\]/.test(given)) return given;
  return folders.map((folder) => path.join(folder, given)).find(exists) ?? given;
}
