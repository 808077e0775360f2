#!/usr/bin/env python3
"""The face with sliders, by a stand-in of anywidget's protocol: in Python, and in Chromium where there is one: widget_test.py SOURCE"""
import base64
import http.server
import importlib.util
import json
import pathlib
import queue
import shutil
import subprocess
import sys
import tempfile
import threading
import types
import unittest

MISSING = [name for name in ("numpy", "traitlets") if not importlib.util.find_spec(name)]
if MISSING:
    print(f"needs {', '.join('python3-' + name for name in MISSING)}: tools/setup --dev")
    sys.exit(77)

import numpy
import traitlets

import mien
from mien import _png

if not importlib.util.find_spec("anywidget"):
    sys.modules["anywidget"] = types.SimpleNamespace(AnyWidget=traitlets.HasTraits)
from mien import widget  # noqa: E402

ROOT = pathlib.Path(sys.argv.pop())
PERSON = mien.from_code("A66CB-AA5S0-14")
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
# A page that plays the notebook: a model of anywidget's, whose kernel answers with the picture of `answers` for the values.
PAGE = """<!doctype html><body><div id="el"></div><script type="module">
const widget = (await import('data:text/javascript;base64,MODULE')).default;
const bytes = (text) => text === null ? null : new DataView(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);
const state = STATE, answers = ANSWERS, heard = {}, told = [];
for (const key of ['_picture', '_wasm']) state[key] = bytes(state[key]);
const model = {
  get: (key) => state[key],
  set(key, value) { state[key] = value; (heard[`change:${key}`] ?? []).forEach((one) => one()); },
  save_changes() { const answer = answers[JSON.stringify(state.values)]; if (answer) this.set('_picture', bytes(answer)); },
  on: (event, one) => (heard[event] ??= []).push(one),
  off: (event, one) => { heard[event] = heard[event].filter((other) => other !== one); },
};
const el = document.getElementById('el');
const now = () => [...el.querySelector('canvas').getContext('2d').getImageData(X, Y, 1, 1).data];
/** The pixel once it is another one: a busy machine takes its time for a picture. */
const pixel = async (old) => { for (let i = 0; i < 500 && `${now()}` === `${old}`; ++i) await new Promise((done) => setTimeout(done, 20)); return now(); };
const clean = await widget.render({ model, el });
const before = now();
told.push(before, [...el.querySelectorAll('input')].map((one) => [one.min, one.max, one.value]), el.querySelector('canvas').getAttribute('aria-label'));
const slider = el.querySelectorAll('input')[1];
slider.value = 1, slider.dispatchEvent(new Event('input'));
told.push(await pixel(before), state.values);
model.set('values', {}), told.push(slider.value, el.querySelector('p').textContent);
clean(), told.push(Object.values(heard).flat().length);
await fetch('/told', { method: 'POST', body: JSON.stringify(told) });
</script>"""
PATIENCE = 120  # [s] of a busy machine


class Told(http.server.BaseHTTPRequestHandler):
    """Serves the page, and hears what it tells: real time passes meanwhile, which --dump-dom would not wait for."""
    def do_GET(self):
        self.send_response(200 if self.path == "/" else 404)
        self.send_header("Content-Type", "text/html; charset=utf-8")
        self.end_headers()
        self.wfile.write(self.server.page.encode() if self.path == "/" else b"")

    def do_POST(self):
        self.server.told.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()

    def log_message(self, *words):
        pass


class Kernel(unittest.TestCase):
    def test_draws_what_the_sliders_say(self):
        shown = widget.FaceWidget(PERSON, ["emotion.joy", "blink"], size=64, values={"blink": 0.5})
        self.assertEqual([(one["name"], one["lo"], one["hi"]) for one in shown.sliders], [("emotion.joy", 0, 1), ("blink", 0, 1)])
        numpy.testing.assert_array_equal(_png.pixels(shown._picture), PERSON.pose(blink=0.5).render(64))
        shown.values = {"blink": 1.0}
        self.assertEqual(shown.posed, PERSON.pose(blink=1))
        if not shown._wasm:
            numpy.testing.assert_array_equal(_png.pixels(shown._picture), PERSON.pose(blink=1).render(64))
        names = [one["name"] for one in widget.FaceWidget(PERSON, size=16).sliders]
        self.assertTrue({"emotion.joy", "yaw", "blink"} <= set(names) <= set(PERSON.names))
        self.assertTrue(pathlib.Path(shown._esm).is_file())

    def test_refuses_what_is_none(self):
        for call, error, words in ((lambda: widget.FaceWidget("ada"), TypeError, "expected a face"), (lambda: widget.FaceWidget(PERSON, "yaw"), TypeError, "a list"),
                                   (lambda: widget.FaceWidget(PERSON, ["yaww"]), mien.Error, 'did you mean "yaw"'), (lambda: widget.FaceWidget(PERSON, values={"yaww": 1}), mien.Error, "yaw")):
            with self.assertRaisesRegex(error, words):
                call()

    def test_says_what_it_needs(self):
        program = "import sys; sys.modules['anywidget'] = None; import mien; mien.widget"
        said = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertIn("ImportError: mien.widget needs anywidget: pip install anywidget", said.stderr)


@unittest.skipUnless(CHROMIUM, "needs chromium: tools/setup --web")
class Page(unittest.TestCase):
    def played(self, shown, answers):
        """What the page tells of a slider that is moved."""
        encoded = lambda raw: base64.b64encode(raw).decode()
        state = {name: getattr(shown, name) for name in ("values", "sliders", "label", "_text", "_modules")}
        state.update(size=list(shown.size), _picture=encoded(shown._picture), _wasm=encoded(shown._wasm) if shown._wasm else None)
        page = PAGE.replace("MODULE", encoded(pathlib.Path(shown._esm).read_bytes())).replace("STATE", json.dumps(state)) \
            .replace("ANSWERS", json.dumps(answers)).replace("X, Y", f"{self.x}, {self.y}")
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder, http.server.ThreadingHTTPServer(("127.0.0.1", 0), Told) as server:
            server.page, server.told = page, queue.Queue()
            threading.Thread(target=server.serve_forever, daemon=True).start()
            with subprocess.Popen([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                                   f"http://127.0.0.1:{server.server_port}/"], stderr=subprocess.DEVNULL) as browser:
                try:
                    return server.told.get(timeout=PATIENCE)
                finally:
                    browser.terminate()
                    server.shutdown()

    def test_moves_the_face(self):
        open_eyes, shut = PERSON.render(64), PERSON.pose(blink=1).render(64)
        self.y, self.x = (int(one[0]) for one in numpy.nonzero(numpy.abs(open_eyes.astype(int) - shut).sum(2) > 150))
        shown = widget.FaceWidget(PERSON, ["emotion.joy", "blink"], size=64)
        at_rest, sliders, label, moved, values, back, refused, listeners = self.played(
            shown, {'{"blink":1}': base64.b64encode(_png.png(shut)).decode()})
        self.assertEqual((at_rest, moved), (open_eyes[self.y, self.x].tolist(), shut[self.y, self.x].tolist()))
        self.assertEqual((sliders, values, back, label), ([["0", "1", "0"]] * 2, {"blink": 1}, "0", PERSON.title))
        self.assertEqual((refused, listeners), ("", 0))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
