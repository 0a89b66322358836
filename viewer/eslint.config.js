import js from "@eslint/js";
import { defineConfig } from "eslint/config";
import ts from "typescript-eslint";

export default defineConfig(js.configs.recommended, ts.configs.recommended, ts.configs.stylistic, {
  // Control characters are looked for on purpose.
  rules: { "no-control-regex": "off", eqeqeq: "error", "no-console": "error", "@typescript-eslint/no-empty-function": "off" },
});
