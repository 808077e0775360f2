#!/usr/bin/env python3
"""Films, sheets, tables as faces and experiments: made_test.py MIEN SOURCE"""
import csv
import hashlib
import io
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings
import zlib

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
from mien import _command, _film, _png

ROOT = pathlib.Path(sys.argv.pop())
os.environ["MIEN_COMMAND"] = MIEN = sys.argv.pop()
PERSON = mien.from_code("A66CB-AA5S0-14")
try:
    from PIL import Image
except ImportError:
    Image = None
TABLE = {"who": ["a", "b", "c"], "joy": [1, 2, 3], "size": [9.5, 2.5, 4]}


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def without_command(self):
        """A machine on which there is none."""
        path, said = os.environ["PATH"], os.environ["MIEN_COMMAND"]
        os.environ["MIEN_COMMAND"] = "/no/mien"
        self.addCleanup(os.environ.update, {"PATH": path, "MIEN_COMMAND": said})


class Pngs(unittest.TestCase):
    def test_are_read_whatever_their_filters(self):
        random = numpy.random.default_rng(3)
        for channels in (3, 4):
            wanted = random.integers(0, 256, (7, 11, channels), numpy.uint8)
            wanted[2:5] = wanted[1]
            rows, before = [], numpy.zeros((11, channels), int)
            for y, row in enumerate(wanted.astype(int)):
                left, corner = (numpy.concatenate([numpy.zeros((1, channels), int), one[:-1]]) for one in (row, before))
                guess = left + before - corner
                nearest = numpy.argmin(abs(guess - numpy.stack([left, before, corner])), axis=0)
                paeth = numpy.choose(nearest, [left, before, corner])
                rows.append(bytes([y % 5]) + (row - (0, left, before, (left + before) // 2, paeth)[y % 5]).astype(numpy.uint8).tobytes())
                before = row
            chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
            raw = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 11, 7, 8, {3: 2, 4: 6}[channels], 0, 0, 0)) \
                + chunk(b"IDAT", zlib.compress(b"".join(rows))) + chunk(b"IEND", b"")
            read = _png.pixels(raw)
            numpy.testing.assert_array_equal(read[..., :channels], wanted)
            self.assertTrue(channels == 4 or (read[..., 3] == 255).all())
            numpy.testing.assert_array_equal(_png.pixels(_png.png(read)), read)


class Sheets(Folder):
    def test_hold_faces_poses_codes_and_pictures(self):
        posed, ada = PERSON.pose(yaw=20), mien.from_seed("ada")
        made = mien.sheet([PERSON, posed, ada.code, ada.render(24)], cell=24, columns=3, gap=2, gap_color="red")
        self.assertEqual(made.pixels.shape, (50, 76, 4))
        numpy.testing.assert_array_equal(made.pixels[:24, 26:50], posed.render(24))
        numpy.testing.assert_array_equal(made.pixels[26:, :24], ada.render(24))
        self.assertEqual({tuple(one) for one in made.pixels[24:26].reshape(-1, 4)}, {(255, 0, 0, 255)})
        self.assertEqual(mien.sheet([PERSON] * 5, cell=8).pixels.shape, (16, 24, 4))
        numpy.testing.assert_array_equal(numpy.asarray(made), made.pixels)
        numpy.testing.assert_array_equal(_png.pixels(made._repr_png_()), made.pixels)
        made.save(self.folder / "a.png")
        memory = io.BytesIO()
        made.save(memory)
        self.assertEqual(memory.getvalue(), (self.folder / "a.png").read_bytes())
        numpy.testing.assert_array_equal(_png.pixels(memory.getvalue()), made.pixels)
        self.assertEqual(repr(made), "<mien.Picture: 76 x 50>")

    def test_refuse_what_is_none(self):
        for call, error, words in ((lambda: mien.sheet("ada"), TypeError, "list of faces"), (lambda: mien.sheet(PERSON), TypeError, "list of faces"),
                                   (lambda: mien.sheet([7]), TypeError, "faces, posed faces or codes"), (lambda: mien.sheet([]), mien.Error, "one face or more"),
                                   (lambda: mien.sheet([PERSON], columns=0), mien.Error, "columns"), (lambda: mien.sheet([PERSON], gap=-1), mien.Error, "gap"),
                                   (lambda: mien.sheet([numpy.zeros((3, 3))]), TypeError, "uint8"), (lambda: mien.sheet([PERSON], cel=9), TypeError, "cel"),
                                   (lambda: mien.sheet([PERSON]).save(self.folder / "a.gif"), mien.Error, "gif")):
            with self.assertRaisesRegex(error, words):
                call()


class Words(Folder):
    def test_unknown_ones_are_told_by_who_was_called(self):
        for call, words in ((lambda: mien.sheet([PERSON], cols=2), 'sheet: .*; say columns='), (lambda: mien.sheet([PERSON], backgruond="red"), 'sheet: .*did you mean "background"'),
                            (lambda: PERSON.animate(duration=2), 'animate: .*; say seconds=')):
            with self.assertRaisesRegex(TypeError, words):
                call()
        for call, words in ((lambda: PERSON.animate(seconds=0), "seconds: expected more than 0"), (lambda: PERSON.render(0), "size: expected 1 pixel or more, got 0")):
            with self.assertRaisesRegex(mien.Error, words):
                call()


class Films(Folder):
    def test_are_of_every_kind(self):
        for kind, begin in (("apng", b"\x89PNG"), ("png", b"\x89PNG"), ("gif", b"GIF89a"), ("webp", b"RIFF"), ("mp4", None), ("webm", b"\x1a\x45\xdf\xa3")):
            if kind in ("mp4", "webm") and not shutil.which("ffmpeg"):
                continue
            for pose in ({"emotion": "joy", "yaw": 10, "clip": "idle", "seed": "x", "look_at": (1, 0, 9)}, lambda time: {"yaw": 60 * time}):
                if callable(pose) and kind in ("gif", "webp") and not Image:
                    continue
                film = PERSON.animate(self.folder / f"a.{kind}", frames=3, fps=10, size=24, pose=pose)
                raw = (self.folder / f"a.{kind}").read_bytes()
                self.assertTrue(bytes(film) == raw and (begin is None or raw.startswith(begin)), kind)
                self.assertIn(f"{kind}, {len(raw)} bytes", repr(film))
                self.assertTrue(film._repr_mimebundle_())

    def test_in_apng_have_all_frames_and_times_that_do_not_drift(self):
        raw = bytes(PERSON.animate(frames=7, fps=30, size=24, background="transparent", pose=lambda time: {"time": None, "blink": float(0.06 < time < 0.15)}))
        at, delays, parts = 8, [], []
        while at < len(raw):
            size, name = struct.unpack(">I4s", raw[at:at + 8])
            data = raw[at + 8:at + 8 + size]
            self.assertEqual(struct.unpack(">I", raw[at + 8 + size:at + 12 + size])[0], zlib.crc32(name + data))
            if name == b"fcTL":
                delays.append(struct.unpack(">HH", data[20:24]))
            parts.append(name)
            at += 12 + size
        self.assertEqual(parts, [b"IHDR", b"sRGB", b"acTL", b"fcTL", b"IDAT", b"fcTL", b"fdAT", b"fcTL", b"fdAT", b"IEND"])
        self.assertEqual(delays, [(67, 1000), (100, 1000), (66, 1000)])  # 2, 3 and 2 frames of a thirtieth
        if Image:
            film = Image.open(io.BytesIO(raw))
            shown = []
            for i in range(film.n_frames):
                film.seek(i)
                shown.append(numpy.asarray(film.convert("RGBA")))
            for frame, blink in zip(shown, (0, 1, 0), strict=True):
                numpy.testing.assert_array_equal(frame, PERSON.pose(blink=blink).render(24, background="transparent"))

    def test_by_the_command_and_by_pillow_are_alike(self):
        if not Image:
            return
        words = {"frames": 3, "fps": 10, "size": 32, "pose": {"emotions": {"joy": 0.5}, "yaw": 10}}
        PERSON.animate(self.folder / "a.webp", **words)
        self.without_command()
        PERSON.animate(self.folder / "b.webp", **words)
        for one, other in zip(*(self.frames_of(self.folder / name) for name in ("a.webp", "b.webp")), strict=True):
            self.assertLess(numpy.abs(one.astype(int) - other).mean(), 6)  # the command's may lose a little

    def frames_of(self, file):
        film, shown = Image.open(file), []
        for i in range(film.n_frames):
            film.seek(i)
            shown.append(numpy.asarray(film.convert("RGB")))
        return shown

    def test_last_as_long_as_their_motions(self):
        def count(**words):
            return sum(name == b"fcTL" for name in self.chunks(bytes(PERSON.animate(fps=10, size=8, **words))))
        track = mien.read_motion_text("0\tsil\n0.2\taa\n0.4\tm\n0.6\tsil\n", "a.tsv")
        shown = {"background": "transparent"}
        frames = []
        with unittest.mock.patch.object(mien.Face, "frames", lambda face, count, *size, **how: frames.append(count) or iter([numpy.zeros((2, 2, 4), numpy.uint8)])):
            for pose in ({"motions": track}, {"motions": [track]}, {"motions": [(track, 1)]}, {"motions": [track, (track, 0.5, 1)]}, {"motions": []}, {}, None, lambda time: {"motions": track},
                         {"motions": None}):
                PERSON.animate(fps=10, size=8, pose=pose)
            PERSON.animate(fps=10, size=8, pose={"motions": track}, seconds=1)
            PERSON.animate(fps=10, size=8, pose={"motions": track}, begin=0.5)
            PERSON.animate(fps=10, size=8, pose={"motions": track}, begin=99)
        spoken = math.ceil(track.length * 10)
        self.assertEqual(frames, [spoken, spoken, spoken, math.ceil((1 + track.length) * 10), 20, 20, 20, 20, 20, 10, math.ceil((track.length - 0.5) * 10), 1])
        (self.folder / "a.tsv").write_text("0\tsil\n0.2\taa\n0.4\tm\n0.6\tsil\n")
        said = subprocess.run([MIEN, "animate", "toon", "--speech", self.folder / "a.tsv", "--fps", "10", "--size", "8", "-o", self.folder / "a.apng"], capture_output=True, text=True, check=True)
        self.assertTrue(said.stdout.startswith(f"{spoken} frames"), said.stdout)
        self.assertGreater(count(pose={"motions": track}, **shown), 2)

    def chunks(self, raw):
        at = 8
        while at < len(raw):
            size, name = struct.unpack(">I4s", raw[at:at + 8])
            yield name
            at += 12 + size

    def test_in_webp_may_lose_something(self):
        if not Image:
            return
        words = {"frames": 2, "fps": 10, "size": 64, "pose": {"yaw": 10}}
        sizes = [len(bytes(PERSON.animate(self.folder / "a.webp", quality=quality, **words))) for quality in (5, 90, None)]
        self.assertTrue(sizes[0] < sizes[1], sizes)
        PERSON.animate(self.folder / "a.webp", quality=90, **words)
        self.assertTrue((self.folder / "a.webp").read_bytes().count(b"VP8 ") >= 1)
        for call in (lambda: PERSON.animate(self.folder / "a.gif", quality=50, **words), lambda: PERSON.animate(quality=50, **words), lambda: PERSON.animate(self.folder / "b.webp", quality=0, **words),
                     lambda: PERSON.animate(self.folder / "b.webp", quality=101, **words)):
            with self.assertRaisesRegex(mien.Error, "quality: is 1 to 100, of .webp alone"):
                call()
        self.assertEqual(os.listdir(self.folder), ["a.webp"])

    def test_of_what_is_not_said_are_those_of_the_rest(self):
        PERSON.animate(self.folder / "a.gif", frames=1, size=16, pose={"yaw": 10, "emotion": None, "clips": None, "blink": None})
        PERSON.animate(self.folder / "b.gif", frames=1, size=16, pose={"yaw": 10})
        self.assertEqual((self.folder / "a.gif").read_bytes(), (self.folder / "b.gif").read_bytes())
        for call in (lambda: PERSON.animate(frames=1, size=16, dtype="float32"), lambda: mien.sheet([PERSON], dtype="float32")):
            with self.assertRaisesRegex(TypeError, 'no argument named "dtype"'):
                call()

    def test_say_what_is_missing(self):
        self.without_command()
        hidden = dict.fromkeys(("PIL", "PIL.Image", "PIL.features"))
        before = {name: sys.modules.get(name) for name in hidden}
        sys.modules.update(hidden)
        self.addCleanup(lambda: [sys.modules.pop(name) if old is None else sys.modules.__setitem__(name, old) for name, old in before.items()])
        with self.assertRaisesRegex(mien.Error, r"\.gif: needs the command mien .*, or Pillow \(pip install pillow\); \.apng needs neither"):
            PERSON.animate(self.folder / "a.gif", frames=1, size=16)
        with self.assertRaisesRegex(ImportError, "pip install pillow"):
            PERSON.to_pil(16)
        os.environ["PATH"] = "/no"
        with self.assertRaisesRegex(mien.Error, r"\.mp4: needs ffmpeg"):
            PERSON.animate(self.folder / "a.mp4", frames=1, size=16)
        with self.assertRaisesRegex(mien.Error, "chernoff: needs the command mien .*MIEN_COMMAND"):
            mien.chernoff(TABLE)
        self.assertEqual(len(bytes(PERSON.animate(frames=1, size=16))) > 100, True)
        os.environ["MIEN_COMMAND"] = MIEN
        with self.assertRaisesRegex(mien.Error, "by a function"):
            PERSON.animate(self.folder / "a.gif", frames=1, size=16, pose=lambda time: {})
        self.assertEqual(os.listdir(self.folder), [])

    def test_refuse_what_is_none(self):
        for call, error, words in ((lambda: PERSON.animate(self.folder / "a.xyz"), mien.Error, "no film is .xyz"), (lambda: PERSON.animate(self.folder / "a"), mien.Error, "ends with .gif"),
                                   (lambda: PERSON.animate(frames=0), mien.Error, "1 or more"), (lambda: PERSON.animate(frames=1, seconds=1), mien.Error, "one of them"),
                                   (lambda: PERSON.animate(fps=0), mien.Error, "fps"), (lambda: PERSON.animate(seconds="long"), TypeError, "seconds"),
                                   (lambda: PERSON.animate(self.folder / "a.gif", sound="a.wav"), mien.Error, "sound"), (lambda: mien.animate("ada"), TypeError, "expected a face"),
                                   (lambda: PERSON.animate(self.folder / "a.gif", frames=1, size=16, pose={"emotions": "joy"}), TypeError, "emotions"),
                                   (lambda: PERSON.animate(self.folder / "a.gif", frames=1, size=16, pose={"emotion": "happy"}), mien.Error, "joy")):
            with self.assertRaisesRegex(error, words):
                call()

    def test_of_another_version_are_not_drawn_by_its_command(self):
        self.assertEqual(_command.found(), MIEN)
        other = self.folder / "mien"
        shutil.copy("/bin/echo", other)  # which says "--version" or the like
        os.environ["MIEN_COMMAND"] = str(other)
        self.addCleanup(os.environ.update, {"MIEN_COMMAND": MIEN})
        self.assertIsNone(_command.found())


class Tables(Folder):
    def test_become_faces_whatever_holds_them(self):
        class Frame:  # what this package asks of pandas
            columns = list(TABLE)

            def itertuples(self, index, name):
                assert (index, name) == (False, None)
                return iter(zip(*TABLE.values()))

        class Lazy:  # and of polars
            columns = list(TABLE)

            def iter_rows(self):
                return iter(zip(*TABLE.values()))

        rows = [dict(zip(TABLE, row)) for row in zip(*TABLE.values())]
        file = self.folder / "table.csv"
        with open(file, "w", newline="") as out:
            csv.writer(out).writerows([list(TABLE), *zip(*TABLE.values())])
        structured = numpy.array(list(zip(*TABLE.values())), [("who", "U1"), ("joy", int), ("size", float)])
        wanted = mien.chernoff(TABLE, cell=32, columns=2)
        self.assertEqual((wanted.pixels.shape[1], len(wanted.manifest)), (64, 3))
        self.assertEqual([one["face"] for one in wanted.manifest], TABLE["who"])
        for data in (Frame(), Lazy(), rows, iter(rows), file, str(file), structured, {name: numpy.array(of) for name, of in TABLE.items()}):
            numpy.testing.assert_array_equal(mien.chernoff(data, cell=32, columns=2).pixels, wanted.pixels)
        subprocess.run([MIEN, "chernoff", file, "-o", self.folder / "a.png", "--cell", "32", "--columns", "2"], check=True)
        numpy.testing.assert_array_equal(_png.pixels((self.folder / "a.png").read_bytes()), wanted.pixels)
        self.assertGreater(wanted.legend.pixels.shape[0], 32)
        self.assertIn("Chernoff", repr(wanted))

    def test_have_maps(self):
        rules = [{"column": "joy", "emotion": "joy"}]
        by_list = mien.chernoff(TABLE, rules, cell=32)
        numpy.testing.assert_array_equal(mien.chernoff(TABLE, {"map": rules}, cell=32).pixels, by_list.pixels)
        file = self.folder / "map.json"
        file.write_text(json.dumps({"format": "mien-chernoff", "format_version": 1, "map": rules}))
        numpy.testing.assert_array_equal(mien.chernoff(TABLE, file, cell=32).pixels, by_list.pixels)
        self.assertEqual([one["face"] for one in mien.chernoff(TABLE, rules, label="who", cell=32).manifest], TABLE["who"])
        self.assertEqual([one["face"] for one in mien.chernoff(TABLE, {"map": rules}, label="who", cell=32).manifest], TABLE["who"])
        with self.assertRaisesRegex(mien.Error, "label: goes with no map that is a file"):
            mien.chernoff(TABLE, file, label="who")
        self.assertFalse((mien.chernoff(TABLE, rules, cell=32, style="ink").pixels == by_list.pixels).all())

    def test_have_labels_without_a_map(self):
        table = {"id": [7, 8, 9], "kind": ["x", "y", "z"], **TABLE}
        columns = ["brow.tilt", "eye.size"]
        file = self.folder / "table.csv"
        with open(file, "w", newline="") as out:
            csv.writer(out, delimiter=";").writerows([list(table), *zip(*table.values())])
        for data in (table, file):
            for label in ("who", "id", "joy"):
                moved = [name for name in ("id", "joy", "size") if name != label]
                made = self.quiet(data, label=label)
                rules = [{"column": name, "number": number} for name, number in zip(moved, [*columns, "smile"])]
                numpy.testing.assert_array_equal(made.pixels, mien.chernoff(data, rules, label=label, cell=32).pixels)
                self.assertEqual([one["face"] for one in made.manifest], [str(one) for one in table[label]])
                self.assertEqual(list(made.manifest[0])[1:-1:2], moved)
        numpy.testing.assert_array_equal(mien.chernoff(TABLE, label="who", cell=32).pixels, mien.chernoff(TABLE, cell=32).pixels)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            mien.chernoff({**table, "gap": [1, None, 2]}, label="who", cell=32)
        self.assertEqual(sorted(str(one.message) for one in told), ['data:3: column "gap": the number is missing: the column is not shown'])
        self.assertEqual({pathlib.Path(one.filename).name for one in told}, {"made_test.py"})
        for call, words in ((lambda: mien.chernoff(TABLE, label="whoo"), '^label: data has no column named "whoo"; did you mean "who"'),
                            (lambda: mien.chernoff(TABLE, [{"column": "joy", "number": "smile"}], label="whoo"), '^label: data has no column'),
                            (lambda: mien.chernoff({"a": [1, 2]}, label="a"), "label: 'a' is the one column of numbers"), (lambda: mien.chernoff({"who": ["a"]}, label="who"), "no column of numbers")):
            with self.assertRaisesRegex(mien.Error, words):
                call()
        with self.assertRaisesRegex(FileNotFoundError, "no.csv"):
            mien.chernoff("no.csv", label="a")

    def quiet(self, data, **words):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", mien.Warned)
            return mien.chernoff(data, cell=32, **words)

    def test_warn_of_what_is_missing(self):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            mien.chernoff({**TABLE, "size": [1, None, float("nan")]}, cell=32)
        self.assertEqual([one.category for one in told], [mien.Warned])
        self.assertEqual(pathlib.Path(told[0].filename).name, "made_test.py")  # it points at who called
        self.assertRegex(str(told[0].message), '^data:3: column "size": the number is missing')
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(mien.Warned):
                mien.chernoff({**TABLE, "size": [1, None, 2]}, cell=32)

    def test_refuse_what_is_none(self):
        for call, error, words in ((lambda: mien.chernoff(7), TypeError, "data: expected a data frame"), (lambda: mien.chernoff([1, 2]), TypeError, "data frame"),
                                   (lambda: mien.chernoff({"a": [1], "b": [1, 2]}), mien.Error, "columns of one length"), (lambda: mien.chernoff({"a": "text"}), TypeError, "a list of values"),
                                   (lambda: mien.chernoff(TABLE, [{"column": "jy", "emotion": "joy"}]), mien.Error, "map"), (lambda: mien.chernoff(TABLE, 7), TypeError, "map: expected"),
                                   (lambda: mien.chernoff(TABLE, {"map": [object()]}), TypeError, "JSON"), (lambda: mien.chernoff(TABLE, style="inc"), mien.Error, "ink"),
                                   (lambda: mien.chernoff(TABLE, cel=3), TypeError, 'did you mean "cell"'), (lambda: mien.chernoff("no.csv"), FileNotFoundError, "no.csv"),
                                   (lambda: mien.stimuli("no.json", self.folder), FileNotFoundError, "no.json"),
                                   (lambda: mien.chernoff({}), mien.Error, ""), (lambda: mien.stimuli(7, "x"), TypeError, "plan"),
                                   (lambda: mien.stimuli({"factors": [{"name": "a", "emotion": "jy"}]}, self.folder), mien.Error, "^plan")):
            with self.assertRaisesRegex(error, words):
                call()


class Experiments(Folder):
    def test_are_drawn_and_drawn_again(self):
        plan = {"size": 32, "factors": [{"name": "joy", "emotion": "joy", "steps": numpy.int64(3)}]}
        made = mien.stimuli(plan, self.folder / "shown")
        self.assertEqual([set(row) for row in made.table][0], {"file", *made.records[0]["levels"], "displacement", "sha256"})
        self.assertTrue(any(isinstance(value, float) for value in list(made.table[0].values())[1:-1]))
        self.assertEqual((len(made), len(made.files), made.records[2]["levels"]), (3, 3, {"joy": "1"}))
        self.assertTrue(all(_png.pixels(file.read_bytes()).shape == (32, 32, 4) for file in made.files))
        again = mien.stimuli(made.manifest, self.folder / "again")
        self.assertEqual([one["sha256"] for one in again.records], [one["sha256"] for one in made.records])
        self.assertIn("3 pictures", repr(again))
        self.assertEqual(mien.Stimuli(str(self.folder / "shown")).table, made.table)

    def test_have_a_table_in_a_file(self):
        plan = {"size": 16, "factors": [{"name": "file", "emotion": "joy", "values": [0, 0.5]}, {"name": "hair", "part": "hair", "values": ["bob", "afro"]}]}
        made = mien.stimuli(plan, self.folder / "shown")
        made.save(self.folder / "table.csv")
        with open(self.folder / "table.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["file", "factor.file", "hair", "displacement", "sha256"])
        self.assertEqual([one["file"] for one in rows], [file.name for file in made.files])
        self.assertEqual([one["sha256"] for one in rows], [hashlib.sha256(file.read_bytes()).hexdigest() for file in made.files])
        self.assertEqual({(float(one["factor.file"]), one["hair"]) for one in rows}, {(0, "bob"), (0, "afro"), (0.5, "bob"), (0.5, "afro")})
        self.assertEqual([float(one["displacement"]) for one in rows], [one["displacement"] for one in made.table])
        memory = io.BytesIO()
        made.save(memory)
        self.assertEqual(memory.getvalue(), (self.folder / "table.csv").read_bytes())
        before = sorted(os.listdir(self.folder))
        for call, error, words in ((lambda: made.save(self.folder / "table.xlsx"), mien.Error, "ends with .csv"), (lambda: made.save(self.folder / "no/table.csv"), FileNotFoundError, "no/table.csv"),
                                   (lambda: made.save(io.StringIO()), TypeError, "takes bytes"), (lambda: mien.Stimuli(self.folder), FileNotFoundError, "manifest.json")):
            with self.assertRaisesRegex(error, words):
                call()
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_whole_or_not_at_all(self):
        file = self.folder / "table.csv"
        file.write_text("kept")
        with unittest.mock.patch("os.replace", side_effect=OSError(28, "No space left on device")), self.assertRaisesRegex(mien.FileError, "table.csv: cannot be written"):
            mien.stimuli({"size": 16, "factors": [{"name": "joy", "emotion": "joy", "steps": 2}]}, self.folder / "shown").save(file)
        with unittest.mock.patch("os.replace", side_effect=OSError(28, "No space left on device")):
            for call in (lambda: mien.fit_basis(numpy.eye(3), components=1).save(file), lambda: PERSON.animate(file, format="apng", frames=1, size=8), lambda: PERSON.save(file, 8, format="svg")):
                with self.assertRaisesRegex(mien.FileError, "table.csv: cannot be written"):
                    call()
        self.assertEqual((file.read_text(), sorted(os.listdir(self.folder))), ("kept", ["shown", "table.csv"]))


class Command(Folder):
    def test_is_run_by_python(self):
        said = subprocess.run([sys.executable, "-m", "mien", "--version"], capture_output=True, text=True)
        self.assertEqual(said.stdout.strip(), f"mien {mien.__version__}")
        self.assertEqual(subprocess.run([sys.executable, "-m", "mien", "nothing"], capture_output=True).returncode, 2)
        missing = subprocess.run([sys.executable, "-m", "mien"], capture_output=True, text=True, env={**os.environ, "MIEN_COMMAND": "/no/mien"})
        self.assertEqual((missing.returncode, missing.stdout), (1, ""))
        self.assertRegex(missing.stderr, "^python -m mien: needs the command mien .*\n$")


if __name__ == "__main__":
    assert _film
    unittest.main(argv=sys.argv)
