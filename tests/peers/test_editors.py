"""Neovim and Emacs themselves, with the configuration of the documentation, use the server."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.peers

PAGE = Path(__file__).parents[2] / "docs" / "editors.md"
MODEL = """\
<sdf version="1.12">
  <model name="m">
    <link name="arm"/>
    <link name="hand"/>
    <joint name="j" type="fixed">
      <parent>arm</parent>
      <child>hnd</child>
    </joint>
    <frame name="f" attached_to="arm"/>
  </model>
</sdf>
"""
WORLD = """\
<sdf version="1.12">
  <world name="w">
    <include>
      <uri>m.sdf</uri>
      <name>m</name>
    </include>
    <frame name="g" attached_to="m::arm"/>
  </world>
</sdf>
"""
XACRO = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="side" value="left"/>
  <link name="${side}_arm"/>
</robot>
"""
ADDRESS = re.compile(r"http://127\.0\.0\.1:\d+/[\w-]{40,}/")
RENAMED = MODEL.replace("hnd", "hand").replace('"arm"', '"upper"').replace(">arm<", ">upper<")
NEOVIM = """\
local out = { offers = {} }
local function await(done)
  return vim.wait(60000, done, 20)
end
local function text()
  return table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), "\\n") .. "\\n"
end
vim.ui.select = function(items, options, choose)
  for _, item in ipairs(items) do
    table.insert(out.offers, (options.format_item(item)))
  end
  choose(items[1], 1)
end
vim.cmd("edit m.sdf")
await(function() return #vim.diagnostic.get(0) > 0 end)
out.diagnostics = {}
for _, found in ipairs(vim.diagnostic.get(0)) do
  table.insert(out.diagnostics, { found.lnum, found.col, found.message })
end
-- Requests that are not as the protocol wants them are answered, too.
for name, context in pairs({ foreign = { diagnostics = vim.diagnostic.get(0) }, nothing = {} }) do
  vim.api.nvim_win_set_cursor(0, { 7, 14 })
  local params = vim.lsp.util.make_range_params(0, "utf-16")
  params.context = context
  local answers = vim.lsp.buf_request_sync(0, "textDocument/codeAction", params, 30000) or {}
  out[name] = 0
  for _, answer in pairs(answers) do
    out[name] = #(answer.result or {})
  end
end
vim.lsp.buf.code_action()
await(function() return text():find("<child>hand") ~= nil end)
await(function() return #vim.diagnostic.get(0) == 0 end)
out.remaining = #vim.diagnostic.get(0)
vim.api.nvim_win_set_cursor(0, { 3, 17 })
vim.lsp.buf.rename("upper")
await(function() return text():find("upper") ~= nil end)
out.model = text()
vim.cmd("silent! wall")
vim.cmd("edit w.sdf")
out.world = text()
local spoken = print
print = function(said) out.address = said end
vim.notify = function(said) out.fault = said end
vim.cmd("Robot")
await(function() return out.address ~= nil end)
print = spoken
vim.cmd("doautocmd CursorHold w.sdf")
vim.cmd("edit r.urdf.xacro")
vim.cmd("RobotExpand")
await(function() return vim.bo.buftype == "nofile" end)
out.expanded, out.language = text(), vim.bo.filetype
vim.cmd("bwipeout!")
vim.cmd("edit m.sdf")
vim.cmd("RobotConvert")
await(function() return vim.bo.buftype == "nofile" end)
out.converted = text()
vim.cmd("bwipeout!")
if vim.lsp.buf.format then
  vim.lsp.buf.format({ timeout_ms = 60000 })
else
  vim.lsp.buf.formatting_sync(nil, 60000)
end
out.formatted = text()
local file = io.open("out.json", "w")
file:write(vim.json.encode(out))
file:close()
vim.cmd("qa!")
"""
EMACS = """\
(require 'json)
(require 'flymake)
(defvar robot nil)
(setq last-nonmenu-event ?x eglot-sync-connect 60 eglot-connect-timeout 60)
(defun await (what)
  (let ((end (+ (float-time) 60)) found)
    (while (and (not (setq found (funcall what))) (< (float-time) end))
      (accept-process-output nil 0.1))
    found))
(defun yes (&rest _) t)
(advice-add 'y-or-n-p :override #'yes)
(find-file "m.sdf")
(call-interactively #'eglot)
(await (lambda () (bound-and-true-p eglot--managed-mode)))
(flymake-start)
(await #'flymake-diagnostics)
(let ((found (mapcar #'flymake-diagnostic-text (flymake-diagnostics))) (offers nil))
  (goto-char (point-min))
  (search-forward "hnd")
  (backward-char 1)
  (cl-letf (((symbol-function 'completing-read)
             (lambda (_ items &rest _) (setq offers (mapcar #'car items)) (car offers))))
    (call-interactively #'eglot-code-actions))
  (eglot--signal-textDocument/didChange)
  (goto-char (point-min))
  (search-forward "\\"arm")
  (backward-char 1)
  (eglot-rename "upper")
  (let ((model (buffer-string)))
    (find-file "w.sdf")
    (cl-letf (((symbol-function 'browse-url) (lambda (address &rest _) (setq robot address))))
      (call-interactively #'sdfcheck-robot))
    (write-region (json-encode `((address . ,robot) (diagnostics . ,(vconcat found)) (offers . ,(vconcat offers))
                                 (model . ,model) (world . ,(buffer-string))))
                  nil "out.json")))
(dolist (buffer (buffer-list)) (with-current-buffer buffer (set-buffer-modified-p nil)))
"""


def documented(heading: str, language: str, number: int = 0) -> str:
    """A configuration that the documentation shows."""
    section = PAGE.read_text(encoding="utf-8").split(f"## {heading}\n")[1].split("\n## ")[0]
    return [match[1] for match in re.finditer(rf"```{language}\n(.*?)```", section, re.DOTALL)][number]


def result(folder: Path, *command: str) -> dict[str, Any]:
    """The notes of a script in an editor about two files in a folder."""
    (folder / "m.sdf").write_text(MODEL)
    (folder / "w.sdf").write_text(WORLD)
    (folder / "r.urdf.xacro").write_text(XACRO)
    (folder / "sdfcheck.toml").touch()
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path, "HOME": str(folder), "XDG_CONFIG_HOME": str(folder)}
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, timeout=240, check=False
    )
    assert (folder / "out.json").exists(), done.stdout + done.stderr
    found: dict[str, Any] = json.loads((folder / "out.json").read_text())
    return found


def test_neovim(tmp_path: Path) -> None:
    neovim = shutil.which("nvim")
    if neovim is None:
        pytest.skip("Neovim is not installed (nvim)")
    lines = subprocess.run([neovim, "--version"], capture_output=True, text=True, check=True).stdout
    version = tuple(map(int, re.findall(r"\d+", lines)[:2]))
    blocks = [documented("Neovim", "lua", 0 if version >= (0, 11) else 1), documented("Neovim", "lua", 2)]
    (tmp_path / "init.lua").write_text("\n".join(blocks))
    (tmp_path / "script.lua").write_text(NEOVIM)
    found = result(tmp_path, neovim, "--headless", "-u", "init.lua", "-i", "NONE", "-n", "-S", "script.lua")
    ((line, column, message),) = found["diagnostics"]
    assert (line, column) == (6, 13)
    assert "hnd" in message
    assert len(found["offers"]) == found["foreign"] == found["nothing"] == 2
    assert found["remaining"] == 0
    assert found["model"] == RENAMED
    assert found["world"] == WORLD.replace("arm", "upper")
    assert ADDRESS.fullmatch(found["address"])
    assert "fault" not in found
    assert '<link name="left_arm"/>' in found["expanded"]
    assert found["language"] == "xml"
    assert '<robot name="m">' in found["converted"]
    assert found["formatted"] == f'<?xml version="1.0"?>\n{RENAMED}'


def test_emacs(tmp_path: Path) -> None:
    emacs = shutil.which("emacs")
    if emacs is None:
        pytest.skip("Emacs is not installed (emacs)")
    has_eglot = subprocess.run(
        [emacs, "--batch", "--eval", "(require 'eglot)"], capture_output=True, check=False
    )
    if has_eglot.returncode:
        pytest.skip("Emacs has no eglot (29, or Debian's elpa-eglot)")
    (tmp_path / "init.el").write_text(documented("Emacs", "elisp") + documented("Emacs", "elisp", 1))
    (tmp_path / "script.el").write_text(EMACS)
    found = result(tmp_path, emacs, "-q", "--batch", "-l", "eglot", "-l", "init.el", "-l", "script.el")
    (message,) = found["diagnostics"]
    assert "hnd" in message
    assert len(found["offers"]) == 2
    assert found["model"] == RENAMED
    assert found["world"] == WORLD.replace("arm", "upper")
    assert ADDRESS.fullmatch(found["address"])
