"""Runs of the command that read and write files, one small one for each verb and kind of file."""
import dataclasses
import json
import pathlib
import subprocess

CODE = "A66CB-AA5S0-14"


@dataclasses.dataclass(frozen=True)
class Verb:
    name: str
    words: tuple        # IN: the folder of inputs; FACES: that of the sample faces; SOURCE: the tree
    files: tuple = ()   # what it writes, in the folder it runs in
    own_threads: bool = False  # another program does its work: only calls of the command's first thread fail
    slow: bool = False         # thousands of calls, all a library's as it is loaded: every 53rd is tried
    only_new: bool = False     # it refuses to replace a file
    warns: bool = False        # it warns when it succeeds

    def resolved(self, inputs, source):
        places = {"IN": str(inputs), "FACES": str(source / "faces"), "SOURCE": str(source)}
        return [replaced(word, places) for word in self.words]


def replaced(word, places):
    name, equals, path = word.rpartition("=")
    first, slash, rest = path.partition("/")
    return name + equals + places.get(first, first) + slash + rest


def verb(name, words, *files, **more):
    return Verb(name, tuple(words.split()), files, **more)


SMALL = "--size 24 --threads 1"
TOON = "FACES/compat/toon.face.json"
FRAMES = tuple(f"frames/{i}.png" for i in range(3))

VERBS = (
    verb("png-face", f"render {TOON} -o out.png {SMALL}", "out.png"),
    verb("png", f"render {CODE} -o out.png --size 48 --threads 1", "out.png"),
    verb("png-threads", f"render {TOON} -o out.png --size 400 --memory 4M --threads 2", "out.png"),
    verb("png-stdout", f"render {TOON} -o - {SMALL}"),
    verb("tiff", f"render {TOON} -o out.tif {SMALL}", "out.tif"),
    verb("svg", f"render {TOON} -o out.svg", "out.svg", warns=True),
    verb("error-map", f"render {TOON} -o out.png --error-map map.png {SMALL}", "out.png", "map.png"),
    verb("jpeg", f"render {TOON} -o out.jpg --background #ffffff {SMALL}", "out.jpg", slow=True),
    verb("exr", f"render {TOON} -o out.exr {SMALL}", "out.exr", slow=True),
    verb("motion", f"render {CODE} --motion SOURCE/examples/take/live_link.csv --time 0.1 -o out.png {SMALL}", "out.png"),
    verb("speech", f"render {CODE} --speech SOURCE/examples/talk/hello.TextGrid --time 0.4 -o out.png {SMALL}", "out.png"),
    verb("own-part", f"render SOURCE/examples/own_part/mina.face.json -o out.png {SMALL}", "out.png"),
    verb("text", f"render SOURCE/examples/lettered/ole.face.json -o out.png {SMALL}", "out.png"),
    verb("effect", f"render {TOON} --effect mosaic:6,1,mean -o out.png {SMALL}", "out.png"),
    verb("debug", f"render {TOON} --debug points -o out.png {SMALL}", "out.png"),
    verb("morphs", f"render {TOON} --morphs IN/morphs.json --morph smiling -o out.png {SMALL}", "out.png"),
    verb("basis", f"render {TOON} --basis IN/toon.basis --time 0.1 -o out.png {SMALL}", "out.png"),
    verb("check", f"check {TOON}"),
    verb("scene", f"scene {TOON}"),
    verb("list", f"list {TOON}"),
    verb("set", f"set {TOON} neck/points/0=0.166,-0.40 -o out.json", "out.json"),
    verb("new", "new --seed ada -o out.face.json", "out.face.json"),
    verb("new-flat", "new --seed ada --flat -o out.face.json", "out.face.json"),
    verb("code", "code IN/ada.face.json"),
    verb("parts", "parts glasses"),
    verb("parts-new", "parts new glasses mine -o mine.part.json", "mine.part.json", only_new=True),
    verb("import", "import facemotion SOURCE/tests/support/faces/facemotion_male.js -o out.json", "out.json"),
    verb("fit", "fit FACES/compat/bruno.face.json SOURCE/fuzz/lib/file/json/frame_file_corpus/arkit.json"),
    verb("morph-make", f"morph make {TOON} smiling=IN/other.json -o out.json", "out.json"),
    verb("morph-between", f"morph between {CODE} IN/ada.face.json --steps 2 --size 24 -o out.png", "out.png"),
    verb("morph-from-obj", f"morph from-obj {TOON} IN/map.json IN/rest.obj IN/wide.obj -o out.json", "out.json"),
    verb("mesh", "mesh IN/rest.obj IN/wide.obj -o out.png --size 16", "out.png"),
    verb("pca-fit", f"pca fit {TOON} --frames 0-4 --components 2 -o out.basis", "out.basis"),
    verb("pca-npy", "pca fit IN/frames.npy --components 2 -o out.basis", "out.basis"),
    verb("pca-info", "pca info IN/toon.basis --plot out.png", "out.png"),
    verb("pca-encode", f"pca encode IN/toon.basis {TOON} -o out.npy", "out.npy"),
    verb("pca-decode", "pca decode IN/toon.basis -o out.npy", "out.npy"),
    verb("pca-compare", f"pca compare IN/toon.basis {TOON} --frames 0-4 --face {TOON} --size 16 -o out.png", "out.png"),
    verb("pca-sheet", f"pca sheet IN/toon.basis --face {TOON} --size 16 -o out.png", "out.png"),
    verb("sheet", "sheet --people 2 --seed a --cell 24 -o out.png", "out.png"),
    verb("chernoff", "chernoff SOURCE/examples/chernoff/planets.csv --map SOURCE/examples/chernoff/planets.map.json "
         "--cell 24 -o out.png --legend legend.png --manifest out.csv", "out.png", "legend.png", "out.csv"),
    verb("stimuli", "stimuli IN/plan.json -o shown", "shown/0001.png", "shown/0002.png", "shown/manifest.json"),
    verb("frames", f"animate {TOON} --frames 0-2 -o frames/%d.png {SMALL}", *FRAMES),
    verb("gif", f"animate {TOON} --frames 0-2 -o out.gif {SMALL}", "out.gif"),
    verb("webp", f"animate {TOON} --frames 0-2 -o out.webp {SMALL}", "out.webp"),
    verb("apng", f"animate {TOON} --frames 0-2 -o out.apng {SMALL}", "out.apng"),
    verb("mp4", f"animate {TOON} --frames 0-2 -o out.mp4 --size 24x24 --threads 1", "out.mp4", own_threads=True),
    verb("mp4-sound", f"animate {TOON} --frames 0-2 --sound IN/beep.wav -o out.mp4 --size 24x24 --threads 1", "out.mp4", own_threads=True),
    verb("say", "say Hello -o out.tsv", "out.tsv", own_threads=True),
)


def made_inputs(mien, source, inputs):
    """Fills the folder of inputs. Some are made by the command itself."""
    inputs.mkdir(parents=True, exist_ok=True)

    def run(*words):
        subprocess.run([mien, *words], cwd=inputs, check=True, stdout=subprocess.DEVNULL, timeout=60)

    toon = str(source / "faces/compat/toon.face.json")
    run("new", "--seed", "ada", "-o", "ada.face.json")
    run("set", toon, "neck/points/0=0.166,-0.40", "-o", "other.json")
    run("morph", "make", toon, "smiling=other.json", "-o", "morphs.json")
    run("pca", "fit", toon, "--frames", "0-4", "--components", "2", "-o", "toon.basis")
    run("pca", "decode", "toon.basis", "-o", "frames.npy")
    for name, wide in (("rest", 1), ("wide", 2)):
        (inputs / f"{name}.obj").write_text(f"v 0 0 0\nv {wide} 0 0\nv 0 1 0\nv {wide} 1 0\nf 1 2 3\nf 2 4 3\n")
    (inputs / "map.json").write_text(json.dumps(
        {"format": "mien-map", "format_version": 1, "scale": 0.5, "points": {"neck/points/0": 1, "neck/points/1": [1, 2]}}))
    (inputs / "plan.json").write_text(json.dumps(
        {"format": "mien-stimuli", "format_version": 1, "size": 24, "factors": [{"people": 1}, {"emotion": "joy", "values": [0, 1]}]}))
    (inputs / "beep.wav").write_bytes(wave(bytes(range(0, 200, 2)) * 80))


def wave(samples):
    """A WAV file of 8 bits, one channel, 8 kHz."""
    number = lambda value, size: value.to_bytes(size, "little")
    head = b"fmt " + number(16, 4) + number(1, 2) + number(1, 2) + number(8000, 4) + number(8000, 4) + number(1, 2) + number(8, 2)
    data = b"data" + number(len(samples), 4) + samples
    return b"RIFF" + number(4 + len(head) + len(data), 4) + b"WAVE" + head + data
