#!/usr/bin/python3
"""Makes the man page of a program from what its --help says: make_man_page.py PROGRAM OUT.1.gz

The help of each command that "Subcommands:" lists is asked for in turn. Help is read in two columns: what is indented
by two spaces is a term, what stands two spaces or more behind it, or is indented further, explains it.
"""
import gzip
import os
import re
import subprocess
import sys

TERM = re.compile(r"  (\S(?:.*?\S)?)(?:  +(\S.*))?$")
OWN_SECTIONS = {"Positionals": "Arguments"}  # as CLI11 names them; Qt has the other word


def escaped(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text[:1] in (".", "'") else text


class Help:
    """One help text: `about`, `usage`, and `sections`, each a list of a term and its explanation."""

    def __init__(self, words):
        text = subprocess.run([*words, "--help"], check=True, stdout=subprocess.PIPE).stdout.decode()
        self.about, self.usage, self.sections, section = [], "", {}, None
        for line in text.splitlines():
            term = TERM.match(line)
            if line.startswith("Usage: "):
                self.usage = " ".join(line.split()[2 + len(words) - 1:])
            elif re.fullmatch(r"[A-Z]\w+:", line):
                section = self.sections.setdefault(line[:-1], [])
            elif section is None:
                self.about += [line] if line else []
            elif term and not line.startswith("   "):
                section.append([term[1], term[2] or ""])
            elif line.strip():
                section[-1][1] = (section[-1][1] + " " + line.strip()).strip()


def terms(section):
    for term, explanation in section:
        yield from (".TP", ".B " + escaped(term), escaped(explanation))


def page_of(program):
    name = os.path.basename(program)
    version = subprocess.run([program, "--version"], check=True, stdout=subprocess.PIPE).stdout.decode().splitlines()[0]
    whole = Help([program])
    yield from (f'.TH {name.upper()} 1 "" "{version}"', ".SH NAME", f"{escaped(name)} \\- {escaped(whole.about[0].rstrip('.'))}")
    yield from (".SH SYNOPSIS", f".B {escaped(name)}", escaped(whole.usage), ".SH DESCRIPTION", *map(escaped, whole.about))
    for title, section in whole.sections.items():
        if title != "Subcommands":
            yield from (".SH " + OWN_SECTIONS.get(title, title).upper(), *terms(section))
    if "Subcommands" in whole.sections:
        yield ".SH COMMANDS"
        yield from commands_below([program], whole)
    yield from (".SH SEE ALSO", "The manual, in share/doc/talus.")


def commands_below(words, upper):
    for command, _ in upper.sections.get("Subcommands", []):
        below = [*words, command]
        help_text = Help(below)
        yield from (".SS " + escaped(" ".join(below[1:])), *map(escaped, help_text.about))
        yield from (".PP", f".B {escaped(' '.join([os.path.basename(below[0]), *below[1:]]))}", escaped(help_text.usage))
        for title, section in help_text.sections.items():
            if title != "Subcommands":
                yield from terms(row for row in section if not row[0].startswith("-h,"))
        yield from commands_below(below, help_text)


def main(program, out):
    page = "\n".join(line for line in page_of(program) if line) + "\n"
    with open(out, "wb") as file, gzip.GzipFile("", "wb", 9, file, mtime=0) as packed:
        packed.write(page.encode())


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
