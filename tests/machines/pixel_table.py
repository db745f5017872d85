# SPDX-License-Identifier: Apache-2.0
"""Formats the figures of pixels.py as a Markdown table."""

MOST_NAMED = 8  # moved pictures in a cell
HEAD = ("system", "Mesa", "LLVM", "back end", "pictures", "equal", "pixels that differ", "largest difference", "verdict",
        "pictures that move: pixels, by levels")
SETS = {"stills": "stills of {}", "suite": "golden suite"}


def moved_text(moved):
    """Returns the moved pictures as text, most differing pixels first: "frisbee (12 by 1)"."""
    ordered = sorted(moved, key=lambda each: -(each["differing_pixels"] or 0))
    texts = [f"{each['name'].removesuffix('.png')} ({each['differing_pixels']} by {each['max_difference']:g})"
             if each["differing_pixels"] is not None else each["name"] for each in ordered[:MOST_NAMED]]
    return ", ".join(texts) + (f" and {len(moved) - MOST_NAMED} more" if len(moved) > MOST_NAMED else "")


def cells(row, size):
    return (row["system"], row["mesa"], row["llvm"], row["backend"], SETS[row["set"]].format(size),
            f"{row['equal']} of {row['pictures']}", f"{row['differing_pixels']:,}".replace(",", " "), f"{row['max_difference']:g}",
            "reference" if row["is_reference"] else row["verdict"], moved_text(row["moved"]))


def line(texts):
    return "| " + " | ".join(str(text) if text is not None else "" for text in texts) + " |\n"


def markdown(report):
    """Returns the table with its rows grouped by set, and a line below it for each absent back end."""
    rows = sorted(report["rows"], key=lambda row: list(SETS).index(row["set"]))  # sorted() keeps the order of systems
    text = line(HEAD) + line("---" for _ in HEAD) + "".join(line(cells(row, report["size"])) for row in rows)
    for each in report["absent"]:
        text += f"\n{each['system']} has no {each['backend']}.\n"
    return text
