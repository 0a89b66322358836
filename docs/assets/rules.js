// A field above the tables of rules: rows that do not contain all of its words, as beginnings of words, are hidden, and tables without rows.
document.addEventListener("DOMContentLoaded", () => {
  const title = document.querySelector("article h1");
  if (title === null || !title.textContent.startsWith("Rules") || document.querySelectorAll("article table").length < 5) {
    return;
  }
  const field = Object.assign(document.createElement("input"), {
    type: "search",
    placeholder: "Filter: code, name, family, severity, fix, words",
    className: "rule-filter",
  });
  field.setAttribute("aria-label", "Filter the rules");
  const count = Object.assign(document.createElement("p"), { className: "rule-count" });
  count.setAttribute("aria-live", "polite");
  title.after(field, count);

  // The heading, the sentence and the table of a family belong together.
  const families = [];
  for (const table of document.querySelectorAll("article table")) {
    const parts = [];
    let at = table.closest(".md-typeset__scrollwrap") ?? table;
    while (at !== null && at.tagName !== "H2") {
      parts.push(at);
      at = at.previousElementSibling;
    }
    families.push({ heading: at, parts, rows: [...table.tBodies[0].rows] });
  }

  const plain = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, " ");

  function filter() {
    const words = plain(field.value).split(" ").filter(Boolean);
    let shown = 0;
    for (const { heading, parts, rows } of families) {
      let any = false;
      for (const row of rows) {
        // "safe" is not to find "unsafe".
        const text = ` ${[...row.cells].map((cell) => plain(cell.textContent)).join(" ")}`;
        row.hidden = !words.every((word) => text.includes(` ${word}`));
        any ||= !row.hidden;
        shown += row.hidden ? 0 : 1;
      }
      for (const part of [heading, ...parts]) {
        if (part !== null) {
          part.hidden = !any;
        }
      }
    }
    count.textContent = shown === 1 ? "1 rule" : `${shown} rules`;
    const address = new URL(location.href);
    words.length > 0 ? address.searchParams.set("filter", field.value) : address.searchParams.delete("filter");
    history.replaceState(null, "", address);
  }

  field.value = new URLSearchParams(location.search).get("filter") ?? "";
  field.addEventListener("input", filter);
  filter();
});
