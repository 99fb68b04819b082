"""A strict reader of HTML for tests: balanced tags, unique ids, and nothing from anywhere else
but pictures that are part of the page."""

from __future__ import annotations

import json
from html.parser import HTMLParser

VOID = {"meta", "link", "br", "hr", "img", "input"}


class Page(HTMLParser):
    """What a page says: ``text`` outside scripts and styles, ``ids``, ``scripts`` and ``data``."""

    def __init__(self, source: str):
        super().__init__(convert_charrefs=True)
        self.open: list[str] = []
        self.ids: list[str] = []
        self.scripts: list[str] = []
        self.words: list[str] = []
        self.rows: list[list[str]] = []
        self.feed(source)
        self.close()
        assert self.open == [], f"left open: {self.open}"
        assert len(self.ids) == len(set(self.ids)), "an id twice"

    @property
    def text(self) -> str:
        """Everything a reader sees, white space joined."""
        return " ".join(" ".join(self.words).split())

    @property
    def data(self) -> dict:
        """What the charts are drawn from."""
        (found,) = [text for text in self.scripts if text.startswith('{"charts"')]
        return json.loads(found, parse_constant=lambda token: 1 / 0)

    def handle_starttag(self, tag, attrs):
        names = [name for name, _ in attrs]
        assert len(names) == len(set(names)), f"an attribute twice in {tag}"
        self.ids += [value for name, value in attrs if name == "id"]
        leading = [(name, value) for name, value in attrs if name in ("src", "href", "action", "srcset")]
        outside = [one for one in leading if not one[1].startswith("data:image/png;base64,")]
        assert outside == [], f"{tag} loads or leads to {outside}"
        assert not any(name.startswith("on") for name in names), f"{tag} carries script"
        if tag not in VOID:
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-1:]}"
        self.open.pop()

    def handle_data(self, text):
        if "script" in self.open:
            self.scripts.append(text)
        elif "style" not in self.open:
            self.words.append(text)
            if {"td", "th"} & set(self.open):
                self.rows[-1][-1] += text

    def handle_comment(self, text):
        raise AssertionError(f"a comment: {text}")
