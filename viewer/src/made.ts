// Elements from text: names of a description never become markup.

type Tag = keyof HTMLElementTagNameMap;

/** An element with attributes, and with texts and elements in it. */
export function made<K extends Tag>(
  tag: K, attributes: Record<string, string> = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** A text in which `words` between backticks are code. */
export function prose(text: string): (Node | string)[] {
  return text.split(/`([^`]*)`/).map((piece, at) => (at % 2 ? made("code", {}, piece) : piece));
}

/** A path that may be broken after each folder. */
export function path(text: string): (Node | string)[] {
  return text.split(/(?<=\/)/).flatMap((piece, at) => (at ? [made("wbr"), piece] : [piece]));
}

/** `1 file`, `2 files`. */
export function counted(number: number, noun: string): string {
  return `${number.toLocaleString("en")} ${noun}${number === 1 ? "" : "s"}`;
}
