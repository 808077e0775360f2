"""docs/mutants.md: how many of the planted faults were caught, room by room, and why the others were not."""
import collections

HEAD = """# Planted faults

`tools/mutants/run` writes this page. It plants faults in the libraries, each by itself, and runs the tests that come through
the place: an operator is turned round, a constant is four times as large, a clamp is dropped, two arguments are swapped.
The seed `{seed}` chose {chosen} of them, of which {count} were planted: the others did not compile, or changed a constant
that the compiler itself works out. The tests of their own floor (`tests/lib`, `tests/sdf`, `tests/render`, `tests/bind/c`)
caught **{room}**, other tests {rest} more. {equal} of those left give the same results as before, for the reason beside them.

| room | faults | caught by its floor's tests | by others | by none |
|---|---|---|---|---|
"""


def reasons_of(root):
    """{(file, change): reason}, from lines `FILE: CHANGE: REASON`."""
    file, reasons = root / "tools/mutants/reasons.txt", {}
    for line in file.read_text().splitlines() if file.is_file() else ():
        if line and not line.startswith("#"):
            where, change, reason = line.split(": ", 2)
            reasons[where, change] = reason
    return reasons


def room_of(file):
    parts = file.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def write(root, seed, chosen, faults, ends):
    """Writes the page; gives the share that the floors' own tests caught, of those that change anything."""
    rooms, reasons, left = collections.defaultdict(collections.Counter), reasons_of(root), []
    for number, site in sorted(faults.items(), key=lambda one: (one[1].file, one[1].start)):
        end = ends[number][0]
        rooms[room_of(site.file)][end] += 1
        if end in ("none", "unreached", "rest"):
            reason = reasons.get((f"{site.file}:{site.line}", site.what.replace(": ", " ")), "")
            left.append((site, ends[number], reason))
    of = lambda *ends_: sum(room[end] for room in rooms.values() for end in ends_)
    equal = sum(reason.startswith("the same") for _, _, reason in left)
    text = HEAD.format(seed=seed, chosen=chosen, count=len(faults), room=of("room"), rest=of("rest"), equal=equal)
    for room, ended in sorted(rooms.items()):
        text += f"| `{room}` | {sum(ended.values())} | {ended['room']} | {ended['rest']} | {ended['none'] + ended['unreached']} |\n"
    text += "\n## Those that their floor's tests let pass\n\n| where | change | caught by | why |\n|---|---|---|---|\n"
    for site, (end, name), reason in left:
        text += f"| `{site.file}:{site.line}` | {site.what} | {name or ('no test comes here' if end == 'unreached' else 'none')} | {reason} |\n"
    (root / "docs/mutants.md").write_text(text)
    return of("room") / max(1, len(faults) - equal)
