#!/bin/sh
# Brings resources/translations up to the texts of the window: new ones are added as unfinished, those that are gone are
# dropped. Titles, descriptions and choices of the schema of project files are texts of the window too.
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
for language in resources/translations/*.ts; do
  lupdate -silent -locations none -no-obsolete ui app/window "$folder/schema_texts.cpp" -I core -I ui -ts "$language"
done
