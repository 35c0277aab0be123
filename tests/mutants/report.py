"""What came of the planted bugs, for reading."""
STATES = {"killed": "killed", "pictures": "seen by golden pictures alone", "survived": "survived",
          "no effect": "no effect: the programs are the same bytes", "not built": "not built"}


def report(results):
    """@param results  by id"""
    rows = sorted(results.items())
    modules = sorted({r["module"] for _, r in rows})
    lines = ["# Planted bugs", "", f"| module | planted | {' | '.join(STATES)} |", "|---" * (2 + len(STATES)) + "|"]
    for module in modules + ["all"]:
        own = [r for _, r in rows if module in ("all", r["module"])]
        counts = [sum(r["state"] == state for r in own) for state in STATES]
        lines.append(f"| {module} | {len(own)} | {' | '.join(map(str, counts))} |")
    # What nobody saw first.
    for state in [s for s in STATES if s != "killed"] + ["killed"]:
        found = [(name, r) for name, r in rows if r["state"] == state]
        if found:
            words = STATES[state]
            lines += ["", f"## {words[0].upper()}{words[1:]}", "", "| bug | file | why plausible | by | s |",
                      "|---|---|---|---|---|"]
            lines += [f"| {n} | {r['file']} | {r['why']} | {', '.join(r['by'])} | {r['seconds']:.0f} |"
                      for n, r in found]
    return "\n".join(lines) + "\n"
