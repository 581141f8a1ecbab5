#!/usr/bin/python3
"""Makes the window's typeface: make_fonts.py FOLDER_OF_INTER OUT_FOLDER

Qt 6.4 cannot switch OpenType features on (QFont::setFeature came with 6.7), and figures in tables must stand below each
other. So Inter's tabular figures are made the ordinary ones, and the result is named Talus Sans (Inter is under the
OFL 1.1 without a reserved font name). Input is Debian's fonts-inter; no font file is kept in the sources.
"""
import sys
from fontTools.ttLib import TTFont

TABULAR = "0123456789.,:-+−"
WEIGHTS = ("Regular", "Medium", "SemiBold")


def tabular_glyphs(font):
    """Glyph → its tabular twin, from the font's own `tnum` feature."""
    gsub = font["GSUB"].table
    twins = {}
    for feature in gsub.FeatureList.FeatureRecord:
        if feature.FeatureTag != "tnum":
            continue
        for number in feature.Feature.LookupListIndex:
            for subtable in gsub.LookupList.Lookup[number].SubTable:
                subtable = getattr(subtable, "ExtSubTable", subtable)
                twins.update(getattr(subtable, "mapping", {}))
    return twins


def drop_composed_letters(font):
    """Of `ccmp` the ligatures of letters with combining accents: HarfBuzz composes these itself, by Unicode, and to look
    for one at every letter took it half of its time."""
    gsub = font["GSUB"].table

    def composes(number):
        for subtable in gsub.LookupList.Lookup[number].SubTable:
            ligatures = getattr(getattr(subtable, "ExtSubTable", subtable), "ligatures", {})
            if any("uni0301" in ligature.Component for of_letter in ligatures.values() for ligature in of_letter):
                return True
        return False

    for record in gsub.FeatureList.FeatureRecord:
        if record.FeatureTag == "ccmp":
            record.Feature.LookupListIndex = [n for n in record.Feature.LookupListIndex if not composes(n)]


def rename(font, weight):
    plain = weight == "Regular"
    names = {1: "Talus Sans" if plain else f"Talus Sans {weight}", 3: f"TalusSans-{weight}",
             4: f"Talus Sans {weight}", 6: f"TalusSans-{weight}", 16: "Talus Sans"}
    for record in font["name"].names:
        if record.nameID in names:
            record.string = names[record.nameID]
    if "CFF " in font:
        font["CFF "].cff.fontNames = [f"TalusSans-{weight}"]


def main(source, out):
    for weight in WEIGHTS:
        font = TTFont(f"{source}/Inter-{weight}.otf")
        twins = tabular_glyphs(font)
        for table in font["cmap"].tables:
            if table.isUnicode():
                for code, glyph in list(table.cmap.items()):
                    if chr(code) in TABULAR and glyph in twins:
                        table.cmap[code] = twins[glyph]
        drop_composed_letters(font)
        rename(font, weight)
        font.save(f"{out}/TalusSans-{weight}.otf")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
