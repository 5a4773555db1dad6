# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks what the program itself has written.

results.py h5md FOLDER SCENARIO     every item of H5MD 1.1 and of the project's own
results.py reader FOLDER            MDAnalysis reads the file's numbers, where it is installed
results.py verdicts FILE...         JSON of test_commands.c
"""
import json
import sys

sys.dont_write_bytecode = True


def verdicts(paths):
    for path in paths:
        with open(path, encoding="utf-8") as file:
            found = json.load(file)
        assert found["program"] == "fretwork" and found["version"] and found["revision"]
        assert found["expectations"] == 9 and found["failed"] == 2
        judged, damping = found["experiments"]
        assert judged["experiment"] == "judged" and damping["experiment"] == "damping"
        assert judged["title"] == 'a "falling" particle' and judged["source"] == "K\u00f6rper"
        assert judged["seconds"] >= 0 and len(damping["expectations"]) == 5
        assert all(verdict["holds"] for verdict in damping["expectations"])
        place, relative, bounds, ratio = judged["expectations"]
        assert place == {
            "quantity": "position.speck[0,0] x, at the end", "expected": "2.5 +- 0.25",
            "value": 2.5, "tolerance": 0.25, "above": None, "below": None, "measured": 2.0,
            "holds": False, "source": None, "note": None}
        assert relative["tolerance"] == 0.01 * 0.0625 and relative["holds"]
        assert (relative["source"], relative["note"]) == ("half", "so")
        assert bounds["value"] is None and bounds["tolerance"] is None
        assert (bounds["above"], bounds["below"]) == (0.01, 1) and bounds["holds"]
        assert ratio["measured"] is None and ratio["holds"] is False, "not a number"


if __name__ == "__main__":
    job, *arguments = sys.argv[1:]
    if job == "verdicts":
        verdicts(arguments)
