#!/usr/bin/env python3
"""Writes a workbook (.xlsx) whose sheets hold the rows of CSV files.

    make_workbook.py OUT.xlsx [--1904] NAME=FILE.csv...

Numbers are stored as numbers, "#DIV/0!" as an error of a formula, "=A1*2" as a formula without a result, "date:45352.5" and "clock:0.25" as
days in the format of a date or of a clock time, "text:1.000" as a text. Lines "!merge A2:A5" and "!hide 3" concern the sheet. Every other text is shared, every other one in its cell, as different
programs write them. A sheet "hidden:NAME" or "veryHidden:NAME" is hidden. Rows without cells are left out.
"""
import csv
import sys
import zipfile
from xml.sax.saxutils import escape, quoteattr


def letters(column):
    text = ""
    column += 1
    while column:
        column, rest = divmod(column - 1, 26)
        text = chr(65 + rest) + text
    return text


def cell(text, row, column, shared):
    place = f'r="{letters(column)}{row}"'
    try:
        float(text)
        return f"<c {place}><v>{text}</v></c>"
    except ValueError:
        pass
    if text.startswith("="):
        return f"<c {place}><f>{escape(text[1:])}</f></c>"
    for style, kind in (1, "date:"), (2, "clock:"), (3, "percent:"):
        if text.startswith(kind):
            return f'<c {place} s="{style}"><v>{text.removeprefix(kind)}</v></c>'
    text = text.removeprefix("text:")
    if text == "#DIV/0!":
        return f'<c {place} t="e"><v>{text}</v></c>'
    if (row + column) % 2:
        shared.append(text)
        return f'<c {place} t="s"><v>{len(shared) - 1}</v></c>'
    return f'<c {place} t="inlineStr"><is><t>{escape(text)}</t></is></c>'


def sheet(rows, shared):
    text, merged, hidden = "", "", set()
    rows = list(rows)
    for line in [row[0] for row in rows if row and row[0].startswith("!")]:
        word, place = line.split()
        merged += f'<mergeCell ref="{place}"/>' if word == "!merge" else ""
        hidden |= {place} if word == "!hide" else set()
    for number, row in enumerate([row for row in rows if not row or not row[0].startswith("!")], 1):
        cells = "".join(cell(each, number, k, shared) for k, each in enumerate(row) if each)
        if cells:
            hide = ' hidden="1"' if str(number) in hidden else ""
            text += f'<row r="{number}"{hide}>{cells}</row>\n'
    merged = f"<mergeCells>{merged}</mergeCells>" if merged else ""
    return f'<?xml version="1.0"?><worksheet xmlns="x"><sheetData>{text}</sheetData>{merged}</worksheet>'


def main():
    types = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    shared, parts, names, links = [], {}, "", ""
    arguments = [each for each in sys.argv[2:] if each != "--1904"]
    for number, argument in enumerate(arguments, 1):
        name, path = argument.split("=", 1)
        text = open(path, encoding="utf-8").read()
        delimiter = max("\t;,", key=text.count)
        parts[f"xl/worksheets/sheet{number}.xml"] = sheet(csv.reader(text.splitlines(), delimiter=delimiter), shared)
        state, name = name.split(":", 1) if name.startswith(("hidden:", "veryHidden:")) else ("visible", name)
        names += f'<sheet name={quoteattr(name)} state="{state}" sheetId="{number}" r:id="rId{number}"/>'
        links += f'<Relationship Id="rId{number}" Type="{types}/worksheet" Target="worksheets/sheet{number}.xml"/>'
    links += f'<Relationship Id="rId0" Type="{types}/sharedStrings" Target="/xl/texts/shared.xml"/>'
    links += f'<Relationship Id="rIdS" Type="{types}/styles" Target="styles.xml"/>'
    parts["xl/styles.xml"] = (
        '<styleSheet xmlns="x"><numFmts><numFmt numFmtId="164" formatCode="dd/mm/yyyy\\ hh:mm:ss"/></numFmts>'
        '<cellXfs><xf numFmtId="0"/><xf numFmtId="164"/><xf numFmtId="46"/><xf numFmtId="10"/></cellXfs></styleSheet>'
    )
    calendar = '<workbookPr date1904="1"/>' if "--1904" in sys.argv else ""
    parts["xl/workbook.xml"] = f'<workbook xmlns="x" xmlns:r="r">{calendar}<sheets>{names}</sheets></workbook>'
    parts["xl/_rels/workbook.xml.rels"] = f'<Relationships xmlns="x">{links}</Relationships>'
    strings = "".join(f"<si><r><t>{escape(each[:2])}</t></r><r><t>{escape(each[2:])}</t></r></si>" for each in shared)
    parts["xl/texts/shared.xml"] = f'<sst xmlns="x">{strings}</sst>'
    with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)


main()
