# SPDX-License-Identifier: Apache-2.0
"""Lists facts of old pages that no page has now: numbers with their units, flags, keys, file names and exit codes.

    lost_facts.py REVISION [PAGE ...]    prints PAGE: FACT for each; exit code 1 if there are any

A page is compared with all pages of today, because a fact may have moved to another one.
"""
import re
import subprocess
import sys

import words

UNITS = r"(?:%|°|deg|rad/s|rad|rpm|Hz|kHz|fps|ms|us|µs|min|s|h|mm|cm|m|pt|px|dB|KiB|MiB|GiB|kB|MB|GB|kg|N|J|W|CPU s)"
FACT = re.compile(rf"""
    (?P<code>(?<!`)`[^`\n]+`)                        # flags, keys and names stand in code
  | (?P<flag>(?<![\w-])--?[a-z][\w-]*)
  | (?P<number>(?<![\w.])[-+]?\d[\d.,  ]*(?:[eE][-+]?\d+)?(?:\s?{UNITS}(?![\w]))?)
  | (?P<file>\b[\w-]+\.(?:toml|png|mp4|csv|json|md|svg|pdf|tex|vtt|srt|gif|webp|mkv|sh|py|cpp|h|obj|stl|deb|html)\b)
""", re.X)


def facts(text):
    """Returns the facts of a page, blanks and grouping of digits apart."""
    found = set()
    for match in FACT.finditer(text):
        fact = re.sub(r"\s+", " ", match[0]).strip("`., ")
        if match["number"]:
            fact = re.sub(r"(?<=\d)[, \u202f\u00a0](?=\d{3})", "", fact)
        found.add(fact)
    return found


def git(*arguments):
    return subprocess.run(["git", "-C", words.ROOT, *arguments], capture_output=True, text=True, check=True).stdout


def lost(revision, pages, now):
    for page in pages:
        for fact in sorted(facts(git("show", f"{revision}:{page}"))):
            if fact not in now and not re.search(rf"(?<![\w.]){re.escape(fact)}(?![\w])", now[None]):
                yield f"{page}: {fact}"


def main():
    revision, *asked = sys.argv[1:]
    pages = asked or [page for page in git("ls-tree", "-r", "--name-only", revision).split("\n") if page.endswith(".md")]
    today = [path for path in git("ls-files", "-co", "--exclude-standard", "*.md").split("\n") if path]
    text = "\n".join((words.ROOT / path).read_text() for path in today if (words.ROOT / path).exists())
    found = list(lost(revision, pages, {None: re.sub(r"\s+", " ", text), **dict.fromkeys(facts(text))}))
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
