#!/usr/bin/env python3
"""Faces are kept: compared, copied, pickled, sent to other processes, written into files of every kind: kept_test.py SOURCE"""
import concurrent.futures
import copy
import io
import multiprocessing
import os
import pathlib
import pickle
import sys
import tempfile
import unittest

try:
    import numpy
except ImportError:
    print("needs python3-numpy: tools/setup --dev")
    sys.exit(77)

import mien
from mien import people

ROOT = pathlib.Path(sys.argv.pop()) if len(sys.argv) > 1 else pathlib.Path()
COMPAT = ROOT / "faces/compat/toon.face.json"
CODE = "A66CB-AA5S0-14"
TRACK = "0\tsil\n0.2\tm\n0.4\tɑː\n0.8\t\n"


def drawn(face):
    return face.render(32).tobytes()


class Faces(unittest.TestCase):
    def test_tell_what_they_are_of(self):
        ada = mien.from_seed("ada")
        self.assertEqual((ada.code, ada.recipe, ada.style), (people.code("ada"), people.recipe(people.code("ada")), "soft"))
        self.assertEqual(mien.from_code(CODE.lower()).code, CODE)
        self.assertEqual(mien.read_face_text(ada.recipe).code, ada.code)
        changed = ada.recipe.replace('"narrow"', '"round"')
        self.assertNotEqual(changed, ada.recipe)
        self.assertIsNone(mien.read_face_text(changed).code)
        toon, flat = mien.sample("toon"), mien.read_face(COMPAT)
        self.assertEqual((toon.code, toon.style), (None, "soft"))
        self.assertEqual((flat.code, flat.recipe, flat.style, flat.text), (None, None, None, COMPAT.read_text(encoding="utf-8")))
        self.assertEqual(mien.Face.from_seed("ada"), mien.Face.from_code(ada.code))

    def test_have_styles_and_what_is_held(self):
        for style in people.styles():
            face = mien.from_code(CODE, style=style)
            self.assertEqual((face.style, face.code), (style, CODE))
        self.assertEqual(mien.from_code(CODE).with_style("ink"), mien.from_code(CODE, style="ink"))
        self.assertNotEqual(drawn(mien.from_code(CODE, style="ink")), drawn(mien.from_code(CODE)))
        self.assertEqual(mien.sample("toon").with_style("ink").style, "ink")  # which has parts of her own beside her
        held = mien.from_seed("ada", hold={"hair": "bob", "age": 30})
        self.assertIn('"hair": "bob"', held.recipe)
        self.assertEqual(held.code, people.hold(people.code("ada"), "hair=bob", "age=30"))
        for call, words in ((lambda: mien.from_code(CODE, style="inc"), 'no style named "inc"; did you mean "ink"'),
                            (lambda: mien.from_code(CODE, style="7"), "style"), (lambda: mien.read_face(COMPAT).with_style("ink"), "in full"),
                            (lambda: mien.from_seed("ada", hold={"hari": "bob"}), 'did you mean "hair"')):
            with self.assertRaisesRegex(mien.Error, words):
                call()
        with self.assertRaisesRegex(TypeError, "parts and numbers by name"):
            mien.from_seed("ada", hold="hair=bob")
        with self.assertRaisesRegex(TypeError, 'no argument named "stlye"; did you mean "style"'):
            mien.from_code(CODE, stlye="ink")

    def test_are_equal_where_their_texts_say_the_same(self):
        one, other = mien.from_code(CODE), mien.from_code(CODE)
        self.assertEqual(one, other)
        self.assertEqual(len({one, other, mien.read_face_text(one.recipe), mien.read_face_text(one.recipe.replace("\n", "\n\n"))}), 1)
        self.assertNotEqual(one, mien.from_code(CODE, style="ink"))
        self.assertNotEqual(one, mien.from_seed("ada"))
        self.assertNotEqual(one, CODE)
        self.assertEqual(one.pose(yaw=5), other.pose(set={"yaw": 5}))
        self.assertNotEqual(one.pose(yaw=5), one.pose(yaw=6))
        self.assertEqual(hash(one.pose()), hash(other.pose()))

    def test_are_pickled_and_copied(self):
        rest = mien.read_face(COMPAT)
        other = mien.read_face_text(rest.text.replace('"skin": "#f6c3a0"', '"skin": "#204a87"'))
        morphed = rest.with_morphs_text(rest.morphs_text({"blue": other}))
        track, basis = mien.read_motion_text(TRACK, "a.tsv"), rest.fit_basis(4, components=2)
        person = mien.from_code(CODE)
        for one in (person, mien.from_code(CODE, style="ink"), mien.sample("toon"), mien.sample("bruno").with_style("flat"), rest, morphed,
                    morphed.pose(set={"blue": 0.5}), person.pose(emotion="joy", yaw=10, look_at=(1, 0, 9)), person.speak(track, 0.5),
                    rest.pose(basis=basis, weights=numpy.array([0.1, 0.2]))):
            for protocol in (2, pickle.HIGHEST_PROTOCOL):
                again = pickle.loads(pickle.dumps(one, protocol))
                self.assertEqual((type(again), again, drawn(again)), (type(one), one, drawn(one)))
            self.assertIs(copy.copy(one), one)
            self.assertIs(copy.deepcopy([one])[0], one)
        for one in (track, basis):
            self.assertEqual(pickle.loads(pickle.dumps(one)), one)
            self.assertIs(copy.deepcopy(one), one)
        self.assertEqual(pickle.loads(pickle.dumps(mien.Renderer())).stats.pixels, 0)
        self.assertLess(len(pickle.dumps(person)), 500)  # a code is enough
        for live in (mien.Steady(), person.follow({"jawOpen": 0.5}, steady=(mien.Steady(), 1))):
            with self.assertRaisesRegex(TypeError, "remembers"):
                pickle.dumps(live)

    def test_of_pickles_of_other_kinds_are_refused(self):
        make = mien.from_code(CODE).__reduce__()[0]
        for state in ({"kind": 2, "version": "9.1.0"}, {}, None, [], "face"):
            with self.assertRaisesRegex(mien.Error, "pickle: of kind .* reads kind 1"):
                make(state)
        with self.assertRaisesRegex(mien.Error, "by mien 9.1.0"):
            make({"kind": 2, "version": "9.1.0"})
        older = {**mien.from_code(CODE).__reduce__()[1][0], "version": "0.0.1"}
        self.assertEqual(make(older), mien.from_code(CODE))
        outside = {**mien.sample("toon").__reduce__()[1][0], "beside": {"/tmp/x.part.json": b"{}"}}
        with self.assertRaisesRegex(mien.Error, "outside"):
            make(outside)

    def test_go_to_other_processes(self):
        faces = [mien.from_code(CODE), mien.sample("toon")]
        with concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
            self.assertEqual(list(pool.map(drawn, faces, timeout=300)), [drawn(face) for face in faces])

    def test_say_what_they_are_in_one_line(self):
        posed = mien.from_code(CODE).pose(emotion="joy", yaw=20)
        self.assertEqual(repr(posed), f"<mien.Posed face-{CODE}: emotion='joy', yaw=20>")
        self.assertEqual(repr(mien.from_code(CODE).pose()), f"<mien.Posed face-{CODE}: at rest>")
        self.assertLess(len(repr(mien.from_code(CODE).pose(frame={"jawOpen": 0.123456789}, seed="x" * 500))), 300)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_are_paths_and_file_objects(self):
        posed = mien.from_code(CODE).pose()
        posed.save(self.folder / "a.png", 48)
        wanted = (self.folder / "a.png").read_bytes()
        memory = io.BytesIO()
        posed.save(memory, 48)
        self.assertEqual(memory.getvalue(), wanted)
        with open(self.folder / "b.png", "wb") as file:
            posed.save(file, 48)
        self.assertEqual((self.folder / "b.png").read_bytes(), wanted)
        posed.save(self.folder / "c", 48, format="png")
        self.assertEqual((self.folder / "c").read_bytes(), wanted)
        for kind, begin in (("jpg", b"\xff\xd8"), ("tif", b"II*"), ("svg", b"<svg ")):
            memory = io.BytesIO()
            posed.save(memory, 48, format=kind)
            self.assertTrue(memory.getvalue().startswith(begin), kind)
        mien.from_code(CODE).save(str(self.folder / "d.svg"), 48)
        self.assertEqual((self.folder / "d.svg").read_text(encoding="utf-8"), posed.svg(48).text)
        self.assertEqual(posed.svg(48)._repr_svg_(), posed.svg(48).text)

    def test_that_cannot_be_are_errors_of_the_system(self):
        face = mien.from_code(CODE)
        for call, kind in ((lambda: mien.read_face("no/such.json"), FileNotFoundError), (lambda: mien.read_motion("no.csv"), FileNotFoundError),
                           (lambda: mien.read_basis("no.basis"), FileNotFoundError), (lambda: face.with_morphs("no.json"), FileNotFoundError),
                           (lambda: face.save(self.folder / "no/a.png"), FileNotFoundError),
                           (lambda: face.save(self.folder / "no/a.svg"), FileNotFoundError), (lambda: mien.read_face(self.folder), OSError),
                           (lambda: face.animate(self.folder / "no/a.apng", frames=1, size=8), FileNotFoundError)):
            with self.assertRaises(kind) as caught:
                call()
            self.assertIsInstance(caught.exception, mien.Error)
            self.assertIsInstance(caught.exception, ValueError)
            again = pickle.loads(pickle.dumps(caught.exception))
            self.assertEqual((str(again), again.errno, again.filename), (str(caught.exception), caught.exception.errno, caught.exception.filename))
            self.assertTrue(again.errno and str(again).startswith(again.where))
        for word, hint in (("toon", "mien.sample('toon')"), (CODE, "mien.from_code")):
            with self.assertRaises(FileNotFoundError) as caught:
                mien.read_face(word)
            self.assertIn(hint, str(caught.exception))

    def test_of_no_picture_are_refused_in_a_sentence(self):
        posed = mien.from_code(CODE).pose()
        for call, error, words in ((lambda: posed.save(self.folder / "a.gif"), mien.Error, "face.animate"),
                                   (lambda: posed.save(self.folder / "a.pgn"), mien.Error, 'did you mean "png"'),
                                   (lambda: posed.save(self.folder / "a"), mien.Error, "no format"),
                                   (lambda: posed.save(self.folder / "a.png", depth="u16"), mien.Error, "8, 16, 'half' or 'float'"),
                                   (lambda: posed.save(self.folder / "a.png", depth=[8]), mien.Error, "8, 16"),
                                   (lambda: posed.save(self.folder / "a.png", format=7), TypeError, "format"),
                                   (lambda: posed.save(io.StringIO()), TypeError, "takes bytes"), (lambda: posed.save(7), TypeError, "")):
            with self.assertRaisesRegex(error, words):
                call()
        self.assertEqual(os.listdir(self.folder), [])

    def test_are_arrays_and_pictures_of_pillow(self):
        posed = mien.from_code(CODE).pose()
        numpy.testing.assert_array_equal(numpy.asarray(posed), posed.render())
        self.assertEqual(numpy.asarray(mien.from_code(CODE), dtype=float).dtype, numpy.float64)
        try:
            from PIL import Image
        except ImportError:
            return
        self.assertEqual((posed.to_pil(40).size, posed.to_pil((40, 20)).mode), ((40, 40), "RGBA"))
        numpy.testing.assert_array_equal(numpy.asarray(posed.to_pil(40, background="white")), posed.render(40, background="#ffffff"))
        numpy.testing.assert_array_equal(numpy.asarray(Image.fromarray(posed.render(40))), posed.render(40))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
