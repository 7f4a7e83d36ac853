#!/usr/bin/python3
"""Lists what the window's translations lack, and fills it in.

packaging/translations.py missing > TABLE
    every text that some language has no finished translation of, once:
        = the text
        de: …
        fr: …
        es: …
        zh_CN: …
packaging/translations.py fill TABLE
    writes what such a table holds into resources/translations/*.ts, wherever the text occurs, and marks it as finished.

Run the target update_translations before (new texts) and after (its layout of the files). Line breaks stand as \\n; what is in %1 or
{braces} stays as it is.
"""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "resources" / "translations"
LANGUAGES = ("de", "fr", "es", "zh_CN")


def path_of(language):
    return FOLDER / f"handlebody_{language}.ts"


def messages(tree):
    return tree.getroot().iter("message")


def is_finished(message):
    translation = message.find("translation")
    return translation.get("type") is None and (translation.text or "") != ""


def missing():
    lacking = {}
    for language in LANGUAGES:
        for message in messages(ElementTree.parse(path_of(language))):
            if not is_finished(message):
                lacking.setdefault(message.find("source").text, []).append(language)
    for source, languages in lacking.items():
        print("= " + source.replace("\n", "\\n"))
        for language in languages:
            print(language + ": ")


def read_table(path):
    table, source = {}, None
    for line in pathlib.Path(path).read_text(encoding="utf-8").split("\n"):
        if line.startswith("= "):
            source = line[2:].replace("\\n", "\n")
        elif source is not None and ":" in line:
            language, text = line.split(":", 1)
            text = text[1:] if text.startswith(" ") else text
            if text:
                table[language, source] = text.replace("\\n", "\n")
    return table


def fill(path):
    table = read_table(path)
    for language in LANGUAGES:
        tree = ElementTree.parse(path_of(language))
        for message in messages(tree):
            text = table.get((language, message.find("source").text))
            if text is not None and not is_finished(message):
                translation = message.find("translation")
                translation.text = text
                translation.attrib.pop("type", None)
        content = ElementTree.tostring(tree.getroot(), encoding="unicode")
        header = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
        path_of(language).write_text(header + content + "\n", encoding="utf-8")


if len(sys.argv) == 2 and sys.argv[1] == "missing":
    missing()
elif len(sys.argv) == 3 and sys.argv[1] == "fill":
    fill(sys.argv[2])
else:
    sys.exit(__doc__)
