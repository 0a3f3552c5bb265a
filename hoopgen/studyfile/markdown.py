"""Markdown of others as HTML of a page: none of their own, and nothing that a page would fetch."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from hoopgen.installed import need
from hoopgen.printable import printable

__all__ = ["check_markdown", "rendered"]

_BELOW = 2
"""Levels: a page has one title, and its questions' titles are the next."""

_DEEPEST = 6


def check_markdown() -> Any:
    """Return what reads Markdown.

    Raises
    ------
    ImportError
        If markdown-it-py is missing: what brings it.
    """
    return need("markdown_it", "a report page")


def rendered(text: str) -> str:
    """Return Markdown (CommonMark, and tables) as HTML.

    HTML in it is text, and of a picture, which a page that is one file has not, the words that
    stand for it. Links lead nowhere but to addresses of the web and of mail, and to files.
    """
    markdown = check_markdown().MarkdownIt("commonmark", {"html": False}).enable("table")
    markdown.add_render_rule("image", _in_words)
    tokens = markdown.parse("\n".join(map(printable, text.splitlines())))
    for token in tokens:
        if token.type in ("heading_open", "heading_close"):
            token.tag = f"h{min(int(token.tag[1:]) + _BELOW, _DEEPEST)}"
    shown = markdown.renderer.render(tokens, markdown.options, {})
    # What a number in it stood for, such as &#8238;, is there only now.
    return "\n".join(map(printable, shown.splitlines()))


def _in_words(renderer: Any, tokens: Sequence[Any], at: int, options: Any, env: Any) -> str:
    words: str = renderer.renderInlineAsText(tokens[at].children, options, env)
    return escape(words)
