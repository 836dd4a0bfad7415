#!/usr/bin/env python3
"""Reads a page of a report with Python's own parsers; fails where it is no HTML whose elements are
closed in order, needs another file, or has an id, attribute or image that is not whole.
Usage: html_page.py PAGE"""

import base64
import html.parser
import re
import struct
import sys
import xml.etree.ElementTree

VOID = {"meta", "br", "img", "hr", "link", "input"}


class Page(html.parser.HTMLParser):
    """Keeps what is open and what is wrong."""

    def __init__(self):
        super().__init__()
        self.open = []
        self.faults = []
        self.pictures = 0

    def handle_startendtag(self, tag, attrs):
        self.look_at(tag, attrs)

    def handle_starttag(self, tag, attrs):
        self.look_at(tag, attrs)
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"line {self.getpos()[0]}: </{tag}> closes nothing")

    def look_at(self, tag, attrs):
        """An element's attributes, each once; what it loads is in it."""
        names = [name for name, _ in attrs]
        if len(names) != len(set(names)):
            self.faults.append(f"<{tag}> has an attribute twice")
        values = dict(attrs)
        if tag == "script":
            self.faults.append("a script")
        if "src" in values:
            self.look_at_picture(values["src"])
        if re.match(r"[a-z]+:|/", values.get("href", "")):
            self.faults.append(f"a link out of the folder: {values['href']}")

    def look_at_picture(self, source):
        """A PNG in the page."""
        self.pictures += 1
        head = "data:image/png;base64,"
        data = base64.b64decode(source[len(head):], validate=True)
        if not source.startswith(head) or data[:8] != b"\x89PNG\r\n\x1a\n":
            self.faults.append(f"no PNG: {source[:60]}")
        elif min(struct.unpack(">II", data[16:24])) < 100 or data[-8:-4] != b"IEND":
            self.faults.append("a picture that is not whole")


def main(path):
    text = open(path, encoding="utf-8").read()
    page = Page()
    page.feed(text)
    page.close()
    xml.etree.ElementTree.fromstring(text.partition("\n")[2])
    faults = page.faults + [f"<{tag}> stays open" for tag in page.open]
    if re.search(r"url\(|@import", text):
        faults.append("a style that loads another file")
    print("\n".join(faults) if faults else f"{page.pictures} pictures, all is well")
    return 1 if faults or not text.startswith("<!DOCTYPE html>\n") else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
