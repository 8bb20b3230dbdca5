"""The page: every figure beside what the paper says of it, as Markdown and as HTML."""

import html
import json
from pathlib import Path

from plotting import ROOT

from .model import verdict

INTRODUCTION = (
    "The figures and Table 1 of the paper made anew by `{command}`. For each: what the paper states, what was "
    "measured on the runs of this page, the criterion, and whether it agrees. Every number is read from the runs. "
    "The paper's own pictures are not shown here, and many of its scenes are given by a picture only: their shape "
    "is then ours, and only what can be measured is judged.")
WORDS = {True: "yes", False: "no", None: "not comparable"}


class Section:
    """One figure on the page: the record of its outcome, or None if it was not made."""

    def __init__(self, figure, record, stale=False):
        self.figure, self.record, self.stale = figure, record, stale

    @property
    def verdict(self):
        """On what the paper claims."""
        return verdict([claim for claim in self.claims if not claim.printed]) if self.record else "not made"

    @property
    def verdict_as_printed(self):
        """On what its equations give as they are printed, where that was measured."""
        return verdict([claim for claim in self.claims if claim.printed])

    @property
    def claims(self):
        return self.record["outcome"].claims if self.record else []

    @property
    def anchor(self):
        return "".join(letter for letter in self.figure.title.split(":")[0].lower() if letter.isalnum())


class Markdown:
    """Writes Markdown. Places are relative to the folder of the page."""

    def heading(self, level, text, anchor=""):
        return (f'<a id="{anchor}"></a>\n\n' if anchor else "") + "#" * level + f" {text}\n"

    def paragraph(self, text):
        return text + "\n"

    def link(self, text, place):
        return f"[{text}]({place})"

    def picture(self, place, caption):
        return f"![{caption}]({place})\n\n{caption}\n"

    def table(self, header, rows):
        lines = ["| " + " | ".join(header) + " |", "|---" * len(header) + "|"]
        return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"

    def items(self, texts):
        return "\n".join(f"- {text}" for text in texts) + "\n"

    def document(self, title, parts):
        return "\n".join([f"# {title}\n", *parts])


class Html:
    """Writes HTML. Texts may hold `code`; links come from link()."""

    STYLE = ("body{font:15px/1.5 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}"
             "img{max-width:100%;height:auto}table{border-collapse:collapse;margin:1em 0}"
             "td,th{border:1px solid #ccc;padding:.3em .6em;text-align:left;vertical-align:top}"
             "th{background:#f4efe4}figure{margin:1em 0}figcaption{color:#555;font-size:13px}"
             "code{background:#f4f4f4}h2{border-top:1px solid #ccc;padding-top:1em}")

    def text(self, text):
        parts = text.split("`")
        for place in range(0, len(parts), 2):
            if not parts[place].startswith("<a "):
                parts[place] = html.escape(parts[place], quote=False)
        for place in range(1, len(parts), 2):
            parts[place] = f"<code>{html.escape(parts[place])}</code>"
        return "".join(parts)

    def heading(self, level, text, anchor=""):
        name = f' id="{anchor}"' if anchor else ""
        return f"<h{level}{name}>{self.text(text)}</h{level}>"

    def paragraph(self, text):
        return f"<p>{self.text(text)}</p>"

    def link(self, text, place):
        return f'<a href="{place}">{html.escape(text)}</a>'

    def picture(self, place, caption):
        return (f'<figure><img src="{place}" alt="{html.escape(caption)}" loading="lazy">'
                f"<figcaption>{self.text(caption)}</figcaption></figure>")

    def table(self, header, rows):
        cells = lambda row, tag: "".join(f"<{tag}>{self.text(cell)}</{tag}>" for cell in row)  # noqa: E731
        body = "".join(f"<tr>{cells(row, 'td')}</tr>" for row in rows)
        return f"<table><tr>{cells(header, 'th')}</tr>{body}</table>"

    def items(self, texts):
        return "<ul>" + "".join(f"<li>{self.text(text)}</li>" for text in texts) + "</ul>"

    def document(self, title, parts):
        return (f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{html.escape(title)}</title>'
                f"<style>{self.STYLE}</style><h1>{html.escape(title)}</h1>" + "\n".join(parts) + "</html>\n")


def overview(form, sections):
    rows = [[form.link(section.figure.title.split(":")[0], "#" + section.anchor),
             section.figure.title.split(":", 1)[1].strip(), section.verdict,
             section.verdict_as_printed, "; ".join(claim.measured for claim in section.claims if not claim.printed)]
            for section in sections]
    return form.table(["figure", "what it shows", "the claim", "as printed", "measured"], rows)


def scene_links(form, figure, to_root):
    names = sorted({str(Path(run.scene).parent) for run in figure.planned})
    return ", ".join(form.link(f"scenes/{name}", f"{to_root}/scenes/{name}/README.md") for name in names)


def write_section(form, section, pictures, to_root):
    """`pictures`: the folder of the pictures as the page sees it."""
    figure = section.figure
    parts = [form.heading(2, figure.title, section.anchor), form.paragraph(f"The paper: {figure.says}")]
    if figure.planned:
        parts.append(form.table(["scene", "alone"], [[scene_links(form, figure, to_root),
                                                      f"`scripts/figures {figure.name}`"]]))
    else:
        parts.append(form.paragraph(f"Alone: `scripts/figures {figure.name}`"))
    if section.record is None:
        return parts + [form.paragraph("Not made yet.")]
    if section.stale:
        parts.append(form.paragraph("Something that it depends on has changed since it was made."))
    outcome = section.record["outcome"]
    for name, caption in outcome.pictures:
        parts.append(form.picture(f"{pictures}/{name}", caption))
    parts.append(form.table(["stated", "measured", "agrees", "criterion", "why, or what limits it"],
                            [[claim.stated + (" (as printed)" if claim.printed else ""), claim.measured,
                              WORDS[claim.agrees], claim.criterion, claim.why]
                             for claim in outcome.claims]))
    for caption, header, rows in outcome.tables:
        parts += [form.paragraph(caption), form.table(header, rows)]
    if outcome.notes:
        parts.append(form.items(outcome.notes))
    return parts


def write(form, sections, machine, command, pictures, to_root):
    """The text of the page. `pictures(figure)` is where a figure's pictures are, `to_root` the way to the project."""
    parts = [form.paragraph(INTRODUCTION.format(command=command)), form.paragraph(machine), overview(form, sections)]
    for section in sections:
        parts += write_section(form, section, pictures(section.figure), to_root)
    return form.document("The figures of the paper, made anew", parts)


def save_record(path, record):
    """A figure's record, {"key", "seconds", "outcome"}, as JSON."""
    outcome = record["outcome"]
    data = {**record, "outcome": {**vars(outcome), "claims": [vars(claim) for claim in outcome.claims]}}
    path.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n")


def relative_root(folder):
    """The project's folder as a page in `folder` names it."""
    try:
        return "/".join([".."] * len(Path(folder).resolve().relative_to(ROOT).parts)) or "."
    except ValueError:
        return ROOT.as_uri()
