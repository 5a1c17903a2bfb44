#!/usr/bin/python3
"""Says which documents a JSON Schema accepts.

    validate.py SCHEMA DOCUMENTS    one document a line; prints 1 or 0 for each
"""

import json
import sys

import jsonschema

schema = json.load(open(sys.argv[1], encoding="utf-8"))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
with open(sys.argv[2], encoding="utf-8") as documents:
    print("".join("1" if validator.is_valid(json.loads(line)) else "0" for line in documents))
