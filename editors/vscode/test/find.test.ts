import assert from "node:assert/strict";
import { test } from "node:test";
import { type Around, find } from "../src/find";

const AROUND: Around = {
  command: "",
  folders: ["/robots", "/other"],
  interpreter: "",
  isTrusted: true,
  environment: { PATH: "/usr/bin:relative:/bin", CONDA_PREFIX: "/conda" },
  platform: "linux",
};

/** The program that is found where only one is there. */
const only = (file: string, around: Partial<Around> = {}): string | undefined =>
  find({ ...AROUND, ...around }, (each) => each === file).command;

test("the environments of the workspace come before the path", () => {
  for (const place of [".venv/bin", "venv/bin", ".pixi/envs/default/bin", ".conda/bin"])
    for (const folder of AROUND.folders)
      assert.equal(only(`${folder}/${place}/sdfcheck`), `${folder}/${place}/sdfcheck`);
  const all = find(AROUND, () => true);
  assert.equal(all.command, "/robots/.venv/bin/sdfcheck");
  assert.equal(only("/usr/bin/sdfcheck"), "/usr/bin/sdfcheck");
  assert.equal(only("/conda/bin/sdfcheck"), "/conda/bin/sdfcheck");
});

test("the interpreter of Python comes first", () => {
  const around = { interpreter: "/env/bin/python" };
  assert.equal(find({ ...AROUND, ...around }, () => true).command, "/env/bin/sdfcheck");
  assert.equal(only("/other/env/bin/sdfcheck", { interpreter: "env/bin/python" }), "/other/env/bin/sdfcheck");
  assert.equal(
    only("/robots/e/bin/sdfcheck", { interpreter: "${workspaceFolder}/e/bin/python" }),
    "/robots/e/bin/sdfcheck",
  );
});

test("nothing of a workspace is run that is not trusted", () => {
  const around = { isTrusted: false, interpreter: "/env/bin/python" };
  assert.equal(find({ ...AROUND, ...around }, (file) => !file.startsWith("/usr")).command, "/conda/bin/sdfcheck");
  assert.equal(only("/robots/.venv/bin/sdfcheck", around), undefined);
});

test("the setting counts alone", () => {
  assert.equal(only("/robots/.venv/bin/sdfcheck", { command: "sdfcheck-dev" }), "sdfcheck-dev");
  assert.equal(only("/other/tools/sdfcheck", { command: "tools/sdfcheck" }), "/other/tools/sdfcheck");
  assert.equal(only("", { command: "${workspaceFolder}/x" }), "/robots/x");
});

test("where nothing is found, it says where it looked", () => {
  const { command, tried } = find(AROUND, () => false);
  assert.equal(command, undefined);
  assert.ok(tried.includes("/robots/.venv/bin"));
  assert.ok(tried.includes("/usr/bin"));
  assert.ok(!tried.includes("relative"));
});

test("Windows has other names", () => {
  const around = { platform: "win32", environment: {} };
  assert.equal(only("/robots/.venv/Scripts/sdfcheck.exe", around), "/robots/.venv/Scripts/sdfcheck.exe");
});
