"""What faces are made of: texts, which can be compared, pickled, and made into faces again."""
from __future__ import annotations

import contextlib
import functools
import json
import os
import pathlib
import stat
import tempfile
from typing import Any, Iterator, Mapping, Optional, Union

from ._errors import Error, reading
from ._kinds import said
from ._library import Handle, lib, path_bytes, texts, unknown_name, utf8

PICKLED_AS = 1  # the kind of a face's pickle; others are refused


class Source:
    """The text of a face's file, the parts of one's own that lie beside it, and what was added to it since. Never changes."""

    def __init__(self, text: Optional[bytes], name: str, code: Optional[str] = None, beside: Optional[Mapping[str, bytes]] = None,
                 morphs: "tuple[tuple[str, bytes], ...]" = ()) -> None:
        self.by_code = text is None
        self._text = text  # of a person by code her recipe, once somebody has asked for it
        self.name = name
        self._code = code
        self.beside = dict(beside or {})
        self.morphs = morphs

    @property
    def text(self) -> bytes:
        if self._text is None:
            self._text = texts(lib.mien_recipe_from_code, *utf8(self._code or ""))[0].encode()
        return self._text

    @functools.cached_property
    def tree(self) -> "dict[str, Any]":
        """What the text says; nothing where Python's JSON reads less than mien's does."""
        try:
            found = json.loads(self.text)
        except ValueError:
            return {}
        return found if isinstance(found, dict) else {}

    @property
    def is_recipe(self) -> bool:
        return self.tree.get("format_version") == 2

    @functools.cached_property
    def code(self) -> Optional[str]:
        """The code that draws the same person, whatever she is painted with."""
        code = self.tree.get("code")
        if self.beside or self.morphs or not self.is_recipe or not isinstance(code, str):
            return None
        if self.by_code:
            return code
        try:
            whole = json.loads(texts(lib.mien_recipe_from_code, *utf8(code))[0])
        except Error:
            return None
        return code if all(whole.get(key) == self.tree.get(key) for key in ("parts", "numbers", "edition")) else None

    @functools.cached_property
    def key(self) -> "tuple[Any, ...]":
        """Equal of equal faces: spaces and the order of a text's keys do not matter."""
        plain = json.dumps(self.tree, sort_keys=True).encode() if self.tree else self.text
        return plain, tuple(sorted(self.beside.items())), tuple(raw for _, raw in self.morphs)

    def state(self) -> "dict[str, Any]":
        """For a pickle: plain texts, no addresses of this machine but the file's name in errors."""
        state = {"kind": PICKLED_AS, "version": lib.mien_version_text().decode(), "name": self.name, "beside": self.beside, "morphs": self.morphs}
        return {**state, "code": self._code} if self.by_code else {**state, "text": self.text}

    def with_more(self, name: str, morphs: bytes) -> "Source":
        """The same with the morph targets of another file."""
        return Source(None if self.by_code else self.text, self.name, self._code, self.beside, (*self.morphs, (name, morphs)))

    def styled(self, style: str) -> "Source":
        """The same person, painted in another style."""
        known = texts(lib.mien_part_styles)
        if not isinstance(style, str) or style not in known:
            raise Error("style", unknown_name("style", str(style), known))
        if not self.is_recipe:
            raise Error("style", f"{self.name} is a face in full: people by code and recipes can be painted in another style")
        text = json.dumps({**self.tree, "style": style}, ensure_ascii=False)
        return Source(text.encode(), self.name, None, self.beside, self.morphs)

    def handle(self) -> Handle:
        """A face of the library's."""
        if self.by_code:
            made = Handle(lib.mien_face_free, lib.mien_face_from_code, *utf8(self._code or ""))
        elif not self.beside:
            made = Handle(lib.mien_face_free, lib.mien_face_read_text, self.text, len(self.text), *utf8(self.name))
        else:
            with self.in_file() as file:
                made = Handle(lib.mien_face_free, lib.mien_face_read, *path_bytes(file))
        for name, raw in self.morphs:
            made = Handle(lib.mien_face_free, lib.mien_face_with_morphs_text, made.value, raw, len(raw), *utf8(name))
        return made

    @contextlib.contextmanager
    def in_file(self) -> Iterator[str]:
        """A path of its file, or its code, for the command; parts of one's own lie beside it, since there they are looked for."""
        if self.by_code:
            yield self._code or ""
            return
        with tempfile.TemporaryDirectory(prefix="mien-") as folder:
            # Parts may lie above the recipe, "../hair.part.json": a level of folders for each.
            depth = max([pathlib.PurePath(name).parts.count("..") for name in self.beside], default=0)
            place = pathlib.Path(folder, *["d"] * depth)
            place.mkdir(parents=True, exist_ok=True)
            for name, raw in self.beside.items():
                file = pathlib.Path(os.path.normpath(place / name))
                if pathlib.Path(folder) not in file.parents:
                    raise Error(self.name, f"the part {name!r} lies outside of the recipe's folder")
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_bytes(raw)
            recipe = place / "recipe.face.json"
            recipe.write_bytes(self.text)
            yield str(recipe)


def source_of(state: Any) -> Source:
    """That of a pickle."""
    if not isinstance(state, dict) or state.get("kind") != PICKLED_AS:
        kind = state.get("kind") if isinstance(state, dict) else None
        by = f" by mien {state['version']}" if isinstance(state, dict) and "version" in state else ""
        version = lib.mien_version_text().decode()
        raise Error("pickle", f"of kind {said(kind)}{by}, and mien {version} reads kind {PICKLED_AS}; face.text and face.code go from one to another")
    return Source(state.get("text"), state["name"], state.get("code"), state["beside"], tuple(state["morphs"]))


def read(path: "str | os.PathLike[str]") -> "tuple[Handle, Source]":
    """The face of a file, and its source. A pipe is read once."""
    raw, name = path_bytes(path)[0], os.fspath(path)
    with reading(path, _hint(str(name))):
        if _is_pipe(path):
            source = Source(pathlib.Path(path).read_bytes(), str(name))
            return source.handle(), source
        made = Handle(lib.mien_face_free, lib.mien_face_read, raw, len(raw))
        source = Source(pathlib.Path(path).read_bytes(), str(name))
        folder = pathlib.Path(path).parent
        beside = {one: (folder / one).read_bytes() for one in _own_parts(source.tree)}
    return made, Source(source.text, str(name), None, beside)


def _is_pipe(path: "str | os.PathLike[str]") -> bool:
    try:
        return stat.S_ISFIFO(os.stat(path).st_mode)
    except OSError:
        return False


def _own_parts(tree: Mapping[str, Any]) -> "list[str]":
    parts: Union[Mapping[str, Any], Any] = tree.get("parts")
    values = parts.values() if isinstance(parts, dict) else ()
    named = [one.get("part") if isinstance(one, dict) else one for one in values]
    return sorted({one for one in named if isinstance(one, str) and one.endswith(".json")})


def _hint(name: str) -> str:
    """What a word that is no file's may be."""
    if name.count("-") >= 2 and name.replace("-", "").isalnum() and len(name) >= 14:
        return f"; if it is a code: mien.from_code({name!r})"
    if name.isidentifier():
        return f"; samples are mien.sample({name!r}), and people by a word mien.from_seed({name!r})"
    return ""
