#!/bin/sh
# Brings resources/translations up to the texts of the window: new ones are added as unfinished, those that are gone are
# dropped. Titles, descriptions and choices of the schema of project files are texts of the window too, and so are the
# words of pictures: what picture_word is given, titles of fields and of blocks' quantities, how blocks move and fail, and
# what the density of poles is told in.
set -e
cd "$(dirname "$0")/.."
PATH=/usr/lib/qt6/bin:$PATH
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
python3 - resources/schema/project.schema.json > "$folder/schema_texts.cpp" <<'PYTHON'
import json, sys

said = {"schema": {}, "choices": {}}  # ordered sets

def walk(rule):
    for key in ("title", "description", "absent", "variant"):
        if isinstance(rule.get(key), str):
            said["schema"][rule[key]] = None
    for word in [*rule.get("enum", []), *rule.get("named", []), *rule.get("columns", []), *rule.get("presets", {})]:
        if len(word) > 2 or word == "on":  # x, xx, t: symbols
            said["choices"][word] = None
    if isinstance(rule.get("file"), str):
        said["schema"][rule["file"]] = None
    for key in ("properties", "definitions"):
        for inner in rule.get(key, {}).values():
            walk(inner)
    for key in ("items", "additionalProperties"):
        if isinstance(rule.get(key), dict):
            walk(rule[key])

with open(sys.argv[1], encoding="utf-8") as file:
    walk(json.load(file))
print("static const char* const texts[] = {")
for context, words in said.items():
    for word in words:
        print(f"    QT_TRANSLATE_NOOP({json.dumps(context)}, {json.dumps(word, ensure_ascii=False)}),")
print("};")
PYTHON
python3 - > "$folder/picture_texts.cpp" <<'PYTHON'
import json, pathlib, re

said = {}  # an ordered set
for source in sorted(pathlib.Path("ui/render").rglob("*.[ch]pp")):
    for call in re.findall(r'picture_word\(([^;]*?)\)', source.read_text(encoding="utf-8"), re.S):
        said.update(dict.fromkeys(re.findall(r'"([^"]+)"', call)))
for file, pattern in (("core/results/field.cpp", r'Field\{"[^"]*", "([^"]+)"'),
                      ("core/measures/block_history.cpp", r'BlockQuantity\{"[^"]*", "([^"]+)"'),
                      ("core/fields/field_values.cpp", r'return "([^"]+)";'),
                      ("core/orientation/critical_zone.hpp", r'return "([^"]+)";'),
                      ("core/orientation/pole_density.hpp", r'"(% per 1 % area)"')):
    said.update(dict.fromkeys(re.findall(pattern, pathlib.Path(file).read_text(encoding="utf-8"))))
motions = pathlib.Path("core/results/motion_class.cpp").read_text(encoding="utf-8")
words = re.search(r"string_view words\[\] = \{(.*?)\}", motions, re.S).group(1)
said.update(dict.fromkeys(re.findall(r'"([^"]+)"', words)))
print("static const char* const texts[] = {")
for word in said:
    print(f"    QT_TRANSLATE_NOOP(\"picture\", {json.dumps(word, ensure_ascii=False)}),")
print("};")
PYTHON
for language in resources/translations/*.ts; do
  lupdate -silent -locations none -no-obsolete ui app/window "$folder/schema_texts.cpp" "$folder/picture_texts.cpp" -I core -I ui -ts "$language"
done
