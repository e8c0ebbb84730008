#!/usr/bin/env python3
"""Writes the old workbooks (.xls) that tests read into old_workbooks/ beside this file.

They are kept, since xlwt (Debian: python3-xlwt), which writes them, is needed for nothing else. It computes no formulas: results are
written here as Excel stores them.
"""
import datetime
import pathlib
import struct

import xlwt

folder = pathlib.Path(__file__).parent / "old_workbooks"
HEADER = ["Zeit [s]", "Drehmoment [mNm]", "Normalkraft [N]", "Spalt [mm]", "Winkelgeschwindigkeit [rad/s]"]


class Result:
    """Cell of a formula with its result: a number, a text, an error code or nothing."""

    def __init__(self, row, column, style, kind, value=0):
        self.rowx, self.colx, self.style, self.kind, self.value = row, column, style, kind, value

    def get_biff_data(self):
        codes = {"text": 0, "truth": 1, "error": 2, "empty": 3}
        if self.kind == "number":
            result = struct.pack("<d", self.value)
        else:
            byte = self.value if self.kind in ("truth", "error") else 0
            result = struct.pack("<BBBBHH", codes[self.kind], 0, byte, 0, 0, 0xFFFF)
        body = struct.pack("<HHH", self.rowx, self.colx, self.style) + result + struct.pack("<HI", 0, 0)
        body += struct.pack("<H", 3) + b"\x1e\x01\x00"  # the formula 1
        record = struct.pack("<HH", 6, len(body)) + body
        if self.kind == "text":
            text = struct.pack("<HB", len(self.value), 1) + self.value.encode("utf-16le")
            record += struct.pack("<HH", 0x207, len(text)) + text
        return record


def result(sheet, row, column, kind, value=0, style=None):
    index = sheet.row(row)._Row__parent_wb.add_style(style or xlwt.Style.default_style)
    sheet.row(row).insert_cell(column, Result(row, column, index, kind, value))


def titled(book, name, header):
    sheet = book.add_sheet(name)
    for column, text in enumerate(header):
        sheet.write(0, column, text)
    return sheet


def recording(book, name, torque, header=HEADER):
    sheet = titled(book, name, header)
    for row in range(1, 6):
        for column, value in enumerate([row - 1, torque + row / 1000, 5, 6.25, 0.5]):
            sheet.write(row, column, value)
    return sheet


def cells():
    book = xlwt.Workbook()
    cover = book.add_sheet("Deckblatt")
    cover.write(0, 0, "Versuch 7, Glaskugeln 500 µm")
    recording(book, "3 kPa", 20)
    recording(book, "6 kPa", 1e-7 / 3)
    hidden = recording(book, "verborgen", 1)
    hidden.visibility = 1
    book.save(folder / "three_sheets.xls")


def results():
    book = xlwt.Workbook()
    sheet = titled(book, "Ω β", ["Time [s]", "Torque [N m]", "Remark"])
    for row, value in enumerate([0.1, 1 / 3, 1e300, -2.5e-9, 12345678], 1):
        sheet.write(row, 0, row)
        result(sheet, row, 1, "number", value)
    sheet.write(6, 0, 6)
    result(sheet, 6, 1, "empty")
    result(sheet, 1, 2, "text", "größer: µ")
    result(sheet, 2, 2, "error", 7)
    result(sheet, 3, 2, "truth", 1)
    sheet.row(4).set_cell_error(2, 0x2A)
    sheet.row(5).set_cell_boolean(2, False)
    book.save(folder / "results.xls")
    book = xlwt.Workbook()
    sheet = titled(book, "Data", ["Time [s]", "Torque [N m]"])
    for row in range(1, 4):
        sheet.write(row, 0, row)
        sheet.write(row, 1, xlwt.Formula(f"A{row + 1}*2"))
    book.save(folder / "not_computed.xls")
    book = xlwt.Workbook()
    sheet = titled(book, "Data", ["Time [s]", "Torque [N m]"])
    for row in range(1, 4):
        sheet.write(row, 0, row)
        if row < 3:
            sheet.write(row, 1, 2 * row)
    sheet.row(3).set_cell_error(1, "#DIV/0!")
    book.save(folder / "error.xls")


def dates():
    for name, mode in ("1900", False), ("1904", True):
        book = xlwt.Workbook()
        book.dates_1904 = mode
        sheet = titled(book, "Data", ["Date", "Time", "Torque [N m]"])
        day = xlwt.easyxf(num_format_str="dd/mm/yyyy\\ hh:mm:ss")
        clock = xlwt.easyxf(num_format_str="[h]:mm:ss")
        for row, (date, hour) in enumerate([(45352, 0.25), (59, 0.25 + 5.25 / 86400), (61, 1.25)], 1):
            sheet.write(row, 0, date, day)
            sheet.write(row, 1, hour, clock)
            sheet.write(row, 2, row)
        book.save(folder / f"dates_{name}.xls")


def layout():
    book = xlwt.Workbook()
    sheet = titled(book, "Data", ["Interval", "Time [s]", "Torque [N m]"])
    sheet.merge(1, 2, 0, 0)
    sheet.write(1, 0, 7)
    for row in range(1, 5):
        sheet.write(row, 1, row)
        sheet.write(row, 2, row / 10)
    sheet.write(3, 0, 8)
    sheet.write(4, 0, 8)
    sheet.row(3).hidden = True
    book.save(folder / "merged_and_hidden.xls")


def long_texts():
    """More shared texts than one record holds, wide and narrow, so that texts continue in others."""
    book = xlwt.Workbook()
    sheet = book.add_sheet("Data")
    sheet.write(0, 0, "Torque [N m]")
    sheet.write(0, 1, "Remark")
    for row in range(1, 401):
        sheet.write(row, 0, row)
        sheet.write(row, 1, ("µm " if row % 2 else "Ωm ") + f"{row} " + "ä" * (row % 90))
    book.save(folder / "long_texts.xls")


folder.mkdir(exist_ok=True)
cells(), results(), dates(), layout(), long_texts()
