#!/usr/bin/env python3
"""Films, sheets, tables as faces and experiments: made_test.py MIEN SOURCE"""
import csv
import io
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
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
        for map in (None, file):
            with self.assertRaisesRegex(mien.Error, "label: goes with a map"):
                mien.chernoff(TABLE, map, label="who")
        self.assertFalse((mien.chernoff(TABLE, rules, cell=32, style="ink").pixels == by_list.pixels).all())

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
        self.assertEqual([set(row) for row in made.table][0], {"file", *made.records[0]["levels"], "displacement"})
        self.assertTrue(any(isinstance(value, float) for value in list(made.table[0].values())[1:-1]))
        self.assertEqual((len(made), len(made.files), made.records[2]["levels"]), (3, 3, {"joy": "1"}))
        self.assertTrue(all(_png.pixels(file.read_bytes()).shape == (32, 32, 4) for file in made.files))
        again = mien.stimuli(made.manifest, self.folder / "again")
        self.assertEqual([one["sha256"] for one in again.records], [one["sha256"] for one in made.records])
        self.assertIn("3 pictures", repr(again))


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
