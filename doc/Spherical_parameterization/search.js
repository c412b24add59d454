// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
// The search of the manual, without a server: takes the place of doxygen's search/search.js, with the names that its pages use.

class SearchBox {
  DOMSearchField() { return document.getElementById("MSearchField"); }
  OnSearchFieldFocus(isActive)
  {
    const field = this.DOMSearchField();
    if(isActive && field.value === field.defaultValue)
      field.value = "";
  }
}

const searchedFor = new URLSearchParams(location.search).get("query")?.trim() ?? "";

// pages.js calls this with [link, title of the page, text] of every section.
function searchPages(sections)
{
  const words = searchedFor.toLowerCase().split(/\s+/);
  const found = [];
  for(const [link, title, text] of sections) {
    const inText = text.toLowerCase(), inTitle = title.toLowerCase(), start = inText.slice(0, 80);
    if(!words.every((word) => inText.includes(word) || inTitle.includes(word)))
      continue;
    let score = 0;
    for(const word of words)
      score += 20 * inTitle.includes(word) + 10 * start.includes(word) + Math.min(inText.split(word).length - 1, 9);
    found.push({link, title, text, score, place: text.lastIndexOf(" ", Math.max(0, inText.indexOf(words[0]) - 80)) + 1});
  }
  found.sort((a, b) => b.score - a.score);

  const results = document.getElementById("searchresults");
  const add = (parent, tag, text) => {
    const element = parent.appendChild(document.createElement(tag));
    element.textContent = text;
    return element;
  };
  add(results, "p", `${found.length} sections with “${searchedFor}”` + (found.length > 100 ? ", of which 100 are shown:" : ":"));
  const separator = new RegExp(`(${words.map((word) => word.replace(/[^\w\s]/g, "\\$&")).join("|")})`, "gi");
  for(const {link, title, text, place} of found.slice(0, 100)) {
    const result = add(results, "p", "");
    add(result, "a", title).href = link;
    add(result, "br", "");
    text.slice(place, place + 240).split(separator).forEach((part, i) => add(result, i % 2 ? "mark" : "span", part));
  }
}

document.addEventListener("DOMContentLoaded", () => {
  if(!document.getElementById("searchresults") || !searchedFor)
    return;
  document.head.appendChild(document.createElement("script")).src = "search/pages.js";
});
