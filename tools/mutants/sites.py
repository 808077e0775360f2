"""Where a source file can be made wrong: an expression, and a change in it that still compiles.

A site is an expression that can be chosen at run time: what `return` gives, what `if` asks, what `=` assigns. One thing in
it is changed: an operator, a constant (four times as much), a clamp (dropped), or two arguments of a call (swapped).
"""
import collections
import re

# `start`, `end`: the expression; `changed`: what it becomes; `what`: the change in a few words.
Site = collections.namedtuple("Site", "file line start end changed kind what")

OPERATORS = {"+": "-", "-": "+", "*": "/", "/": "*", "<": ">", ">": "<", "<=": ">", ">=": "<", "==": "!=", "!=": "==", "&&": "||", "||": "&&"}
OPERATOR = re.compile(r"(?<= )(" + "|".join(re.escape(sign) for sign in sorted(OPERATORS, key=len, reverse=True)) + r")(?= )")
CONSTANT = re.compile(r"(?<![\w.])((?:\d+\.\d*|\.\d+)(?:e[+-]?\d+)?|\d+e-\d+)(?![\w.])")
CLAMP = re.compile(r"\bstd::(clamp|min|max)\(")
CALL = re.compile(r"\b(?!if\b|while\b|for\b|switch\b|min\b|max\b|clamp\b|dot\b|hypot\b|sizeof\b|decltype\b)[a-z_]\w*\(")
RETURN, ASKED = re.compile(r"\breturn\s+"), re.compile(r"\b(?:if|while)\s*\(")
ASSIGNED = re.compile(r"(?<![=!<>+\-*/%&|^\[])(?:[+\-*/])?=(?![=\]])\s*")
NOT_SITES = re.compile(r"\b(assert|static_assert|using|template|operator|default|delete|Lanes|MaxLanes)\b")
OPENS, CLOSES = "([{", ")]}"


def masked(text, also_strings=True):
    """The same length, with comments blank, and strings and the preprocessor's lines too if wanted."""
    def blank(found):
        whole = found[0]
        if whole.startswith(("/*", "//")) or also_strings:
            return re.sub(r"[^\n]", " ", whole)
        return whole
    text = re.sub(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])\'', blank, text, flags=re.S)
    return re.sub(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", blank, text, flags=re.M | re.S) if also_strings else text


def end_of(text, start, stops):
    """Where, outside all brackets, one of `stops` comes; -1 if a bracket closes that was not opened before it."""
    depth = 0
    for at in range(start, len(text)):
        if depth == 0 and text[at] in stops:
            return at
        depth += (text[at] in OPENS) - (text[at] in CLOSES)
        if depth < 0:
            return -1
    return -1


def arguments(text, opened):
    """The spans of a call's arguments, and where its bracket closes."""
    spans, start = [], opened
    while (end := end_of(text, start, ",)")) >= 0:
        spans.append((start, end))
        if text[end] == ")":
            return spans, end
        start = end + 1
    return [], -1


def expressions(text):
    """(start, end) of what can be chosen at run time."""
    for pattern, stops in ((RETURN, ";"), (ASKED, ")"), (ASSIGNED, ";,)")):
        for found in pattern.finditer(text):
            start, end = found.end(), end_of(text, found.end(), stops)
            inside = text[start:end].strip() if end > start else ""
            statement = text[text.rfind("\n", 0, start) + 1:end]
            if not inside or inside.startswith("{") or ";" in inside or NOT_SITES.search(statement) or "if constexpr" in statement:
                continue
            if pattern is not ASSIGNED and ASSIGNED.search(inside):
                continue
            yield start, end


def is_constant(words):
    return re.fullmatch(r"[-+\w.:]*", words) and not re.search(r"[a-jl-z_]\w*$", words)


def changes(text, start, end):
    """(kind, from, to, put there, words) of everything that can be changed in an expression."""
    def part(span):
        return text[span[0]:span[1]].strip()
    for found in OPERATOR.finditer(text, start, end):
        yield "operator", *found.span(), OPERATORS[found[0]], f"`{found[0]}` is `{OPERATORS[found[0]]}`"
    for found in CONSTANT.finditer(text, start, end):
        if float(found[0]) != 0:
            yield "constant", *found.span(), f"(4 * {found[0]})", f"`{found[0]}` four times"
    for found in CLAMP.finditer(text, start, end):
        spans, closed = arguments(text, found.end())
        if 2 <= len(spans) and closed < end:
            kept = next((span for span in spans if not is_constant(part(span))), spans[0])
            yield "clamp", found.start(), closed + 1, f"({part(kept)})", f"no `{found[1]}`"
    for found in CALL.finditer(text, start, end):
        spans, closed = arguments(text, found.end())
        if len(spans) == 2 and closed < end and part(spans[0]) != part(spans[1]):
            yield "arguments", found.end(), closed, f"{part(spans[1])}, {part(spans[0])}", f"arguments of `{found[0][:-1]}` swapped"


def sites(file, source):
    text, code = masked(source), masked(source, also_strings=False)
    for start, end in expressions(text):
        for kind, begin, stop, put, what in changes(text, start, end):
            if '"' in code[begin:stop]:
                continue
            line = source.count("\n", 0, start) + 1
            yield Site(file, line, start, end, code[start:begin] + put + code[stop:end], kind, what)
